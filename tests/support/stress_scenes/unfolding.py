"""Walls that mirror: the path of an elastic ball among them is a straight line through copies of what is between them."""
from mpmath import atan2, cos, floor, hypot, mp, mpf, pi, sin, sqrt

from .files import ball, member, scene, state


# Two points before a wall: the path of (sqrt(M) y, sqrt(m) x) is a straight line, folded at the sides of a wedge.

def shuttle(light, heavy, speed, mass, time):
    """Light ball at rest at `light` from the wall, heavy one beyond it coming in: (x, v), (y, w) after `time`, impacts."""
    angle = atan2(1, sqrt(mass))  # between the wall (x = 0) and the contact (x = y)
    at = lambda t: (sqrt(mass) * (heavy - speed * t), light)
    (a, b), (c, d) = at(0), at(time)
    turned = atan2(d, c)  # the path passes the edge on the side of x > 0: angles grow from 0 to pi
    copy = int(floor(turned / angle))
    fold = lambda phi: (copy + 1) * angle - phi if copy % 2 else phi - copy * angle
    r, phi, u, psi = hypot(c, d), fold(turned), sqrt(mass) * speed, fold(atan2(0, -1))
    return (r * sin(phi), u * sin(psi)), (r * cos(phi) / sqrt(mass), u * cos(psi) / sqrt(mass)), copy


def pi_members():
    members = []
    for k in (1, 2, 4, 5, 6):
        x, y, impacts = shuttle(mpf(1), mpf(2), mpf(1), mpf(100) ** k, mpf(22))
        assert impacts == int(floor(mpf(10) ** k * pi))
        # Each of 10^k pi impacts rounds the small ball's speed, up to 10^k of the large one's: ten times a random walk; and
        # the large one's, at worst always the same way.
        unit = mpf(2) ** -53
        speed = max(mpf("1e-9") * abs(x[1]), 10 * sqrt(10 ** k * pi) * mpf(10) ** k * unit)
        members.append(member(f"k = {k}", {
            "/end_time": 22, "/spheres/1/mass": 100.0 ** k, "/checks/0/value/0": x[0] + mpf("0.125"),
            "/checks/0/abs": max(mpf("1.25e-10"), 20 * speed), "/checks/1/value/0": x[1], "/checks/1/abs": speed,
            "/checks/2/value/0": y[0] + mpf("0.5"), "/checks/2/abs": max(mpf("2.5e-10"), 10 ** k * pi * unit * 22), "/checks/3/value/0": y[1],
            "/checks/3/abs": 1e-9 * abs(y[1]), "/checks/4/count": impacts}))
    return members


# A ball in a wedge.

def unfolded(position, velocity, upper, time):
    angle = atan2(mpf(upper[0]), -mpf(upper[2]))
    x, z, u, w = (mpf(value) for value in (position[0], position[2], velocity[0], velocity[2]))
    end = (x + u * time, z + w * time)
    turned = atan2(end[1], end[0])
    copy = int(floor(turned / angle))
    fold = lambda phi: (copy + 1) * angle - phi if copy % 2 else phi - copy * angle
    r, phi, s, psi = hypot(*end), fold(turned), hypot(u, w), fold(atan2(w, u))
    return [r * cos(phi), 0, r * sin(phi)], [s * cos(psi), 0, s * sin(psi)], copy


def wedge_members():
    members = []
    for words, degrees, slope in (("90 degrees", "90", 0.25), ("60 degrees", "60", 0.25), ("45 degrees", "45", 0.25),
                                  ("0.1 degrees", "0.1", 2.0 ** -6)):
        angle = mpf(degrees) * pi / 180
        upper = [float(sin(angle)), 0, float(-cos(angle)) + 0.0]
        position = [float(2 * cos(angle / 4)), 0, float(2 * sin(angle / 4))]
        velocity = [-1, 0, slope]
        place, speed, impacts = unfolded(position, velocity, upper, mpf(4))
        changes = {"/spheres/0/position": position, "/spheres/0/velocity": velocity, "/planes/1/normal": upper,
                   "/checks/1/count": impacts, "/checks/2/value": place, "/checks/3/value": speed}
        members.append(member(words, changes))
    return members


