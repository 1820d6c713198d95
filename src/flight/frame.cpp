#include "flight/frame.hpp"

#include "core/expect.hpp"
#include "math/length.hpp"

#include <algorithm>

namespace carom {

double power_of_two_below(double x)
{
    int exponent = 0;
    std::frexp(x, &exponent);
    return std::ldexp(1.0, std::max(exponent - 1, least_exponent));
}

EpochTime Frame::in_later_epoch(const EpochTime& from, double dt) const
{
    CAROM_EXPECT(dt >= 0);
    if (!(dt < furthest * epoch_length)) return never;
    // dt is split exactly; only the addition of the two rests rounds.
    const double whole = std::floor(dt / epoch_length);
    EpochTime to{from.epoch + static_cast<std::int64_t>(whole), dt - whole * epoch_length};
    if (to.offset < 0) {  // the division rounded up to the next whole number
        to.offset += epoch_length;
        --to.epoch;
    }
    const double rest = (from.offset - epoch_length) + to.offset;
    if (rest >= 0) return {to.epoch + 1, rest};
    const double offset = from.offset + to.offset;
    return {to.epoch, offset < epoch_length ? offset : std::nextafter(epoch_length, 0.0)};
}

Frame make_frame(const Scene& scene)
{
    double r_min = std::numeric_limits<double>::infinity(), m_min = r_min, twice_energy = 0;
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
    for (const auto& s : scene.spheres) {
        r_min = std::min(r_min, s.radius);
        low = low.cwiseMin(s.position);
        high = high.cwiseMax(s.position);
        if (s.fixed) continue;
        m_min = std::min(m_min, s.mass);
        twice_energy += s.mass * s.velocity.squaredNorm();
    }
    Frame frame;
    if (scene.spheres.empty()) return frame;
    const double extent = std::sqrt((high - low).squaredNorm()) + r_min;
    const double fall = std::sqrt(2 * length(scene.gravity) * extent);
    const double speed = std::sqrt(twice_energy / m_min) + fall;  // the lightest sphere may end up with all the energy
    const double wanted = speed > 0 ? r_min / speed : scene.end_time;
    frame.epoch_length = power_of_two_below(std::clamp(wanted, smallest_ruler, largest_ruler));
    frame.cell_size = 2 * power_of_two_below(2 * std::clamp(r_min, smallest_ruler, largest_ruler));
    return frame;
}

Place place_at(const Frame& frame, const Vec3& position)
{
    return moved(frame, Place{}, position);
}

void put_into_cell(const Frame& frame, Place& place, int k, double sum)
{
    place.local[k] = sum;
    const double whole = std::floor(sum / frame.cell_size);
    if (!(std::abs(whole) < furthest)) return;
    place.cell[k] += static_cast<std::int64_t>(whole);
    place.local[k] = sum - whole * frame.cell_size;  // exact, but for a negative sum below the resolution
    if (place.local[k] >= frame.cell_size) {
        place.local[k] = 0;
        ++place.cell[k];
    }
}

Vec3 position_of(const Frame& frame, const Place& place)
{
    Vec3 p;
    for (int k = 0; k < 3; ++k) p[k] = static_cast<double>(place.cell[k]) * frame.cell_size + place.local[k];
    return p;
}

}  // namespace carom
