/// \file
/// A first look at pairs, in a dozen operations: nearly all pairs are so far from touching that no more is needed.
///
/// Under one acceleration a every flight is straight once a t^2/2 is left out: y(t) = y + w t, t from a common
/// reference. Pairs differ by y and w alone.
#pragma once

#include "verify/path.hpp"

#include <algorithm>

namespace carom::verification {

struct Quick {
    Vec3 y, w;                             ///< [cells], [cells/epoch]
    float place_size = 0, speed_size = 0;  ///< of the parts that they are made of, rounded up
    double start = 0;                      ///< after the reference [epochs]
    std::int32_t acceleration = -1;        ///< -1: a series or a damped flight, which needs a closer look
};

inline Quick quick_look_at(const Path& p, const Vec3& a, const EpochTime& reference)
{
    Quick q;
    if (p.mode == Mode::series || p.drag > 0) return q;
    const double t = between<double>(reference, p.start), span = std::abs(t) + 1;
    q.start = t;
    q.acceleration = p.acceleration;
    double place = 0, speed = 0;
    for (int k = 0; k < 3; ++k) {
        const auto cells = static_cast<double>(p.cell[k]);
        const double v = p.velocity[k];
        q.y[k] = cells + (p.local[k] - t * (v - 0.5 * t * a[k]));
        q.w[k] = v - t * a[k];
        const double size = std::abs(v) + span * std::abs(a[k]);
        speed += size;
        place += std::abs(cells) + std::abs(p.local[k]) + span * size;
    }
    q.place_size = static_cast<float>(place * float_rounded_up);
    q.speed_size = static_cast<float>(speed * float_rounded_up);
    return q;
}

/// Is |r|^2 - S^2 > `needed` from t0 to t1, certainly? \pre the accelerations are one, and no series.
inline bool is_far(const Quick& a, const Quick& b, double t0, double t1, double contact, double needed)
{
    const Vec3 w = a.w - b.w, r = (a.y - b.y) + t0 * w;
    const double duration = (t1 - t0) * (1 + duration_rounding) + reference_rounding * (t1 + 1);
    const double rr = r.squaredNorm(), rw = r.dot(w), ww = w.squaredNorm();
    const double f = rr - contact * contact;
    const double t = std::clamp(-rw, 0.0, ww * duration);  // times ww
    const double least = ww > 0 ? f + (2 * rw + t) * (t / ww) : f;
    const double w_error = quick_rounding * (static_cast<double>(a.speed_size) + static_cast<double>(b.speed_size));
    const double r_error =
        quick_rounding * (static_cast<double>(a.place_size) + static_cast<double>(b.place_size)) + (t1 + 1) * w_error;
    // Anywhere on the way the parts differ from what they should be by no more than this, in each of 3 directions.
    const double shift = r_error + duration * w_error;
    const double size = std::sqrt(rr) + duration * std::sqrt(ww);
    const double error =
        4 * shift * size + 3 * shift * shift + quick_square_rounding * (size * size + contact * contact);
    return least - error > needed;
}

/// Is n.x - offset - r > `needed` from the start of the flight to t1, certainly?
inline bool is_far(const Quick& q, const Vec3& a, const Vec3& n, double offset, double t1, double radius, double needed)
{
    const double hy = n.dot(q.y) - offset - radius, hw = n.dot(q.w), g = n.dot(a), t0 = q.start;
    const double h0 = hy + t0 * (hw + 0.5 * t0 * g), h1 = hy + t1 * (hw + 0.5 * t1 * g);
    const double duration = t1 - t0, span = t1 + std::abs(t0) + 1;
    const double size = static_cast<double>(q.place_size) +
                        span * (static_cast<double>(q.speed_size) + span * std::abs(g)) + std::abs(offset) + radius;
    return std::min(h0, h1) - std::max(0.0, g) * duration * duration * quick_arc - quick_height_rounding * size >
           needed;
}

}  // namespace carom::verification