# Grazing: the miss distance is a double, what the impact changes is 2 sin cos of the angle at which it is met.

def grazing_member(words, miss, hits):
    contact = mpf("0.25")
    up = mpf(miss) / contact
    change = [2 * (1 - up) * (1 + up) / 2, -2 * up * sqrt((1 - up) * (1 + up)) / 2, 0] if hits else [0, 0, 0]
    size = 1e-8 * (hypot(*change[:2]) if hits else sqrt(2 * abs(1 - up)))
    return member(words, {"/spheres/0/position/1": miss, "/checks/0/value": [1 - change[0], -change[1], 0],
                          "/checks/0/abs": size, "/checks/1/value": change, "/checks/1/abs": size})


# A ball in a slot: unfolded across it, it moves straight.

def in_slot():
    gap, vx, vz, end = mpf(2) ** -30, mpf(1), mpf(2) ** -10, mpf("0.9")
    u = gap / 2 + vz * mpf(float(end))
    copy = int(floor(u / gap))
    place = (copy + 1) * gap - u if copy % 2 else u - copy * gap
    speed = -vz if copy % 2 else vz
    width = 0.5
    return scene("Slot of clearance 1e-9",
                 f"An elastic ball slides into a slot that is 2^-30 m, 9.3e-10 m, wider than it, and goes from side to side {copy:,} times on its way. Unfolded across the slot its path is straight.",
                 float(end), [ball("ball", width / 2, [0, 0, float(mpf(width) / 2 + gap / 2)], [float(vx), 0, float(vz)], color="#d1495b")],
                 [{"type": "event_count", "count": copy}, {"type": "energy", "rel": 1e-9}]
                 + state("ball", [mpf(float(end)), 0, mpf(width) / 2 + place], [vx, 0, speed], float(gap) * 1e-3, 1e-9),
                 {"case": "slot", "dt": 0.00025, "exact": 1e-3, "title": "Slots of clearance 1e-9",
                  "figure": "largest error of the place, in clearances; of velocity and energy in 1e-6; a wrong number of impacts counts as an error, too",
                  "step": "1/1000 of the time in which the ball moves by its radius",
                  "causes": {"missed": "in one step the ball would cross the slot hundreds of times, and gets an impact or two",
                             "sank": "in one step the ball goes through both sides of the slot",
                             "invented": "an overlap with a side is answered at every step",
                             "late": "an overlap is put right with a side at a time"}},
                 planes=[{"id": "bottom", "normal": [0, 0, 1], "offset": 0, "material": "ideal"},
                         {"id": "top", "normal": [0, 0, -1], "offset": float(-(mpf(width) + gap)), "material": "ideal"}])


def gate():
    """A ball that passes between two fixed ones; with less room it hits both, and comes back."""
    half, r = 2.0 ** -31, 0.25
    place = lambda room: [ball("ball", r, [-1, 0, 0], [1, 0, 0], color="#d1495b"),
                          ball("above", r, [0, 0, float(2 * r + room)], fixed=True), ball("below", r, [0, 0, float(-2 * r - room)], fixed=True)]
    # Both are met where x^2 + (2 r - room)^2 = (2 r)^2; both impulses along x and across: the velocity across cancels.
    inside = mpf(2 * r) - mpf(half)
    x = -sqrt(mpf(2 * r) ** 2 - inside ** 2)
    time = 1 + x
    back = [x - (mpf(2) - time), 0, 0]
    base = scene("Gate of clearance 1e-9",
                 "A ball passes between two fixed ones with 2^-31 m, 4.7e-10 m, to spare on either side: nothing happens. With as much too little it touches both at once and comes straight back.",
                 2, place(half), [{"type": "event_count", "count": 0}] + state("ball", [1, 0, 0], [1, 0, 0], 1e-9, 1e-9),
                 {"case": "slot", "dt": 0.00025, "exact": 1e-3})
    for check in base["checks"][1:]:
        check["abs"] = 1e-9
    spheres = place(-half)
    base["stress"]["members"] = [member("as much too narrow", {
        "/spheres/1/position/2": spheres[1]["position"][2], "/spheres/2/position/2": spheres[2]["position"][2],
        "/checks/0/count": 2, "/checks/1/value": back, "/checks/2/value": [-1, 0, 0]})]
    return base


