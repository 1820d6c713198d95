#!/usr/bin/env python3
"""carom's methods pbd and velocity are the two loops of a course handout (handout_loops.py), sphere by sphere, on the scenes in handout/.

Usage: handout_loops_agree.py CAROM [--mutate RULE]

A line for each scene and method: the largest difference of a position or velocity after 192 steps of 1/240, and beside it what rounding
makes of the scene, which is how far the loops are from themselves in 80 digits. Where carom disagrees, the first step and the spheres
follow. Then the script examines itself: loops with one rule changed (handout_mutants.py) must leave the true ones on some scene. With
--mutate carom is held against the loops with that rule changed. Exit 1 where something disagrees. Uses nothing but the standard library."""
import argparse
import decimal
import json
import pathlib
import subprocess
import sys

sys.dont_write_bytecode = True  # a test leaves nothing in the source tree
import handout_loops  # noqa: E402
import handout_mutants  # noqa: E402

SCENES = sorted((pathlib.Path(__file__).resolve().parent / "handout").glob("*.json"))
STEPS, STEPS_A_UNIT = 192, 240  # so many, and so many in a unit of time
# Difference [length, length/time, of scenes of size 1] up to which carom and the loops are the same: they round in different orders.
TOLERANCE = 1e-12
# Difference [as above] that rounding may make of a scene, so that TOLERANCE is about rules: a fourth of it.
MOST_ROUNDING = TOLERANCE / 4
# Difference [as above] by which a changed rule must show: a million times what passes.
SHOWN = 1e-6
# Digits of the second precision: more than a double of the scenes has, so that it is taken as it is.
DIGITS = 80


def carom_states(carom, scene, method, steps):
    args = [carom, "run", str(scene), "--method", method, "--dt", f"1/{STEPS_A_UNIT}", "--until", f"{steps}/{STEPS_A_UNIT}", "--json", "--final"]
    done = subprocess.run(args, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"exit {done.returncode}: {' '.join(args)}\n{done.stderr}")
    run = json.loads(done.stdout)
    if run["status"] != "reached_end" or run["counts"]["steps"] != steps:
        sys.exit(f"{run['status']} after {run['counts']['steps']} steps, not {steps}: {' '.join(args)}")
    return run["final"]


def apart(one, other):
    """The largest difference of two states of a sphere; infinite where one is no number."""
    assert one["id"] == other["id"], f"{one['id']} is not {other['id']}"
    differences = [abs(a - b) for key in ("position", "velocity") for a, b in zip(one[key], other[key])]
    return max(d if d == d else float("inf") for d in differences)


def largest(ones, others):
    assert len(ones) == len(others), f"{len(ones)} spheres, not {len(others)}"
    return max(apart(one, other) for one, other in zip(ones, others))


def tell_first_step(carom, path, method, loops):
    scene = json.loads(path.read_text())
    for steps in range(1, STEPS + 1):
        pairs = list(zip(carom_states(carom, path, method, steps), loops.run(scene, method, steps, 1 / STEPS_A_UNIT)))
        wrong = [(one, other) for one, other in pairs if not apart(one, other) <= TOLERANCE]
        if not wrong:
            continue
        print(f"  differs first after step {steps}:")
        for one, other in wrong:
            for key in ("position", "velocity"):
                print(f"    {one['id']}, {key}: carom {one[key]}, handout {other[key]}")
        return


def compare(carom, loops, truth):
    """Whether carom agrees with the loops on every scene. truth holds, and is given, the loops' final states by scene and method."""
    agrees = True
    for path in SCENES:
        scene = json.loads(path.read_text())
        for method in loops.LOOPS:
            states = truth[path, method] = loops.run(scene, method, STEPS, 1 / STEPS_A_UNIT)
            difference = largest(carom_states(carom, path, method, STEPS), states)
            rounding = largest(loops.run(scene, method, STEPS, 1 / STEPS_A_UNIT, decimal.Decimal), states)
            good = difference <= TOLERANCE
            verdict = "agrees" if good else "DISAGREES"
            print(f"{path.stem:13} {method:8}  largest difference {difference:.1e}   by rounding {rounding:.1e}   {verdict}", flush=True)
            if not good:
                tell_first_step(carom, path, method, loops)
            if not rounding <= MOST_ROUNDING:
                print(f"  the scene says nothing: rounding alone makes more than {MOST_ROUNDING:.1e}")
            agrees = agrees and good and rounding <= MOST_ROUNDING
    return agrees


def examine_itself(truth):
    """Whether every changed rule shows."""
    shown = True
    for name, (methods, _, _) in handout_mutants.MUTANTS.items():
        loops = handout_mutants.mutant(name)
        for method in methods:
            found = {}
            for path in SCENES:
                found[path.stem] = largest(loops.run(json.loads(path.read_text()), method, STEPS, 1 / STEPS_A_UNIT), truth[path, method])
            scenes = [scene for scene, difference in found.items() if difference > SHOWN]
            print(f"changed rule {name:30} {method:8}  {max(found.values()):.1e}   {', '.join(scenes) or 'NOT SHOWN'}")
            shown = shown and bool(scenes)
    return shown


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("carom")
    parser.add_argument("--mutate", choices=handout_mutants.MUTANTS)
    given = parser.parse_args()
    decimal.getcontext().prec = DIGITS
    truth = {}
    if given.mutate:
        return 0 if compare(given.carom, handout_mutants.mutant(given.mutate), truth) else 1
    agrees = compare(given.carom, handout_loops, truth)
    return 0 if examine_itself(truth) and agrees else 1


if __name__ == "__main__":
    sys.exit(main())
