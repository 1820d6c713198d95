/// \file
/// Coverage of many spheres: time in slabs, as long as spheres sweep a few cells in.
#include "verify/coverage.hpp"

#include <algorithm>
#include <array>

namespace carom::verification {

EpochTime Coverage::later(const EpochTime& t, double epochs) const
{
    if (epochs >= 1) return {t.epoch + static_cast<std::int64_t>(epochs), t.offset};
    const double offset = t.offset + epochs;
    return offset < 1 ? EpochTime{t.epoch, offset} : EpochTime{t.epoch + 1, offset - 1};
}

void Coverage::choose_duration()
{
    // At first: as long as it takes most spheres to sweep half a cell.
    double rate = 0;
    for (BodyId i = 0; i < data_.spheres(); ++i) {
        const Path path = flights_.path(i);
        const double size = cells_->cell_size(i);
        rate += path.velocity.norm() / size + std::sqrt(data_.acceleration(path).norm() / size);
    }
    rate /= data_.spheres();
    int exponent = 0;
    std::frexp(rate > 0 ? 0.5 / rate : 1.0, &exponent);
    slab_ = std::ldexp(1.0, std::clamp(exponent - 1, -slab_bits, slab_bits));
}

void Coverage::set_reference(const EpochTime& at)
{
    reference_ = at;
    opened_ = 0;
    for (BodyId i = 0; i < data_.spheres(); ++i) {
        const Path path = flights_.path(i);
        quick_[static_cast<std::size_t>(i)] = quick_look_at(path, data_.acceleration(path), at);
    }
}

void Coverage::sort_bodies()
{
    std::vector<std::pair<std::array<float, 3>, BodyId>> places;
    places.reserve(data_.run.spheres.size());
    order_.reserve(data_.run.spheres.size());
    for (BodyId i = 0; i < data_.spheres(); ++i) {
        const Path p = flights_.path(i);
        const double size = 2 * cells_->cell_size(i);
        std::array<float, 3> place;
        for (std::size_t k = 0; k < 3; ++k)
            place[k] = static_cast<float>(std::floor((static_cast<double>(p.cell[k]) + p.local[k]) / size));
        places.emplace_back(place, i);
    }
    std::sort(places.begin(), places.end());
    order_.clear();
    for (const auto& [place, body] : places) order_.push_back(body);
}

void Coverage::begin_slab(const EpochTime& at)
{
    if (slabs_++ % slabs_a_sorting == 0) sort_bodies();
    slab_begin_ = at;
    slab_end_ = later(at, slab_);
    reference_ = at;
    cells_->clear();
    for (const BodyId i : order_) open(i, std::max(at, flights_.start(i)));
    entries_at_begin_ = cells_->entries();
}

void Coverage::end_slab(const EpochTime& at)
{
    for (const BodyId i : order_) {
        if (patience_.ended()) return;
        const EpochTime from = std::max(slab_begin_, flights_.start(i));
        double radius = 0;
        const Box swept_box = box(i, from, at, radius);
        cells_->visit(swept_box, radius, [&](BodyId other) {
            if (other > i) pair(i, other, from, at);
        });
    }
}

void Coverage::advance(const EpochTime& now)
{
    if (all_pairs_) return;
    while (!(now < slab_end_)) {
        end_slab(slab_end_);
        if (!patience_.lasts()) return;
        adapt();
        begin_slab(slab_end_);
    }
    const double fresh = static_cast<double>(cells_->entries()) - static_cast<double>(entries_at_begin_);
    if (fresh > most_new_entries * data_.spheres() && slab_begin_ < now) {
        end_slab(now);
        if (patience_.ended()) return;
        slab_ = std::max(slab_ / 2, shortest_slab);
        begin_slab(now);
    }
}

/// The next slab is longer if spheres swept few cells in the last one, shorter if many.
void Coverage::adapt()
{
    const double cells = static_cast<double>(entries_at_begin_) / data_.spheres();
    if (cells < few_cells_swept || slabs_ > most_slabs + findings_.out.flights)
        slab_ = std::min(2 * slab_, longest_slab);
    else if (cells > many_cells_swept)
        slab_ = std::max(slab_ / 2, shortest_slab);
}

}  // namespace carom::verification
