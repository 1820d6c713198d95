#!/usr/bin/env python3
"""Bullet and ODE, where their programs are built, keep the ranking and the order of magnitude that they have been
measured to have: a ball, a gas, a cradle. Their traces are audited, and Bullet as it comes misses a plate.

Usage: peers.py CAROM TOOLS_PEERS_COMPARE TRACES. Exit 77: none is built."""
import csv
import importlib.machinery
import importlib.util
import json
import math
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

CAROM, COMPARE, TRACES = os.path.abspath(sys.argv[1]), sys.argv[2], pathlib.Path(sys.argv[3])
loader = importlib.machinery.SourceFileLoader("compare", COMPARE)
sys.dont_write_bytecode = True
compare = importlib.util.module_from_spec(importlib.util.spec_from_loader("compare", loader))
loader.exec_module(compare)

BALL = {"format": "carom-scene/1", "gravity": [0, 0, -9.81], "end_time": 10,
        "spheres": [{"id": "ball", "radius": 0.1, "position": [0, 0, 1.1]}],
        "planes": [{"id": "floor", "normal": [0, 0, 1], "offset": 0}]}

problems = []


def expect(what, value, low, high):
    print(f"{what}: {value:.3g}, expected {low:g} to {high:g}")
    if not low <= value <= high:
        problems.append(what)


def worst_height(peer, scene, dt, rate, *more):
    """Largest error of height in 10 s of a ball that bounces 1 m high, e = 1, against the closed form."""
    program = [str(pathlib.Path(CAROM).parent / f"carom_peer_{peer}"), scene, "--dt", dt, "--frames", rate, *more]
    trace = subprocess.run(program, capture_output=True, text=True, check=True).stdout
    half, worst = math.sqrt(2 / 9.81), 0
    for row in csv.reader(line for line in trace.splitlines() if not line.startswith("#")):
        if row[0] == "t":
            continue
        s = (float(row[0]) + half) % (2 * half) - half
        worst = max(worst, abs(float(row[4]) - 1.1 + 9.81 * s * s / 2))
    return worst


def compared(scene, methods, steps, *more):
    """Rows of `carom compare` by method and step."""
    with tempfile.TemporaryDirectory() as work:
        done = subprocess.run([CAROM, "compare", scene, "--methods", ",".join(methods), "--dt", steps, "--repeats", "1",
                               "--json", "-q", "-o", work, *more], capture_output=True, text=True, check=True)
    return {(row["method"], round(row["dt"] or 0, 9)): row for row in json.loads(done.stdout)["rows"]}


def rows_of_compare(peers):
    """The same ranking and orders of magnitude as rows of `carom compare`."""
    with tempfile.TemporaryDirectory() as work:
        ball = os.path.join(work, "ball.json")
        pathlib.Path(ball).write_text(json.dumps(BALL))
        rows = compared(ball, ["event", *peers], "1/60,1e-4")
    for peer in peers:
        expect(f"compare, ball, {peer}, 1e-4", rows[peer, 1e-4]["position_max"], 6e-4, 6e-2)
        expect(f"compare, ball, {peer}, 1/60", rows[peer, round(1 / 60, 9)]["position_max"], 0.1, 1)
    rows = compared("gas_1000", ["event", *peers], "1/60,1/960", "--until", "1")
    for peer in peers:
        coarse, fine = rows[peer, round(1 / 60, 9)], rows[peer, round(1 / 960, 9)]
        expect(f"compare, gas, {peer}, 1/60: RMS error at t = 1", coarse["position_final_rms"], 0.2, 0.8)
        expect(f"compare, gas, {peer}, 1/960: RMS error at t = 1", fine["position_final_rms"], 0.05, 0.25)
        expect(f"compare, gas, {peer}, 1/960: energy", fine["energy_error"], 0, 1e-4)
        expect(f"compare, gas, {peer}: event is exact beside it", rows["event", 0]["position_final_rms"], 0, 1e-9)
    names = [name for name in ("ode", "ode_defaults", "bullet", "bullet_defaults") if name.split("_")[0] in peers]
    rows = compared("cradle", names, "1/960")
    for name in names:
        low, high = (0.3, 3) if name == "bullet_defaults" else (0, 1e-6)
        expect(f"compare, cradle, {name}: energy", rows[name, round(1 / 960, 9)]["energy_error"], low, high)


def rows_of_tunnel(peers):
    """ODE looks once a step: its shares are those of one chord. Walls are missed by nobody."""
    done = subprocess.run([CAROM, "tunnel", "--methods", ",".join(peers), "--thickness", "0.02", "--radius", "0.1", "--dt",
                           "1/240", "--speed", "10,100,1000", "--trials", "400", "--json", "-q"],
                          capture_output=True, text=True, check=True)
    for row in json.loads(done.stdout)["rows"]:
        name = f"tunnel, {row['method']} at a {row['target']}, {row['speed']:g} m/s"
        seen = 1 / row["number"]
        law = {"plate": max(0, 1 - seen), "sphere": 1 - 2 * seen / 3 if seen <= 1 else 1 / (3 * seen * seen),
               "wall": 0}[row["target"]]
        wide = 4 * math.sqrt(law * (1 - law) / row["trials"])
        if row["method"] == "ode":
            expect(name, row["share"], law - wide, law + wide)
        if row["target"] == "wall":
            expect(name, row["tunnelled"], 0, 0)


