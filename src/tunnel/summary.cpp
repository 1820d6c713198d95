#include "tunnel/summary.hpp"

#include "study/largest.hpp"
#include "tunnel/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carom::tunnel {

namespace {

bool has_both_integrators(const Report& report)
{
    return std::any_of(report.rows.begin(), report.rows.end(),
                       [](const Row& row) { return row.integrator == Integrator::parabola; });
}

std::string who_in(const Report& report, const Row& row)
{
    if (!has_both_integrators(report) || !row.integrator) return row.method;
    return row.method + ", " + std::string(carom::name(*row.integrator));
}

void keep(std::optional<double>& largest, double value)
{
    double kept = largest.value_or(0);
    study::keep_largest(kept, value);
    largest = kept;
}

void add(Summary& sum, const Row& row)
{
    ++sum.cells;
    sum.trials += row.trials;
    sum.tunnelled += row.tunnelled;
    sum.wrong += row.wrong;
    if (row.worst_error) keep(sum.worst_error, *row.worst_error / row.cell.radius);
    if (row.tunnelled > 0)
        sum.tunnels_from =
            std::min(sum.tunnels_from.value_or(std::numeric_limits<double>::infinity()), row.cell.number());
    if (!row.law) return;
    const auto trials = static_cast<double>(row.trials);
    const double expected = trials * *row.law;
    if (std::min(expected, trials - expected) < fewest_expected) return;
    keep(sum.off_the_law,
         std::abs(static_cast<double>(row.tunnelled) - expected) / std::sqrt(expected * (1 - *row.law)));
}

}  // namespace

std::vector<Summary> summaries(const Report& report)
{
    std::vector<Summary> all;
    for (const Row& row : report.rows) {
        const std::string who = who_in(report, row), name = who + (row.variant.empty() ? "" : ", " + row.variant);
        auto sum = std::find_if(all.begin(), all.end(), [&](const Summary& each) {
            return each.name == name && each.target == row.cell.target;
        });
        if (sum == all.end()) {
            sum = all.insert(all.end(), Summary{});
            sum->name = name;
            sum->who = who;
            sum->method = row.method;
            sum->target = row.cell.target;
        }
        add(*sum, row);
    }
    return all;
}

}  // namespace carom::tunnel
