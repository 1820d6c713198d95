#include "scene/without_bodies.hpp"

namespace carom {

Scene without_bodies(const Scene& scene)
{
    Scene world;
    world.units = scene.units;
    world.gravity = scene.gravity;
    world.drag = scene.drag;
    world.origin = scene.origin;
    world.start_time = scene.start_time;
    world.end_time = scene.end_time;
    world.seed = scene.seed;
    world.materials = scene.materials;
    world.contacts = scene.contacts;
    world.rest = scene.rest;
    world.impact = scene.impact;
    world.guard = scene.guard;
    return world;
}

}  // namespace carom
