#include "bounce_by_hand.hpp"

#include "event_driven/event_hash.hpp"
#include "flight/flight.hpp"
#include "impact/pair_law.hpp"
#include "toi/sphere_plane.hpp"

#include <algorithm>
#include <cmath>

namespace bounce_by_hand {

using carom::Vec3;

Log same_bits(const carom::Scene& scene, const std::function<void(const carom::Event&)>& on_event)
{
    constexpr double u = carom::unit_roundoff;
    const carom::Sphere& ball = scene.spheres[0];
    const carom::Plane& plane = scene.planes[0];
    const carom::ContactLaw law = carom::plane_contact_law(scene, ball.material, plane.material);
    const carom::Frame frame = carom::make_frame(scene);
    const double radius = ball.radius;
    const Vec3 a = scene.gravity, n = plane.normal;
    const double g = n.dot(a);
    carom::Place x = carom::place_at(frame, ball.position);
    Vec3 v = ball.velocity;
    carom::EpochTime now;
    const carom::EpochTime end = frame.after({}, scene.end_time);
    const auto height = [&] {
        carom::Sum sum{-plane.offset, 0};
        const auto add = [&](double factor, double coordinate) {
            const carom::Sum product = carom::two_product(factor, coordinate);
            const carom::Sum next = carom::two_sum(sum.high, product.high);
            sum = {next.high, sum.low + (next.low + product.low)};
        };
        for (int k = 0; k < 3; ++k) {
            if (n[k] == 0) continue;
            add(n[k], static_cast<double>(x.cell[k]) * frame.cell_size);
            add(n[k], x.local[k]);
        }
        const carom::Sum whole = carom::two_sum(sum.high, sum.low), less = carom::two_sum(whole.high, -radius);
        return less.high + (less.low + whole.low);
    };
    Log log;
    carom::EventHash hash;
    double h = height();
    for (;;) {
        const carom::Root root = carom::plane_root(h, n.dot(v), g);
        if (root.kind != carom::RootKind::impact) break;
        const carom::EpochTime then = frame.after(now, root.t);
        if (then > end) break;
        const double dt = frame.between(now, then);
        now = then;
        x = carom::moved(frame, x, carom::displacement(v, a, dt));
        v += dt * a;
        h = height();
        const Vec3 change = carom::velocity_change(v, n, law);
        v += change;
        const double w = n.dot(v);
        if (w < 0 || w * (w / -g) <= 32 * u * (radius + frame.cell_size)) break;  // it lies there

        const carom::Event event{carom::EventKind::impact, now, 0, 0, 1, n, ball.mass * change};
        ++log.impacts;
        log.max_penetration = std::max(log.max_penetration, -h);
        log.plane_impulse += event.impulse.dot(n);
        hash.add(event);
        if (on_event) on_event(event);
    }
    log.hash = hash.value();
    return log;
}

Log plain(const carom::Scene& scene)
{
    const double g = -scene.gravity.z(), r = scene.spheres[0].radius;
    Vec3 x = scene.spheres[0].position, v = scene.spheres[0].velocity;
    double now = 0;
    Log log;
    for (;;) {
        const double t = (v.z() + std::sqrt(v.z() * v.z() + 2 * g * (x.z() - r))) / g;
        if (now + t > scene.end_time) break;
        now += t;
        x += t * v;
        x.z() = r;
        v.z() = g * t - v.z();
        ++log.impacts;
    }
    return log;
}

}  // namespace bounce_by_hand
