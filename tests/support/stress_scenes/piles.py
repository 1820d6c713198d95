"""Many balls at rest or nearly: towers, packings, a heap."""
import random

from mpmath import acosh, cosh, mpf, pi, sqrt

from .files import ball, member, plain, scene


# Towers with heavy tops: at rest all is said.

def heavy_top():
    r, count = 0.125, 10
    spheres = [ball(f"b{k}", r, [0, 0, (2 * k + 1) * r], mass=10.0 ** k, material="body") for k in range(count)]
    checks = [{"type": "final_position", "body": f"b{k}", "value": [0, 0, (2 * k + 1) * r], "abs": 1.25e-10} for k in range(count)]
    checks += [{"type": "event_count", "count": 0}, {"type": "event_count", "kind": "release", "count": 0}]
    base = scene("Tower with a heavy top", "Ten balls on each other, each ten times as heavy as the one below it, stand for 1000 s: nothing moves, and nothing happens. In the variations the top alone is 1e12 kg, and the masses fall.",
                 1000, spheres, checks,
                 {"case": "heavy_top", "dt": 1 / 60, "exact": 1e-9, "title": "Towers with heavy tops",
                  "figure": "largest distance of a ball from its place, in radii; an event is an error of 1",
                  "step": "1/60 s",
                  "causes": {"invented": "every step lets the balls fall and answers as if they had hit each other",
                             "late": "contacts are visited one after the other: a heavy ball on a light one is pressed into it a little at every step",
                             "sank": "a heavy ball on a light one is pressed into it a little more at every step"}},
                 gravity=[0, 0, -8], materials={"body": {"restitution": 0.5, "color": "#00798c"}},
                 planes=[{"id": "floor", "normal": [0, 0, 1], "offset": 0, "material": "body"}])
    base["stress"]["members"] = [
        member("1e12 kg on nine of 1 kg", {f"/spheres/{k}/mass": 1e12 if k == count - 1 else 1 for k in range(count)}),
        member("heaviest below", {f"/spheres/{k}/mass": 10.0 ** (count - 1 - k) for k in range(count)})]
    return base


# Packings: each ball stays in its cage.

def packing(share, seed):
    d = 1.0
    close = sqrt(mpf(2)) * pi / 6
    room = (close / mpf(share)) ** (mpf(1) / 3)  # distance of neighbours, in diameters
    a = sqrt(mpf(2)) * room
    chance = random.Random(seed)
    spheres, checks = [], [{"type": "no_overlap", "abs": 1e-9}, {"type": "energy", "rel": 1e-11}]
    n = 0
    for i in range(5):
        for j in range(5):
            for k in range(5):
                if (i + j + k) % 2:
                    continue
                place = [float(room / 2 + a * x / 2) for x in (i, j, k)]
                v = [chance.gauss(0, 1) for _ in range(3)]
                spheres.append(ball(f"b{n}", d / 2, place, v))
                checks.append({"type": "final_position", "body": f"b{n}", "value": place, "abs": 0.5})
                n += 1
    side = float(room + 2 * a)
    return n, scene(f"Packing of {share}",
                    f"{n} elastic balls on a face-centred lattice that fills {share} of space where it goes on (0.7405 is the densest), between six walls: each stays in its cage, nothing overlaps, and energy is kept.",
                    0.25, spheres, checks,
                    {"case": "packing", "dt": 0.0005, "exact": 1, "limit": 1},
                    box={"min": [0, 0, 0], "max": [side, side, side], "material": "ideal"})


PACKING_WORDS = {"title": "Packings of 0.70 to 0.74",
                 "figure": "largest error in units of its tolerance: of energy 1e-11, of overlaps 1e-9 m, of a ball's distance from its site half a diameter",
                 "step": "1/2000 of the time in which a ball moves by its diameter",
                 "causes": {"late": "overlaps are put right pair by pair, and each correction makes others", "energy": "overlaps are put right without their energy",
                            "sank": "a ball is pressed into its neighbours from all sides"}}


# Towers off their axis: on a smooth floor d'' = 2 g d / (r + r) for the distance d of the two axes, while it is small.

