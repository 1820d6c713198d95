#include "motion/bodies.hpp"

#include "math/double_double.hpp"

namespace carom {

namespace {

/// Keeps the low part of a place: what it lacks of the position that it was made from.
void keep_low_part(const Frame& frame, const Vec3& position, Place& place)
{
    for (int k = 0; k < 3; ++k) {
        const double cells = static_cast<double>(place.cell[k]) * frame.cell_size;
        place.low[k] = static_cast<double>(DoubleDouble(two_sum(position[k], -cells)) - DoubleDouble(place.local[k]));
    }
}

const Vec3& own_acceleration_of(const Motion& motion)
{
    if (const auto* held = std::get_if<Held>(&motion)) return held->acceleration;
    return std::get<Stepping>(motion).acceleration;
}

}  // namespace

Bodies::Bodies(const Scene& scene, const Frame& frame, Precision precision) : accelerations_(scene)
{
    hot_.reserve(scene.spheres.size());
    radii_.reserve(scene.spheres.size());
    motions_.reserve(scene.spheres.size());
    for (const Sphere& sphere : scene.spheres) {
        Hot hot;
        hot.flight.place = place_at(frame, sphere.position);
        if (precision == Precision::certified) keep_low_part(frame, sphere.position, hot.flight.place);
        if (!sphere.fixed) {
            hot.flight.velocity = sphere.velocity;
            hot.flight.acceleration = accelerations_.free();
        }
        hot.kind = sphere.fixed ? MotionKind::fixed : MotionKind::flying;
        hot_.push_back(hot);
        radii_.push_back(sphere.radius);
        motions_.push_back(sphere.fixed ? Motion(Fixed{}) : Motion(Flying{}));
    }
}

void Bodies::enter(const Change& change)
{
    Hot& hot = hot_[at(change.body)];
    const MotionKind next = kind_of(change.motion);
    in_piece_ += (is_piece(next) ? 1 : 0) - (is_piece(hot.kind) ? 1 : 0);
    hot.kind = next;
    motions_[at(change.body)] = change.motion;
    if (accelerations_.is_own(change.flight.acceleration))
        accelerations_.set_own(change.body, own_acceleration_of(change.motion));
    contacts_.set(change.body, change.contacts);
}

void Bodies::set_forces(BodyId body, const std::vector<PersistentContact>& contacts)
{
    contacts_.set_forces(body, contacts);
}

void Bodies::begin()
{
    for (Hot& hot : hot_) hot.stamp = 0;
}

}  // namespace carom
