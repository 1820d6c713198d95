#!/usr/bin/env python3
"""Digits that scenes/stress expects, from mpmath with 60 digits, and the scenes that are made of them.

Usage: stress_digits.py SCENE_DIR [--write]     Without --write it says which files differ (exit 1). Exit 77: no mpmath.

What a scene expects follows from the doubles that the scene itself says, never from a run of carom: unfolding of walls,
free points on a line, sums of geometric series, the pair law one impact after the other (stress_scenes/). Scenes that
are older than this script have their digits held against long double in tests/unit/study/test_stress.cpp; their
variations are written here.
"""
import json
import pathlib
import sys

try:
    from mpmath import mpf
except ImportError:
    sys.exit(77)

sys.dont_write_bytecode = True  # a test leaves the tree as it is

from stress_scenes import bouncing, clusters, piles, rows, unfolding
from stress_scenes.files import layout


def build(folder):
    """{file name: document} of all that this script answers for."""
    made = {}
    read = lambda name: json.loads((folder / f"{name}.json").read_text())
    def varied(name, members):
        document = read(name)
        document["stress"]["members"] = members
        made[name] = document
    varied("pi_by_impacts", unfolding.pi_members())
    varied("narrow_wedge_10", unfolding.wedge_members())
    varied("grazing_touch", [unfolding.grazing_member("within 1e-15", 0.25 * (1 - 2.0 ** -50), True)])
    varied("grazing_pass", [unfolding.grazing_member("within 1e-15", 0.25 * (1 + 2.0 ** -50), False)])
    for e in ("0.5", "0.9", "1"):
        varied(f"between_heavy_{e}", rows.between_members(e, (1e4, 1e8)))
    made["between_heavy_0.5"]["stress"]["members"] += rows.between_members("0", (1e4, 1e8, 1e12), e_is_new=True)
    made["zeno"] = bouncing.zeno_family()
    made["bounce_on_sphere"] = bouncing.bounce_on_sphere()
    made["slot_1e-9"] = unfolding.in_slot()
    made["gate_1e-9"] = unfolding.gate()
    made["long_run"] = rows.long_run()
    made["cradle_of_five"] = rows.cradle()
    made["chain_121"] = rows.chain()
    made["cluster_turned"] = clusters.bernoulli()
    made["heavy_on_light"] = rows.heavy_on_light()
    made["collapse_wall"] = rows.collapse()
    made["speed_sweep"] = unfolding.sweep("Speeds of 0.1 to 1000 radii a step", 1000, (0.1, 0.5, 1, 3, 10, 100, 1000), True)
    made["speed_sweep_fast"] = unfolding.sweep("Speeds of 1e4 to 1e6 radii a step", 1e6, (1e4, 1e5, 1e6), False)
    made["penalty_stiffness"] = unfolding.penalty()
    made["heavy_top"] = piles.heavy_top()
    made["rack_mirrored"] = clusters.rack()
    made["off_axis_1e-3"] = piles.tower_off_axis(
        "Tower off its axis by 1e-3 r", "A sphere on a sphere on a smooth floor, off the axis by a thousandth of a radius: on the way to ten times as much the linear law holds, cosh(t sqrt(g/r)).",
        mpf(1) / 1024, 10, {"case": "leaning", "dt": 0.001, "exact": 0.01})
    made["off_axis_1e-9"] = piles.tower_off_axis(
        "Tower off its axis by 1e-9 r", "A sphere on a sphere on a smooth floor, off the axis by a billionth of a radius: it should fall, and stands, for accelerations below 1e-9 g count as none.",
        mpf(2) ** -30, 100, {"case": "leaning_least", "dt": 0.001, "exact": 0.01, "title": "Tower off its axis by 1e-9 r",
                             "figure": "largest error of a sphere's way, as part of the way by the linear law",
                             "step": "1/158 of the time in which the way grows e-fold",
                             "causes": {"late": "what responses change at each step is as large as the way itself, or larger",
                                        "sank": "overlaps are left as they are"},
                             "waits_for": "forces that are not cut off at 1e-9 of gravity"})
    far = 2.0 ** 54
    made["far_shuttle"] = unfolding.shuttle_scene(
        "Origin beyond 2^53 cells", "A ball goes to and fro between two walls, 12 impacts; the same run with its origin 2^54 m away, where doubles come in steps of 4 m, 16 radii.",
        [{"type": "moved_origin", "value": [far, -far, far], "abs": 0}], {"case": "far_origin", "dt": 1 / 240, "exact": 0})
    made["late_shuttle"] = unfolding.shuttle_scene(
        "Start time 2^40 s, impacts", "A ball goes to and fro between two walls, 12 impacts; the same at 2^40 s.",
        [{"type": "later", "time": 2.0 ** 40, "abs": 0}], {"case": "start_time", "dt": 1 / 240, "exact": 0})
    made["settle_in_box"] = piles.heap()
    made["packing_pressure"] = piles.packing_pressure()
    for share, name in (("0.70", "packing_70"), ("0.72", "packing_72"), ("0.74", "packing_74")):
        made[name] = piles.packing(share, 1)[1]
    made["packing_70"]["stress"] |= piles.PACKING_WORDS
    return made


def main():
    folder = pathlib.Path(sys.argv[1]) / "stress"
    wrong = []
    for name, document in build(folder).items():
        text = layout(document) + "\n"
        file = folder / f"{name}.json"
        if "--write" in sys.argv:
            file.write_text(text)
        elif not file.exists() or json.loads(file.read_text()) != document:
            wrong.append(name)
    if wrong:
        print("other digits than computed: " + ", ".join(wrong))
        sys.exit(1)


if __name__ == "__main__":
    main()
