"""Balls on a line: rows, chains, cradles, and what is squeezed."""
import random

from mpmath import atan2, cos, floor, hypot, mpf, pi, sin, sqrt, tan

from .files import applied, ball, member, scene, state


# Three balls in a row: pair by pair at e = 1, all together at e = 0.

def row_of_three(mass, e):
    """Velocities of a ball of 1 between two of `mass` that touch it, of which the first comes in at 1."""
    m, v = [mpf(mass), mpf(1), mpf(mass)], [mpf(1), mpf(0), mpf(0)]
    together = m[0] / sum(m)
    basis = frame_of(m)
    w = [sum(basis[k][i] * sqrt(m[i]) * v[i] for i in range(3)) for k in range(2)]
    w = reflect_until_open(w, basis, m)
    one_by_one = [together + sum(w[k] * basis[k][i] for k in range(2)) / sqrt(m[i]) for i in range(3)]
    return [e * each + (1 - e) * together for each in one_by_one]


def frame_of(m):
    """Two unit vectors across sqrt(m): along the first contact's normal, and at right angles to it."""
    first = [1 / sqrt(m[0]), -1 / sqrt(m[1]), mpf(0)]
    size = sqrt(sum(x * x for x in first))
    first = [x / size for x in first]
    axis = [sqrt(each / sum(m)) for each in m]
    second = [axis[1] * first[2] - axis[2] * first[1], axis[2] * first[0] - axis[0] * first[2],
              axis[0] * first[1] - axis[1] * first[0]]
    return first, second


def reflect_until_open(w, basis, m):
    """Impacts one after the other, by the angle that two of them turn the velocity."""
    closing = []
    for a, b in ((0, 1), (1, 2)):
        n = [mpf(0)] * 3
        n[a], n[b] = 1 / sqrt(m[a]), -1 / sqrt(m[b])
        flat = [sum(x * y for x, y in zip(n, each)) for each in basis]
        size = hypot(*flat)
        closing.append([x / size for x in flat])
    dot = lambda p, q: p[0] * q[0] + p[1] * q[1]
    mirrored = lambda p, n: [p[k] - 2 * dot(p, n) * n[k] for k in range(2)]
    cross = closing[0][0] * closing[1][1] - closing[0][1] * closing[1][0]
    turn = 2 * atan2(cross, dot(*closing))  # a mirror at the first, then at the second
    rotated = lambda p, phi: [p[0] * cos(phi) - p[1] * sin(phi), p[0] * sin(phi) + p[1] * cos(phi)]
    low, high = 0, 1
    is_open = lambda rounds: max(dot(rotated(w, turn * rounds), n) for n in closing) <= 0
    still = lambda rounds: dot(rotated(w, turn * rounds), closing[0]) > 0
    while still(high):
        low, high = high, 2 * high
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (middle, high) if still(middle) else (low, middle)
    for rounds in (low, low + 1):
        now = rotated(w, turn * rounds)
        if max(dot(now, n) for n in closing) <= mpf(10) ** -50:
            return now
        now = mirrored(now, closing[0])
        if max(dot(now, n) for n in closing) <= mpf(10) ** -50:
            return now
    raise ArithmeticError("the row stays closed")


def between_members(e, masses, e_is_new=False):
    members = []
    for mass in masses:
        v = row_of_three(mass, mpf(e))
        words = f"mass ratio {mass:g}"
        changes = {"/spheres/0/mass": mass, "/spheres/2/mass": mass, "/checks/0/value/0": v[0], "/checks/1/value/0": v[2]}
        if e_is_new:
            words, changes = f"e = {e}, {words}", {"/materials/m/restitution": float(e), **changes}
        members.append(member(words, changes))
    return members


# Equal elastic balls on a line hand velocities on: less their own lengths they are free points between two walls.