def kinds_of_targets(peers):
    """A plane, a box wall, a plate and a fixed sphere are hit by each: errors fall to those of a step."""
    kinds = {"plane": {"planes": [{"id": "p", "normal": [-1, 0, 0], "offset": -1}]},
             "box": {"box": {"min": [-9, -9, -9], "max": [1, 9, 9]}},
             "plate": {"planes": [{"id": "p", "normal": [1, 0, 0], "offset": 1.01, "thickness": 0.02}]},
             "fixed": {"spheres": [{"id": "f", "radius": 0.5, "position": [1.5, 0, 0], "fixed": True}]}}
    with tempfile.TemporaryDirectory() as work:
        for kind, bodies in kinds.items():
            ball = {"id": "ball", "radius": 0.1, "position": [0, 0, 0], "velocity": [0.97, 0, 0]}
            scene = os.path.join(work, f"{kind}.json")
            pathlib.Path(scene).write_text(json.dumps({"format": "carom-scene/1", "end_time": 1.5, **bodies,
                                                       "spheres": [ball, *bodies.get("spheres", [])]}))
            rows = compared(scene, ["event", *peers], "1e-3")
            for peer in peers:
                expect(f"{kind}, {peer}", rows[peer, 1e-3]["position_max"], 0, 2 * 0.97 * 1e-3)


def children_of(process):
    return pathlib.Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text().split()


def interrupted(peers):
    """SIGINT while a peer steps: exit 130, and its program is gone."""
    with tempfile.TemporaryDirectory() as work:
        process = subprocess.Popen([CAROM, "compare", "gas_1000", "--methods", peers[0], "--dt", "1e-6", "--until", "1",
                                    "-q", "-o", work], stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        while process.poll() is None and not children_of(process):
            time.sleep(0.05)
        child = children_of(process)[0]
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=60)
    expect("compare interrupted: exit code", process.returncode, 130, 130)
    expect("compare interrupted: programs left", int(pathlib.Path(f"/proc/{child}").exists()), 0, 0)


def main():
    peers = compare.built(CAROM)
    if not peers:
        print("no peer is built: skipped")
        return 77
    with tempfile.TemporaryDirectory() as work:
        ball = os.path.join(work, "ball.json")
        pathlib.Path(ball).write_text(json.dumps(BALL))
        for peer in peers:
            expect(f"ball, {peer}, 1e-4", worst_height(peer, ball, "1/10000", "200"), 6e-4, 6e-2)
            expect(f"ball, {peer}, 1/60", worst_height(peer, ball, "1/60", "60"), 0.1, 1)
        if "bullet" in peers:
            expect("ball, bullet as it comes, 1e-4", worst_height("bullet", ball, "1/10000", "200", "--defaults"), 0.5, 2)
    for row in compare.rows(CAROM, "gas_1000", [1 / 60, 1 / 960], peers, 60, 1):
        if row["dt"] is None:
            continue
        coarse = row["dt"] > 0.01
        expect(f"gas, {row['engine']}, dt {row['dt']:.3g}: RMS error at t = 1", row["position_rms"],
               *((0.2, 0.8) if coarse else (0.05, 0.25)))
        expect(f"gas, {row['engine']}, dt {row['dt']:.3g}: relative energy", abs(row["energy_change"]), 0, 1e-4)
        expect(f"gas, {row['engine']}, dt {row['dt']:.3g}: touches", row["touches"], 1000, 1500)
        expect(f"gas, {row['engine']}, dt {row['dt']:.3g}: late", row["late"], 800, 1500)
    for row in compare.rows(CAROM, "cradle", [1 / 960], peers, 60, None, (False, True)):
        name = f"cradle, {row['engine']}{' as it comes' if row['defaults'] else ''}"
        if row["engine"] == "ode" or (row["engine"] == "bullet" and not row["defaults"]):
            expect(f"{name}: relative energy", abs(row["energy_change"]), 0, 1e-6)
        elif row["engine"] == "bullet":
            expect(f"{name}: relative energy", row["energy_change"], 0.3, 3)
    if "bullet" in peers:
        scene = str(TRACES / "thin_plate.json")
        as_it_comes = compare.rows(CAROM, scene, [1 / 240], ["bullet"], 240, None, (True,))[1]
        expect("plate, bullet as it comes: missed", as_it_comes["missed"], 1, 1)
    rows_of_compare(peers)
    rows_of_tunnel(peers)
    kinds_of_targets(peers)
    interrupted(peers)
    for problem in problems:
        print("not as measured before:", problem)
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
