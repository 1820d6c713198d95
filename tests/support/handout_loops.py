#!/usr/bin/env python3
"""The two discrete loops of a course handout on rigid spheres, run on a scene file of carom.

Usage: handout_loops.py SCENE pbd|velocity [STEPS [H]]

STEPS of H (192 of 1/240), then one JSON list of the spheres' final positions and velocities. The loops are written down from the
handout's words, share nothing with carom, and use nothing but the standard library: they are there to contradict it.

Both loops visit contacts in one order: the pairs of spheres i < j, then sphere by sphere the walls, all in the order of the scene. A
contact is there when its gap is <= 0, responds when its bodies approach, and asks for places and velocities as the contacts before it left
them.

What the handout does not speak of is refused (plates, fills, density, attenuation, an origin). Numbers are of any kind that has + - * /:
float, or Decimal, which tells rules from rounding."""
import decimal
import json
import math
import sys

KEYS = {"format", "gravity", "drag", "materials", "contacts", "spheres", "planes", "box"}
# Keys that say nothing to a loop: words, ends and options of commands, and the impacts and rest of the event-driven method.
SILENT_KEYS = {"$schema", "name", "description", "units", "end_time", "seed", "start_time", "checks", "stress", "run", "compare", "tunnel", "view",
               "impact", "rest", "guard"}
SPHERE_KEYS = {"id", "radius", "mass", "position", "velocity", "fixed", "material", "color"}
PLANE_KEYS = {"id", "normal", "offset", "point", "material"}
CONTACT_KEYS = {"between", "restitution", "tangential"}
STEPS = 192
H = 1 / 240  # [time]


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def plus(a, factor, b):
    """a + factor b"""
    return [a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]]


def minus(a, b):
    return [a[0] - b[0], a[1] - b[1], a[2] - b[2]]


def length(a):
    square = dot(a, a)
    return square.sqrt() if isinstance(square, decimal.Decimal) else math.sqrt(square)


class Sphere:
    def __init__(self, given, number):
        self.id, self.material = given.get("id"), given.get("material", "default")
        self.r = number(given["radius"])
        self.p = [number(x) for x in given["position"]]
        self.v = [number(x) for x in given.get("velocity", [0, 0, 0])]
        self.movable = not given.get("fixed", False)
        self.inverse_mass = 1 / number(given.get("mass", 1)) if self.movable else number(0)

    def state(self):
        return {"id": self.id, "position": [float(x) for x in self.p], "velocity": [float(x) for x in self.v]}


class Wall:
    """The half space n.x >= offset."""

    def __init__(self, normal, material):
        size = length(normal)
        self.n, self.material = [x / size for x in normal], material


class Pair:
    """The contact of spheres one and two, whose normal u points from two to one."""

    def __init__(self, one, two, e, alpha):
        self.one, self.two, self.e, self.alpha = one, two, e, alpha
        self.reduced_mass = 1 / (one.inverse_mass + two.inverse_mass)

    def gap(self):
        return length(minus(self.one.p, self.two.p)) - (self.one.r + self.two.r)

    def normal(self):
        apart = minus(self.one.p, self.two.p)
        distance = length(apart)
        if distance == 0:
            raise ZeroDivisionError(f"{self.one.id} and {self.two.id} share one centre: no normal")
        return [x / distance for x in apart]

    def closing_speed(self):
        return dot(minus(self.two.v, self.one.v), self.normal())

    def push(self, impulse, along):
        self.one.v = plus(self.one.v, impulse * self.one.inverse_mass, along)
        self.two.v = plus(self.two.v, -impulse * self.two.inverse_mass, along)

    def respond(self):
        u, closing = self.normal(), self.closing_speed()
        if closing > 0:
            v_t = plus(minus(self.two.v, self.one.v), -closing, u)
            self.push((1 + self.e) * self.reduced_mass * closing, u)
            self.push((1 - self.alpha) * self.reduced_mass, v_t)

    def cancel(self):
        closing = self.closing_speed()
        if closing > 0:
            self.push(self.reduced_mass * closing, self.normal())

    def project(self):
        u, d = self.normal(), -self.gap()
        share = d / 2 if self.one.movable and self.two.movable else d
        if self.one.movable:
            self.one.p = plus(self.one.p, share, u)
        if self.two.movable:
            self.two.p = plus(self.two.p, -share, u)


class AtWall:
    """The contact of a sphere with a wall."""

    def __init__(self, sphere, wall, e, alpha):
        self.sphere, self.wall, self.e, self.alpha = sphere, wall, e, alpha

    def gap(self):
        return dot(self.wall.n, self.sphere.p) - self.wall.offset - self.sphere.r

    def closing_speed(self):
        return -dot(self.sphere.v, self.wall.n)

    def respond(self):
        closing = self.closing_speed()
        if closing > 0:
            v_n = [-closing * x for x in self.wall.n]
            v_t = minus(self.sphere.v, v_n)
            self.sphere.v = [self.alpha * t - self.e * n for t, n in zip(v_t, v_n)]

    def cancel(self):
        closing = self.closing_speed()
        if closing > 0:
            self.sphere.v = plus(self.sphere.v, closing, self.wall.n)

    def project(self):
        self.sphere.p = plus(self.sphere.p, -self.gap(), self.wall.n)