def rods(count, radius, room, end, seed):
    chance = random.Random(seed)
    grid = 2 ** 20
    points = sorted(chance.sample(range(grid), count))
    starts = [mpf(p) * room / grid for p in points]
    speeds = [mpf(chance.choice((-1, 1)) * chance.randrange(grid // 2, 3 * grid // 2)) / grid for _ in range(count)]
    end = mpf(end)
    crossed = lambda a, b, period: abs(int(floor((a + b * end) / period)) - int(floor(a / period)))
    walls = sum(crossed(a, v, room) for a, v in zip(starts, speeds))
    meetings = sum(crossed(starts[i] - starts[j], speeds[i] - speeds[j], 2 * room)
                   + crossed(starts[i] + starts[j], speeds[i] + speeds[j], 2 * room)
                   for i in range(count) for j in range(i))
    ends = []
    for a, v in zip(starts, speeds):
        u = a + v * end
        copy = int(floor(u / room))
        ends.append(((copy + 1) * room - u, -v) if copy % 2 else (u - copy * room, v))
    ends.sort()
    shift = lambda k: (2 * k + 1) * mpf(radius)
    return ([(a + shift(k), v) for k, (a, v) in enumerate(zip(starts, speeds))],
            [(a + shift(k), v) for k, (a, v) in enumerate(ends)], walls, meetings)


def long_run():
    count, radius, room = 8, 0.5, mpf(2) ** -5
    def run(end):
        starts, ends, walls, meetings = rods(count, radius, room, end, 1)
        checks = [{"type": "event_count", "count": walls + meetings}, {"type": "energy", "rel": 1e-10}]
        for k, (x, v) in enumerate(ends):
            checks += state(f"rod-{k}", [x, 0, 0], [v, 0, 0], 1e-8, 1e-10)
        return starts, checks
    starts, checks = run(90)
    base = scene("Ten million impacts",
                 f"Eight equal elastic balls on a line between two walls have {checks[0]['count']:,} impacts in 90 s. Equal balls hand their velocities on, so that, less their own lengths, they are free points that pass through each other. The variation goes on a hundred times as long.",
                 90, [ball(f"rod-{k}", radius, [x, 0, 0], [v, 0, 0]) for k, (x, v) in enumerate(starts)], checks,
                 {"case": "long_run", "dt": 0.02, "exact": 1e-8, "title": "Ten million impacts",
                  "figure": "largest error of a place [m]; of velocities and energy in 1e-2; a wrong number of impacts counts as an error, too",
                  "step": "1/50 s: some twenty-five impacts fall into it; one that suits every gap there is would take days",
                  "causes": {"sank": "a ball goes through others and walls in a step", "missed": "a step has room for an impact or two where there are dozens",
                             "energy": "overlaps are put right without their energy"}},
                 planes=[{"id": "left", "normal": [1, 0, 0], "offset": 0, "material": "ideal"},
                         {"id": "right", "normal": [-1, 0, 0], "offset": float(-(2 * count * mpf(radius) + room)), "material": "ideal"}])
    _, later = run(9000)
    base["stress"]["members"] = [member(f"{later[0]['count']:,} impacts", {
        "/end_time": 9000, "/checks/0/count": later[0]["count"],
        **{f"/checks/{k}/value/0": check["value"][0] for k, check in enumerate(later) if "value" in check}})]
    return base


# Cradles and chains: conservation of momentum and energy, and the order in which equal balls hand on.

def cradle():
    r, gap, n, end = 0.125, 0.25, 5, 1
    def changes(k):
        spheres, checks = [], []
        for i in range(n):
            rest = mpf(2 * r * i)
            spheres.append(ball(f"b{i}", r, [rest - (gap if i < k else 0), 0, 0], [1 if i < k else 0, 0, 0]))
        for i in range(n):
            gone = i >= n - k
            x = mpf(2 * r * i) + (mpf(end) - mpf(gap) if gone else 0)
            checks += state(f"b{i}", [x, 0, 0], [1 if gone else 0, 0, 0], 1.25e-13, 1e-12)
        return spheres, checks
    spheres, checks = changes(1)
    base = scene("Cradle of five", "One ball comes in at 1 m/s and hits a row of four that touch: the last one leaves at 1 m/s, the others stand. In the variations two and three come in, and as many leave.",
                 end, spheres, checks,
                 {"case": "cradle", "dt": 0.000125, "exact": 1e-12, "title": "Cradles and chains",
                  "figure": "largest error of final positions in radii and of final velocities",
                  "step": "1/1000 of the time in which a ball moves by its radius",
                  "causes": {"late": "contacts are answered one after the other, once a step, or all in one problem: the impulse is spread over the row, and balls drift",
                             "sank": "contacts are answered one after the other, once a step, and the row closes in on itself"}})
    for k in (2, 3):
        spheres, checks = changes(k)
        base["stress"].setdefault("members", []).append(member(f"{k} come in", {
            **{f"/spheres/{i}/position/0": s["position"][0] for i, s in enumerate(spheres) if i < k},
            **{f"/spheres/{i}/velocity/0": 1 for i in range(k)},
            **{f"/checks/{j}/value/0": c["value"][0] for j, c in enumerate(checks)}}))
    return base


def chain():
    r = 0.125
    v = [mpf(-1) / 3, mpf(2) / 9, mpf(8) / 9]
    places = [mpf(0), mpf("0.25"), mpf("0.5")]
    checks = []
    for k in range(3):
        checks += state("abc"[k], [places[k] + v[k] * mpf("0.75"), 0, 0], [v[k], 0, 0], 1.25e-13, 1e-12)
    return scene("Chain of masses 1, 2, 1", "A ball of mass 1 hits two that touch, of masses 2 and 1: impacts one after the other give -1/3, 2/9 and 8/9 of its speed.",
                 1, [ball("a", r, [-0.25, 0, 0], [1, 0, 0]), ball("b", r, [0.25, 0, 0], mass=2), ball("c", r, [0.5, 0, 0])], checks,
                 {"case": "cradle", "dt": 0.000125, "exact": 1e-12})


# A heavy ball onto a light one on a floor: the light one between two that do not give way.

def heavy_on_light():
    mass, r, drop, g = 1e6, 0.125, 0.5, 8
    def checks_of(mass, e):
        # All that closes together stops; elastic impacts one after the other, heavy - light - heavy - floor ...
        fall = sqrt(2 * mpf(drop) / g)
        w, v, m = -g * fall, mpf(0), mpf(mass)
        speed = -w
        while True:
            if w < v:
                both = (m * w + v) / (m + 1)
                w, v = 2 * both - w, 2 * both - v
            elif v < 0:
                v = -v
            else:
                break
        end = float(fall) + 0.05
        after = mpf(end) - fall
        up = e * w
        return end, speed, [4 * mpf(r) - r + up * after - g * after ** 2 / 2, up - g * after]
    end, speed, (place, w) = checks_of(mass, mpf("0.5"))
    base = scene("Heavy ball onto a light one",
                 "A ball of 1e6 kg falls 0.5 m onto one of 1 kg that rests on the floor, e = 1/2: it rebounds with half of its speed, as between two bodies, for the light one hands it on to the floor.",
                 end, [ball("light", r, [0, 0, r], material="body", color="#d1495b"), ball("heavy", r, [0, 0, 3 * r + drop], mass=mass, material="body")],
                 [{"type": "final_velocity", "body": "heavy", "value": [0, 0, w], "abs": 1e-6 * float(speed)},
                  {"type": "final_position", "body": "heavy", "value": [0, 0, place], "abs": 1e-6}],
                 {"case": "heavy_on_light", "dt": 0.0003, "exact": 1e-6, "title": "Heavy ball onto a light one on the floor",
                  "figure": "error of the heavy ball's velocity, relative to its rebound's, and of its place [m], against e times impacts one after the other",
                  "step": "1/1000 of the time of the fall",
                  "causes": {"late": "a step gives the light ball an impulse or two, where the heavy one would turn round after thousands",
                             "energy": "a step gives the light ball an impulse or two, where the heavy one would turn round after thousands",
                             "sank": "the heavy ball presses the light one into the floor, and goes through it"}},
                 gravity=[0, 0, -g], materials={"body": {"restitution": 0.5, "color": "#00798c"}},
                 planes=[{"id": "floor", "normal": [0, 0, 1], "offset": 0, "material": "body"}])
    members = []
    for mass, e in ((1.0, 0.5), (1e3, 0.5), (1e6, 0.9), (1e6, 1.0), (1e12, 0.5)):
        if mass > 1e8:  # the light ball's share is below 1e-6: two bodies
            fall = sqrt(2 * mpf(drop) / g)
            now = mpf(end) - fall
            place, w = 3 * mpf(r) + mpf(e) * g * fall * now - g * now ** 2 / 2, mpf(e) * g * fall - g * now
        else:
            end, speed, (place, w) = checks_of(mass, mpf(e))
        members.append(member(f"mass ratio {mass:g}, e = {e:g}", {
            "/spheres/1/mass": mass, "/materials/body/restitution": e, "/checks/0/value/2": w, "/checks/1/value/2": place}))
    base["stress"]["members"] = members
    return base


# Rows that collapse: n equal balls against a wall lose everything for e below tan(pi/4 (1 - 1/n))^2 (Bernu, Mazighi 1990),
# and n - 1 of them do not for e above the same with n - 1: then no impact of several contacts comes before the end.

def collapse():
    r, gap = 0.125, 0.0625
    critical = lambda n: tan(pi / 4 * (1 - mpf(1) / n)) ** 2
    def checks_of(count):
        checks = []
        for k in sorted({0, count // 2, count - 1}):
            checks += state(f"row/{k}", [0, 0, (2 * k + 1) * r], [0, 0, 0], 0.2 * r, 0.01)
        return checks
    def changes(count, more):
        e = float((critical(count - 1) + critical(count)) / 2)
        return {"/fill/0/count": count, "/materials/body/restitution": e, "/end_time": 1.5 * count * gap + 1,
                "/checks": checks_of(count), **more}
    base = scene("Row onto a wall",
                 "A row of ten balls runs into a wall with e = 0.717, between the critical restitutions of nine and of ten (Bernu, Mazighi 1990): thousands of impacts, faster and faster, until all stand still before the wall. The same for 2 to 100 balls, and with other bounds of the guard.",
                 1, [], checks_of(10),
                 {"case": "collapse", "dt": 0.0005, "exact": 0.01, "limit": 0.05, "title": "Rows that collapse",
                  "figure": "largest speed of three balls that is left, in that of the start, and their distance from their places in the pile, in twenty radii",
                  "step": "1/250 of the time in which a ball moves by its radius",
                  "causes": {"late": "overlaps are put right pair by pair, and the row keeps moving",
                             "sank": "the row is pressed together faster than pairs are put right",
                             "energy": "overlaps are put right without their energy"}},
                 materials={"body": {"restitution": 0, "color": "#00798c"}},
                 planes=[{"id": "wall", "normal": [0, 0, 1], "offset": 0, "material": "body"}],
                 fill=[{"id": "row", "pattern": "line", "count": 10, "radius": r, "origin": [0, 0, r + gap], "axis": [0, 0, 1], "gap": gap,
                        "velocity": [0, 0, -1], "material": "body"}])
    del base["spheres"]
    base = applied(base, changes(10, {}))
    base["stress"]["members"] = [
        member(words, changes(count, more))
        for words, count, more in (("2 balls", 2, {}), ("3 balls", 3, {}), ("30 balls", 30, {}), ("100 balls", 100, {}),
                                   ("10 balls, guard from 20 impacts", 10, {"/guard/impacts": 20}),
                                   ("10 balls, guard from 1000 impacts", 10, {"/guard/impacts": 1000}),
                                   ("100 balls, guard from 400 impacts", 100, {"/guard/impacts": 400}))]
    return base
