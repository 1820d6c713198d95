#include "study/search/step_scan.hpp"

#include "core/expect.hpp"
#include "study/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carom::study {

namespace {

bool is_smaller(const StepSearch::Try& a, const StepSearch::Try& b)
{
    return a.dt < b.dt;
}

}  // namespace

StepScan::StepScan(double first, double largest) : first_(first), largest_(largest), top_(0)
{
    CAROM_EXPECT(first > 0 && largest >= first);
    top_ = static_cast<int>(std::ceil(search_grid * (std::log2(largest / first) - same_step)));
}

double StepScan::step(int index) const
{
    if (index >= top_) return largest_;
    return first_ * std::exp2(static_cast<double>(index) / search_grid);
}

int StepScan::index_below(double dt) const
{
    int index = std::min(top_, static_cast<int>(std::ceil(search_grid * std::log2(dt / first_))) + 1);
    while (step(index) > dt * (1 + same_step)) --index;
    return index;
}

void StepScan::add(const StepSearch::Try& tried)
{
    tries_.insert(std::upper_bound(tries_.begin(), tries_.end(), tried, is_smaller), tried);
}

bool StepScan::is_tried(double dt) const
{
    const auto near =
        std::find_if(tries_.begin(), tries_.end(), [dt](const auto& each) { return each.dt >= dt * (1 - same_step); });
    return near != tries_.end() && near->dt <= dt * (1 + same_step);
}

double StepScan::fails() const
{
    const auto found = std::find_if(tries_.begin(), tries_.end(), [](const auto& each) { return !each.holds; });
    return found == tries_.end() ? std::numeric_limits<double>::infinity() : found->dt;
}

std::optional<double> StepScan::enough() const
{
    const auto fails = std::find_if(tries_.begin(), tries_.end(), [](const auto& each) { return !each.holds; });
    if (fails == tries_.begin()) return std::nullopt;
    return std::prev(fails)->dt;
}

std::optional<double> StepScan::gap(double from, int apart) const
{
    // Steps of the grid whose index is a multiple of `apart`, and the largest of all.
    int index = index_below(std::min(fails(), largest_));
    if (index < top_) index = static_cast<int>(std::floor(static_cast<double>(index) / apart)) * apart;
    while (step(index) >= from * (1 - same_step)) {
        if (!is_tried(step(index))) return step(index);
        index = static_cast<int>(std::ceil(static_cast<double>(index) / apart)) * apart - apart;
    }
    return std::nullopt;
}

std::optional<double> StepScan::next() const
{
    if (tries_.empty()) return first_;
    const std::optional<double> enough = this->enough();
    const double stride = std::exp2(search_stride);
    if (!enough) return step(index_below(tries_.front().dt / stride));
    if (std::isinf(fails()) && *enough < largest_) return step(index_below(std::min(largest_, *enough * stride)));
    for (int apart = search_grid; apart >= search_grid / search_density; apart /= 2)
        if (const auto untried = gap(*enough / scanned_range, apart)) return untried;
    return gap(*enough / edge_range, 1);
}

SearchFigures figures_of(const StepSearch& search)
{
    SearchFigures figures;
    for (const StepSearch::Try& each : search.tries) {
        if (each.error && (!figures.best || *each.error < *figures.best->error)) figures.best = each;
        if (!each.holds && !figures.fails) figures.fails = each;
        if (each.holds && figures.fails) ++figures.lucky;
        if (!search.row) continue;
        if (each.dt > *search.row->dt) {
            if (!figures.too_far) figures.too_far = each;
            continue;
        }
        ++figures.held;
        figures.worst_error = std::max(figures.worst_error, each.error.value_or(0));
    }
    return figures;
}

}  // namespace carom::study