class Laws:
    """e and alpha of two materials: the smaller of their two values, unless `contacts` overrides it."""

    def __init__(self, scene, number):
        self.materials = {"default": {}, **scene.get("materials", {})}
        self.overrides = {}
        for given in scene.get("contacts", []):
            known(given, CONTACT_KEYS)
            self.overrides[frozenset(given["between"])] = given
        self.number = number

    def smaller(self, one, two, key):
        return min(self.materials[one].get(key, 1), self.materials[two].get(key, 1))

    def restitution(self, one, two):
        override = self.overrides.get(frozenset((one, two)), {})
        return self.number(override.get("restitution", self.smaller(one, two, "restitution")))

    def tangential_at_wall(self, one, two):
        override = self.overrides.get(frozenset((one, two)), {})
        return self.number(override.get("tangential", self.smaller(one, two, "tangential")))

    def tangential_of_spheres(self, one, two):
        return self.number(self.overrides.get(frozenset((one, two)), {}).get("tangential", 1))


def known(given, keys):
    if set(given) - keys:
        raise ValueError(f"the handout has no {', '.join(sorted(set(given) - keys))}")


def walls_of(scene, number):
    walls = []
    for given in scene.get("planes", []):
        known(given, PLANE_KEYS)
        wall = Wall([number(x) for x in given["normal"]], given.get("material", "default"))
        wall.offset = number(given["offset"]) if "offset" in given else dot(wall.n, [number(x) for x in given["point"]])
        walls.append(wall)
    box = scene.get("box")
    if box is None:
        return walls
    known(box, {"min", "max", "material"})
    for axis in range(3):
        for sign, corner in ((1, box["min"]), (-1, box["max"])):
            wall = Wall([number(sign * (k == axis)) for k in range(3)], box.get("material", "default"))
            wall.offset = sign * number(corner[axis])
            walls.append(wall)
    return walls


class Bodies:
    def __init__(self, scene, number=float):
        known(scene, KEYS | SILENT_KEYS)
        for given in scene["spheres"]:
            known(given, SPHERE_KEYS)
        self.gravity = [number(x) for x in scene.get("gravity", [0, 0, 0])]
        self.drag = number(scene.get("drag", 0))
        self.spheres = [Sphere(given, number) for given in scene["spheres"]]
        self.movable = [s for s in self.spheres if s.movable]
        walls, laws = walls_of(scene, number), Laws(scene, number)
        self.pairs = [Pair(one, two, laws.restitution(one.material, two.material),
                           laws.tangential_of_spheres(one.material, two.material))
                      for i, one in enumerate(self.spheres) for two in self.spheres[i + 1:] if one.movable or two.movable]
        self.at_walls = [AtWall(s, wall, laws.restitution(s.material, wall.material),
                                laws.tangential_at_wall(s.material, wall.material)) for s in self.movable for wall in walls]
        self.contacts = self.pairs + self.at_walls

    def accelerate(self, h):
        for s in self.movable:
            s.v = plus(s.v, h, plus(self.gravity, -self.drag, s.v))  # the field's friction is a force -k m v

    def move(self, h):
        for s in self.movable:
            s.p = plus(s.p, h, s.v)

    def states(self):
        return [s.state() for s in self.spheres]


def pbd(bodies, h):
    bodies.accelerate(h)
    bodies.move(h)
    for contact in bodies.contacts:
        if contact.gap() <= 0:
            contact.respond()
            contact.project()


def velocity(bodies, h):
    closed = [contact for contact in bodies.contacts if contact.gap() <= 0]
    bodies.accelerate(h)
    for contact in closed:
        contact.respond()
    for contact in closed:
        contact.cancel()
    bodies.move(h)


LOOPS = {"pbd": pbd, "velocity": velocity}


def run(scene, method, steps=STEPS, h=H, number=float):
    """Final states of a scene (parsed JSON)."""
    bodies = Bodies(scene, number)
    for _ in range(steps):
        LOOPS[method](bodies, number(h))
    return bodies.states()


def main(args):
    if len(args) not in (2, 3, 4) or args[1] not in LOOPS:
        sys.exit(__doc__)
    with open(args[0]) as file:
        scene = json.load(file)
    states = run(scene, args[1], int(args[2]) if len(args) > 2 else STEPS, float(args[3]) if len(args) > 3 else H)
    print(json.dumps(states, indent=1))


if __name__ == "__main__":
    main(sys.argv[1:])