# Speeds at random phases of a step.

def sweep(name, farthest, numbers, first):
    r, speed, count = 2.0 ** -4, 1.0, 100
    golden = (sqrt(mpf(5)) - 1) / 2
    spheres, checks = [], [{"type": "event_count", "count": count}]
    end = 1.25 * farthest * r
    for k in range(count):
        way = float(farthest * mpf(r) * ((k + 1) * golden % 1))
        y = 3 * r * k
        spheres.append(ball(f"b{k}", r, [-(way + r), y, 0], [speed, 0, 0]))
        place = mpf(-(way + r)) + speed * mpf(way) - speed * (mpf(end) - mpf(way))
        met = -mpf(r) - mpf(-(way + r))
        checks.append({"type": "final_position", "body": f"b{k}", "value": [-mpf(r) - (mpf(end) - met), y, 0], "abs": 1e-12 * farthest * r})
    members = [member(f"v dt / r = {n:g}", {"/stress/dt": n * r / speed}) for n in numbers[1:]]
    words = {"case": "speed_sweep", "dt": numbers[0] * r / speed, "exact": 1e-12, "limit": 0.01}
    if first:
        words |= {"title": "Speeds from 0.1 to 1e6 radii a step", "figure": "largest error of a final position, in the longest way; an impact missed or invented counts as an error, too",
                  "step": "0.1 to 1e6 of the time in which a ball moves by its radius, as the variations say",
                  "causes": {"missed": "from a radius a step on a ball may be before the plate at one look and behind it at the next",
                             "late": "a ball that is found inside the plate is sent back from where it is",
                             "sank": "a ball that is found deep inside the plate is not brought out"}}
    base = scene(name, f"A hundred balls fly at a thin plate from up to {farthest:g} radii away, each at another phase of the step: all come back.",
                 end, spheres, checks, words, planes=[{"id": "plate", "normal": [-1, 0, 0], "offset": 0, "thickness": 0, "material": "ideal"}])
    base["stress"]["members"] = members
    return base


# Stiffness of a penalty spring: stable as long as the step is below 2 / sqrt(k/m).

def penalty():
    r, dt = 0.125, 2.0 ** -12
    end = 1.0
    checks = [{"type": "event_count", "count": 1}] + state("ball", [0, 0, r + 0.5], [0, 0, 1], 1e-9, 1e-9)
    base = scene("Penalty stiffness", "An elastic ball of 1 kg meets a wall at 1 m/s and comes back. A penalty spring of stiffness k is stable for steps below 2 sqrt(m/k); the variations go up to that bound and beyond it.",
                 end, [ball("ball", r, [0, 0, r + 0.5], [0, 0, -1])], checks,
                 {"case": "penalty_stiffness", "dt": dt, "exact": 1e-9, "stiffness": 0.01 / dt ** 2, "title": "Penalty stiffness up to its bound and beyond",
                  "figure": "error of the final place [m] and velocity [m/s]; an impact missed or invented counts as an error, too",
                  "step": "1/512 of the time in which the ball moves by its radius; sqrt(k/m) dt is 0.1 to 10",
                  "causes": {"stopped": "the spring's period is shorter than the step: forces would grow from step to step",
                             "late": "a contact takes time, and less and less of a parabola is left of it as the spring gets stiffer"}},
                 planes=[{"id": "wall", "normal": [0, 0, 1], "offset": 0, "material": "ideal"}])
    base["stress"]["members"] = [member(f"sqrt(k/m) dt = {w:g}", {"/stress/stiffness": w * w / dt ** 2}) for w in (1.0, 1.9, 2.1, 10.0)]
    return base


# A ball between two walls, far away and late: what it does is known without arithmetic.

def shuttle_scene(name, description, checks, stress, **more):
    return scene(name, description, 9.25, [ball("ball", 0.25, [0.5, 0.5, 0.5], [1, 0, 0], color="#d1495b")],
                 [{"type": "event_count", "count": 12, "abs": 0}] + checks, stress,
                 planes=[{"id": "left", "normal": [1, 0, 0], "offset": 0, "material": "ideal"},
                         {"id": "right", "normal": [-1, 0, 0], "offset": -1.25, "material": "ideal"}], **more)
