#include "verify/cells.hpp"

#include <bit>
#include <map>

namespace carom::verification {

Cells::Cells(const std::vector<double>& radii) : level_(radii.size()), marks_(radii.size(), 0)
{
    std::map<int, std::vector<BodyId>> by_size;
    for (std::size_t i = 0; i < radii.size(); ++i) {
        int exponent = 0;
        std::frexp(2 * radii[i], &exponent);  // diameter < 2^exponent
        by_size[exponent].push_back(static_cast<BodyId>(i));
    }
    // Few sizes keep a level each; should there be very many, neighbours share one.
    for (auto& [exponent, members] : by_size) {
        if (levels_.size() < most_levels) levels_.emplace_back();
        Level& level = levels_.back();
        level.size = std::ldexp(1.0, exponent);
        for (const BodyId body : members)
            level_[static_cast<std::size_t>(body)] = static_cast<std::uint8_t>(levels_.size() - 1);
        level.members.insert(level.members.end(), members.begin(), members.end());
    }
    const int bits = std::max(4, static_cast<int>(std::bit_width(radii.size())) + 1);
    heads_.assign(std::size_t{1} << bits, -1);
    mask_ = heads_.size() - 1;
    entries_.reserve(usual_entries * radii.size());
}

void Cells::clear()
{
    std::fill(heads_.begin(), heads_.end(), -1);
    entries_.clear();
    for (Level& level : levels_) {
        level.wide.clear();
        level.largest_radius = 0;
    }
}

Cells::Range Cells::range(const Box& box, double margin, double size)
{
    Range r{};
    r.count = 1;
    for (int k = 0; k < 3; ++k) {
        const double low = std::floor((box.low[k] - margin) / size), high = std::floor((box.high[k] + margin) / size);
        if (!(std::abs(low) < most_cell_number && std::abs(high) < most_cell_number)) {
            r.count = std::numeric_limits<double>::infinity();
            return r;
        }
        r.low[k] = static_cast<std::int64_t>(low);
        r.high[k] = static_cast<std::int64_t>(high);
        r.count *= high - low + 1;
    }
    return r;
}

void Cells::enter(BodyId body, const Box& box, double radius)
{
    const std::size_t k = level_[static_cast<std::size_t>(body)];
    Level& level = levels_[k];
    level.largest_radius = std::max(level.largest_radius, radius);
    const Range r = range(box, 0, level.size);
    if (!(r.count <= most_cells)) {
        level.wide.push_back(body);
        return;
    }
    for (std::int64_t x = r.low[0]; x <= r.high[0]; ++x)
        for (std::int64_t y = r.low[1]; y <= r.high[1]; ++y)
            for (std::int64_t z = r.low[2]; z <= r.high[2]; ++z) {
                const Place cell = place(k, x, y, z);
                std::int32_t& head = heads_[cell.bucket];
                entries_.push_back({body, head, cell.tag});
                head = static_cast<std::int32_t>(entries_.size() - 1);
            }
}

}  // namespace carom::verification
