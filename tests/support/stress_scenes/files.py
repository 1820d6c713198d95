"""Scenes as documents, and the layout of their files."""
import json

from mpmath import mp

mp.dps = 60


WIDTH = 120
IDEAL = {"ideal": {"restitution": 1, "color": "#00798c"}}
UNITS = {"length": "m", "time": "s", "mass": "kg"}


# The files' layout: a value stands on one line if it fits.

def plain(value):
    if isinstance(value, mp.mpf):
        value = float(value)
    if isinstance(value, float) and value == int(value) and abs(value) < 1e16:
        value = int(value)
    if isinstance(value, dict):
        return {key: plain(each) for key, each in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(each) for each in value]
    return value


def layout(value, indent=0, before=0):
    line = json.dumps(value, ensure_ascii=False)
    if not isinstance(value, (dict, list)) or indent + before + len(line) <= WIDTH and indent > 0:
        return line
    inner = " " * (indent + 2)
    if isinstance(value, list):
        parts = [inner + layout(each, indent + 2) for each in value]
    else:
        parts = [f"{inner}{json.dumps(key)}: " + layout(each, indent + 2, len(key) + 4) for key, each in value.items()]
    ends = "[]" if isinstance(value, list) else "{}"
    return f"{ends[0]}\n" + ",\n".join(parts) + "\n" + " " * indent + ends[1]


def scene(name, description, end_time, spheres, checks, stress, **more):
    head = {"$schema": "../scene.schema.json", "format": "carom-scene/1", "name": name, "description": description,
            "units": UNITS}
    return plain({**head, **{k: more[k] for k in ("gravity",) if k in more}, "end_time": end_time,
                  "materials": more.get("materials", IDEAL), **{k: more[k] for k in ("rest", "impact", "guard") if k in more},
                  "spheres": spheres, **{k: more[k] for k in ("planes", "box", "fill") if k in more},
                  "checks": checks, "stress": stress})


def ball(id, radius, position, velocity=None, mass=None, material="ideal", **more):
    return {"id": id, "radius": radius, **({"mass": mass} if mass else {}), "position": position,
            **({"velocity": velocity} if velocity else {}), "material": material, **more}


def state(id, position, velocity, at, speed):
    return [{"type": "final_position", "body": id, "value": position, "abs": at},
            {"type": "final_velocity", "body": id, "value": velocity, "abs": speed}]


def member(name, changes):
    return plain({"name": name, "set": changes})


def applied(document, changes):
    for pointer, value in changes.items():
        *path, last = pointer.split("/")[1:]
        place = document
        for key in path:
            place = place[int(key)] if isinstance(place, list) else place.setdefault(key, {})
        place[int(last) if isinstance(place, list) else last] = value
    return plain(document)
