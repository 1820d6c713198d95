"""A ball that bounces until it rests: flights of it are a geometric series."""
from mpmath import mpf

from .files import applied, ball, member, scene


def bounced(fall, gravity, e, time):
    """Height after `time` of a ball dropped so that it first falls for `fall`."""
    if time < fall:
        return gravity * (fall - time) * (fall + time) / 2
    began, flight = fall, 2 * fall * e
    while began + flight <= time:
        began, flight = began + flight, flight * e
        if flight < mpf(10) ** -40:
            return mpf(0)
    return gravity * (time - began) * (flight - (time - began)) / 2


def zeno_changes(e, radius, fixed_top, heights, first):
    """Places of a ball dropped from 1 m above rest under 8 m/s^2 and its time of rest; checks `first` on are positions."""
    fall, e = mpf("0.5"), mpf(e)
    rest = fall * (1 + e) / (1 - e)
    changes = {"/end_time": 1.25 * float(rest), "/checks/0/time": rest}
    for k in range(heights):
        time = float(rest * (k + 0.5) / heights)
        changes[f"/checks/{first + k}/time"] = time
        changes[f"/checks/{first + k}/value/2"] = fixed_top + radius + bounced(fall, mpf(8), e, mpf(time))
    return changes


def zeno_family():
    values = (0.1, 0.3, 0.5, 0.7, 0.9, 0.99, 0.9999)
    heights = 8
    checks = [{"type": "rest_time", "body": "ball", "time": 1, "rel": 1e-9}]
    checks += [{"type": "position", "body": "ball", "time": 0, "value": [0, 0, 0], "abs": 1.25e-10} for _ in range(heights)]
    base = scene("Zeno, e = 0.5 and others",
                 "A ball dropped from 1 m rests at t (1 + e)/(1 - e), t the time of the fall, after infinitely many bounces, for e from 0.1 to 0.9999.",
                 1, [ball("ball", 0.125, [0, 0, 1.125], material="body", color="#d1495b")], checks,
                 {"case": "zeno", "dt": 0.0005, "exact": 1e-9},
                 gravity=[0, 0, -8], materials={"body": {"restitution": 0.5, "color": "#00798c"}},
                 planes=[{"id": "floor", "normal": [0, 0, 1], "offset": 0, "material": "body"}])
    base = applied(base, zeno_changes(0.5, mpf("0.125"), mpf(0), heights, 1))
    base["stress"]["members"] = [
        member(f"e = {e}", {"/materials/body/restitution": e, **zeno_changes(e, mpf("0.125"), mpf(0), heights, 1)})
        for e in values if e != 0.5]
    return base


def bounce_on_sphere():
    heights = 8
    checks = [{"type": "rest_time", "body": "ball", "time": 1, "rel": 1e-9}]
    checks += [{"type": "position", "body": "ball", "time": 0, "value": [0, 0, 0], "abs": 1.25e-10} for _ in range(heights)]
    base = scene("Bouncing on a sphere",
                 "A ball dropped from 1 m onto the very top of a fixed one bounces as on a floor, and rests at t (1 + e)/(1 - e): infinitely many bounces, of which the slow ones count as much as the fast ones.",
                 1, [ball("ball", 0.125, [0, 0, 1.625], material="body", color="#d1495b"),
                     ball("below", 0.5, [0, 0, 0], material="body", fixed=True)], checks,
                 {"case": "bounce_on_sphere", "dt": 0.0005, "exact": 1e-9, "title": "Bounces on a sphere that die away",
                  "figure": "largest error of the place at 8 times, in radii (event: and of the time of rest, relative)",
                  "step": "1/1000 of the time of the fall",
                  "causes": {"late": "each bounce is found up to a step late and leaves with the wrong speed",
                             "sank": "a ball whose bounce is shorter than a step is turned back into the sphere and sinks",
                             "invented": "a bounce too slow to undo its overlap within a step is answered again and again"}},
                 gravity=[0, 0, -8], materials={"body": {"restitution": 0.99, "color": "#00798c"}})
    base = applied(base, zeno_changes(0.99, mpf("0.125"), mpf("0.5"), heights, 1))
    base["stress"]["members"] = [
        member(f"e = {e}", {"/materials/body/restitution": e, **zeno_changes(e, mpf("0.125"), mpf("0.5"), heights, 1)})
        for e in (0.5, 0.9, 0.999)]
    return base
