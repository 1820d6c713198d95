"""Several contacts at one instant, away from a line."""
from mpmath import mpf, sqrt

from .files import ball, member, scene, state


# Bernoulli's problem: an elastic ball hits two that touch, in their middle; both impulses are 3/5 of what one would be.

def bernoulli():
    r = 0.125
    def states(speed, e, turn=None, boost=(0, 0, 0), order=(0, 1, 2)):
        # All closing speeds are equal: e times the elastic answer and 1 - e of the inelastic one is exact here.
        end, way = mpf(1), mpf("0.25")
        after = [[mpf(-1) / 5, 0, 0], [mpf(3) / 5, sqrt(mpf(12)) / 10, 0], [mpf(3) / 5, -sqrt(mpf(12)) / 10, 0]]
        still = [[mpf(2) / 5, 0, 0], [mpf(3) / 10, sqrt(mpf(3)) / 10, 0], [mpf(3) / 10, -sqrt(mpf(3)) / 10, 0]]
        reach = 2 * mpf(r) * sqrt(mpf(3)) / 2
        begin = [[-reach - way, 0, 0], [0, mpf(r), 0], [0, -mpf(r), 0]]
        ends, speeds, starts = [], [], []
        for i in range(3):
            v = [e * a + (1 - e) * b for a, b in zip(after[i], still[i])]
            meet = [begin[i][0] + (way if i == 0 else 0), begin[i][1], 0]
            first = [1 if i == 0 else 0, 0, 0]
            ends.append([m + w * (end - way) for m, w in zip(meet, v)])
            speeds.append(v)
            starts.append((begin[i], first))
        spin = (lambda p: [mpf(3) / 5 * p[0] - mpf(4) / 5 * p[1], mpf(4) / 5 * p[0] + mpf(3) / 5 * p[1], p[2]]) if turn else (lambda p: p)
        add = lambda p, q, s=1: [mpf(x) + s * mpf(y) for x, y in zip(p, q)]
        out = [(spin(starts[i][0]), add(spin(starts[i][1]), boost), add(spin(ends[i]), boost, end), add(spin(speeds[i]), boost)) for i in range(3)]
        return [out[i] for i in order]
    names = ["first", "second", "third"]
    base_states = states(1, mpf(1))
    checks = []
    for k in range(3):
        checks += state(names[k], base_states[k][2], base_states[k][3], 1.25e-13, 1e-12)
    base = scene("Bernoulli's problem, turned, renumbered, moving",
                 "A ball hits two that touch, in their middle, elastic (Bernoulli): it comes back at 1/5 of its speed, they leave at 30 degrees with 6/5 cos 30. The same cluster turned by 53.13 degrees, in another order, seen from a train, and with e = 1/2 and 0.",
                 1, [ball(names[k], r, [float(x) for x in base_states[k][0]], [float(x) for x in base_states[k][1]]) for k in range(3)], checks,
                 {"case": "cluster", "dt": 0.000125, "exact": 1e-12, "title": "One cluster turned, renumbered, moving",
                  "figure": "largest error of final positions in radii and of final velocities, against the closed form",
                  "step": "1/1000 of the time in which the incoming ball moves by its radius",
                  "causes": {"late": "the two contacts are answered one after the other: the ball is turned aside, to a side that depends on numbers",
                             "sank": "the two contacts are answered one after the other, each with the overlap that the other left"}})
    def changes(now, e=None):
        all = {} if e is None else {"/materials/ideal/restitution": e}
        for k in range(3):
            all |= {f"/spheres/{k}/position": [float(x) for x in now[k][0]], f"/spheres/{k}/velocity": [float(x) for x in now[k][1]],
                    f"/checks/{2 * k}/value": now[k][2], f"/checks/{2 * k + 1}/value": now[k][3]}
        return all
    base["stress"]["members"] = [
        member("turned", changes(states(1, mpf(1), turn=True))),
        member("renumbered", changes(states(1, mpf(1), order=(2, 0, 1)))),
        member("moving", changes(states(1, mpf(1), boost=(3, -2, 0.5)))),
        member("e = 0.5, turned and moving", changes(states(1, mpf("0.5"), turn=True, boost=(-7, 11, 1)), 0.5)),
        member("e = 0", changes(states(1, mpf(0)), 0))]
    return base


# Rack of 15: what mirrors the start mirrors the end.

def rack():
    r = 0.125
    spheres = [ball("cue", r, [-1, 0, 0], [2, 0, 0], color="#d1495b")]
    step = float(2 * mpf(r) * sqrt(mpf(3)) / 2)
    number = 0
    for row in range(5):
        for k in range(row + 1):
            spheres.append(ball(f"b{number}", r, [row * step, (2 * k - row) * r, 0]))
            number += 1
    return scene("Rack of 15", "A cue ball hits a rack of fifteen that touch, on its axis, elastic: what happens on one side of the axis happens on the other, and momentum and energy are kept.",
                 2, spheres, [{"type": "mirrored", "value": [0, 1, 0], "abs": 1e-9}, {"type": "momentum", "rel": 1e-12}, {"type": "energy", "rel": 1e-12},
                              {"type": "no_overlap"}],
                 {"case": "rack", "dt": 0.0000625, "exact": 1, "limit": 1, "title": "Rack of fifteen",
                  "figure": "largest error in units of its tolerance: of symmetry 1e-9, of momentum and energy 1e-12, of overlaps 1e-9 radii",
                  "step": "1/1000 of the time in which the cue ball moves by its radius",
                  "causes": {"late": "contacts are answered one after the other, and one side of the rack comes before the other",
                             "sank": "contacts are answered once a step, and the rack closes in on itself"}})