def tower_off_axis(name, description, share, growth, stress):
    r, g = 0.25, 10.0
    rate = sqrt(2 * mpf(g) / (2 * r))
    end = float(acosh(mpf(growth)) / rate)
    start = float(share * r)
    height = lambda d: mpf(r) + sqrt((2 * mpf(r)) ** 2 - d * d)
    way = mpf(start) * cosh(rate * mpf(end)) / 2
    middle = mpf(start) / 2
    # The axis through both moves with neither: their centre of mass stays, and the upper one sinks.
    checks = [{"type": "final_position", "body": id, "value": [middle + side * way, 0, z], "abs": 0.01 * way}
              for id, side, z in (("upper", 1, height(2 * way)), ("lower", -1, r))]
    return scene(name, description, end,
                 [ball("lower", r, [0, 0, r], material="ice"), ball("upper", r, [start, 0, float(height(mpf(start)))], material="ice")],
                 checks, stress, gravity=[0, 0, -g], materials={"ice": {"restitution": 0.5, "color": "#8ecae6"}},
                 planes=[{"id": "floor", "normal": [0, 0, 1], "offset": 0, "material": "ice"}])


# Pressure of a packing: 3/a + 2.566 + 0.55 a - 1.19 a^2 + 5.95 a^3 with a = V/V0 - 1 (Alder, Hoover, Young 1968).

def packing_pressure():
    share, end = "0.72", 2.0
    n, document = packing(share, 1)
    a = sqrt(mpf(2)) * pi / 6 / mpf(share) - 1
    z = 3 / a + mpf("2.566") + mpf("0.55") * a - mpf("1.19") * a ** 2 + mpf("5.95") * a ** 3
    temperature = sum(mpf(v) ** 2 for each in document["spheres"] for v in each["velocity"]) / (3 * n)
    impacts = n * mpf(end) * (z - 1) * 3 / sqrt(pi) * sqrt(temperature)
    document["name"] = "Pressure of a packing of 0.72"
    document["description"] = ("Spheres on a face-centred lattice that goes on for ever have so many impacts as their pressure says, which is known (Alder, Hoover, Young 1968): "
                               f"PV/NkT = {float(z):.1f}. Between walls, as long as there are no periodic ones, the outer ones have others.")
    document["end_time"] = end
    document["checks"] = plain([{"type": "event_count", "count": int(impacts), "rel": 0.01}])
    document["stress"] = {"case": "packing_pressure", "dt": 0.0005, "exact": 0.01, "limit": 0.01, "title": "Pressure of a packing",
                          "figure": "difference of the number of impacts from the one that the pressure asks for, relative",
                          "step": "1/2000 of the time in which a ball moves by its diameter",
                          "causes": {"missed": "a step has room for an impact of a pair, and there are several"},
                          "waits_for": "periodic walls"}
    return document


# A heap: what loses energy at every impact, without friction, ends at rest.

def heap():
    count = 30
    checks = [{"type": "no_overlap"}, {"type": "momentum", "abs": 1e-9}]
    checks += [{"type": "final_velocity", "body": f"ball/{k}", "value": [0, 0, 0], "abs": 1e-9} for k in range(count)]
    document = scene("Heap that comes to rest",
                     "Thirty balls fall into a box, e = 1/2: every impact takes energy, and at the end all of them lie still. Where they lie is chaos.",
                     10, [], checks,
                     {"case": "heap", "dt": 1 / 240, "exact": 1, "limit": 1e6, "title": "Heap that comes to rest",
                      "figure": "largest speed that is left, in 1e-9 m/s; overlaps in 1e-9 of a radius count as well",
                      "step": "1/240 s; a discrete method may be left with 1 mm/s",
                      "causes": {"late": "every step lets the balls fall and answers as if they had hit each other: the heap trembles",
                                 "sank": "the balls above press those below into each other"},
                      "waits_for": "heaps that settle in windows"},
                     gravity=[0, 0, -10], materials={"body": {"restitution": 0.5, "color": "#00798c"}},
                     box={"min": [0, 0, 0], "max": [0.8, 0.8, 2], "material": "body"},
                     fill=[{"id": "ball", "pattern": "random", "count": count, "radius": 0.1, "material": "body"}])
    del document["spheres"]
    return document
