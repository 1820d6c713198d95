#include "study/verdict_words.hpp"

#include "study/cost_ratio.hpp"
#include "study/words.hpp"

#include <cmath>

namespace carom::study {

std::optional<double> verdict_error(const CompareRow& row)
{
    return row.position_max;
}

std::int64_t lost_impacts(const CompareRow& row)
{
    return row.missed_impacts - row.mistimed_impacts;
}

bool holds(const CompareRow& row, double tolerance)
{
    const std::optional<double> error = verdict_error(row);
    return row.status == Status::reached_end && error && *error <= tolerance && lost_impacts(row) == 0;
}

VerdictWords::VerdictWords(const Scene& scene, const Comparison& comparison) : scene_(scene), comparison_(comparison)
{
    for (const CompareRow& row : comparison.rows)
        if (!row.dt && event_ == nullptr) event_ = &row;
}

std::string VerdictWords::length(double value) const
{
    return length_text(value, scene_.units.length);
}

std::string VerdictWords::time(double value) const
{
    return time_text(value, scene_.units.time);
}

std::string VerdictWords::tolerance() const
{
    return "a position error of " + length(comparison_.tolerance);
}

std::string VerdictWords::while_known() const
{
    const double end = comparison_.reference.until;
    return end < comparison_.until ? " up to t = " + time(end) : "";
}

std::string VerdictWords::cost(const CompareRow& row) const
{
    const std::optional<Ratio> ratio = cost_ratio(comparison_, row);
    return ratio ? ratio_text(*ratio) + " times the event run" : seconds_text(row.cpu_seconds) + " of CPU";
}

std::string VerdictWords::setting(const CompareRow& row)
{
    return step_text(*row.dt) + variant_text(row);
}

std::string VerdictWords::share(std::int64_t part, const CompareRow& row)
{
    return std::to_string(part) + " of " + std::to_string(row.reference_impacts) + " impacts";
}

std::string VerdictWords::fault(const CompareRow& row) const
{
    const std::optional<double> error = verdict_error(row);
    if (row.status != Status::reached_end) return std::string("ends with ") + name(row.status);
    if (!error) return "has no reference to be measured by";
    if (!std::isfinite(*error)) return "blows up";
    if (*error > comparison_.tolerance) return "is off by " + length(*error);
    return "misses " + share(lost_impacts(row), row);
}

}  // namespace carom::study
