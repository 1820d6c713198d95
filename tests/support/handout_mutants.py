"""The loops of the handout with one rule changed: what a scene must tell from them. Each is an edit of the text of handout_loops.py."""
import pathlib
import types

TEXT = (pathlib.Path(__file__).resolve().parent / "handout_loops.py").read_text()
BOTH = ("pbd", "velocity")

IN_TURN = "for contact in bodies.contacts:\n        if contact.gap() <= 0:"
PROJECT = "            contact.respond()\n            contact.project()"
MOVE = "    bodies.accelerate(h)\n    bodies.move(h)\n"
RESPOND = "        if closing > 0:\n            v_t"
SHIFT = ("        if self.one.movable:\n            self.one.p = plus(self.one.p, share, u)\n"
         "        if self.two.movable:\n            self.two.p = plus(self.two.p, -share, u)\n")
SHIFT_BY_MASS = ("        self.one.p = plus(self.one.p, d * self.reduced_mass * self.one.inverse_mass, u)\n"
                 "        self.two.p = plus(self.two.p, -d * self.reduced_mass * self.two.inverse_mass, u)\n")
SHARE = "d / 2 if self.one.movable and self.two.movable else d"
CLOSED = "closed = [contact for contact in bodies.contacts if contact.gap() <= 0]"
BOUNCE = "    for contact in closed:\n        contact.respond()\n"
CANCEL = "    for contact in closed:\n        contact.cancel()\n"
SPHERES_ALPHA = '.get("tangential", 1))'
WALL_ALPHA = "self.alpha * t -"
FIELD = "s.v = plus(s.v, h, plus(self.gravity, -self.drag, s.v))"
PUSH_BACK = "self.push(self.reduced_mass * closing, self.normal())"


def then(first, second):
    """What is first, and then what is second once that has been gone through."""
    yield from first
    yield from second()


def order(contacts):
    """The loop pbd over other contacts."""
    return IN_TURN.replace("bodies.contacts", contacts)


# What is changed: the methods that it concerns, the text, and what replaces it.
MUTANTS = {
    "pairs_frozen": (("pbd",), IN_TURN, order("[pair for pair in bodies.pairs if pair.gap() <= 0] + bodies.at_walls")),
    "walls_frozen": (("pbd",), IN_TURN, order("then(bodies.pairs, lambda: [c for c in bodies.at_walls if c.gap() <= 0])")),
    "both_frozen": (("pbd",), IN_TURN, order("then([pair for pair in bodies.pairs if pair.gap() <= 0],"
                                             " lambda: [c for c in bodies.at_walls if c.gap() <= 0])")),
    "pairs_reversed": (("pbd",), IN_TURN, order("bodies.pairs[::-1] + bodies.at_walls")),
    "walls_first": (("pbd",), IN_TURN, order("bodies.at_walls + bodies.pairs")),
    "walls_reversed": (("pbd",), IN_TURN, order("bodies.pairs + bodies.at_walls[::-1]")),
    "responses_before_projections": (("pbd",), PROJECT, "            contact.respond()\n    for contact in bodies.contacts:\n"
                                     "        if contact.gap() <= 0:\n            contact.project()"),
    "only_what_closes_projected": (("pbd",), PROJECT, PROJECT.replace("contact.respond()", "if contact.closing_speed() <= 0:\n"
                                                                   "                continue\n            contact.respond()")),
    "projected_by_mass": (("pbd",), SHIFT, SHIFT_BY_MASS),
    "half_from_fixed": (("pbd",), SHARE, "d / 2"),
    "moved_before_accelerated": (("pbd",), MOVE, "    bodies.move(h)\n    bodies.accelerate(h)\n"),
    "touching_is_open_when_moved": (("pbd",), IN_TURN, IN_TURN.replace("<=", "<")),
    "touching_is_open": (("velocity",), CLOSED, CLOSED.replace("<=", "<")),
    "gaps_after_the_move": (("velocity",), CLOSED, "bodies.move(h)\n    " + CLOSED + "\n    bodies.move(-h)"),
    "only_what_closes_before": (("velocity",), BOUNCE, "    closing = [contact for contact in closed if contact.closing_speed() > 0]\n"
                                + BOUNCE.replace("closed", "closing")),
    "bounces_reversed": (("velocity",), BOUNCE, BOUNCE.replace("closed", "closed[::-1]")),
    "nothing_cancelled": (("velocity",), CANCEL, ""),
    "cancelled_in_reverse": (("velocity",), CANCEL, CANCEL.replace("closed", "closed[::-1]")),
    "cancelled_at_one": (("velocity",), PUSH_BACK, "self.one.v = plus(self.one.v, closing, self.normal())"),
    "drag_ignored": (BOTH, FIELD, "s.v = plus(s.v, h, self.gravity)"),
    "drag_after_gravity": (BOTH, FIELD, "s.v = plus(s.v, h, self.gravity); s.v = plus(s.v, -h * self.drag, s.v)"),
    "drag_implicit": (BOTH, FIELD, "s.v = [x / (1 + h * self.drag) for x in plus(s.v, h, self.gravity)]"),
    "drag_by_mass": (BOTH, FIELD, FIELD.replace("-self.drag", "-self.drag * s.inverse_mass")),
    "separating_respond": (BOTH, RESPOND, RESPOND.replace("closing > 0", "True")),
    "larger_of_two": (BOTH, "min(", "max("),
    "overrides_ignored": (BOTH, "self.overrides[frozenset(given[\"between\"])] = given", "pass"),
    "tangential_of_spheres_ignored": (BOTH, SPHERES_ALPHA, SPHERES_ALPHA + " * 0 + 1"),
    "tangential_of_spheres_always": (BOTH, SPHERES_ALPHA, SPHERES_ALPHA.replace("1", 'self.smaller(one, two, "tangential")')),
    "tangential_of_walls_ignored": (BOTH, WALL_ALPHA, "t -"),
}


def mutant(name):
    """The module handout_loops with one rule changed."""
    _, text, replacement = MUTANTS[name]
    assert TEXT.count(text) == 1, f"{name}: its text is not there once: {text}"
    module = types.ModuleType(f"handout_loops, {name}")
    module.then = then
    exec(TEXT.replace(text, replacement), module.__dict__)
    return module
