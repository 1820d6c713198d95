#include "study/cost_ratio.hpp"

#include "study/words.hpp"

#include <algorithm>

namespace carom::study {

std::optional<Ratio> cost_ratio(const Comparison& comparison, const CompareRow& row)
{
    const auto event =
        std::find_if(comparison.rows.begin(), comparison.rows.end(), [](const CompareRow& each) { return !each.dt; });
    if (event == comparison.rows.end() || event->status != Status::reached_end || !(event->cpu_seconds > 0))
        return std::nullopt;
    const double value = row.cpu_seconds / event->cpu_seconds;
    if (&row == &*event || !(event->cpu_low > 0)) return Ratio{value, value, value};
    return Ratio{value, row.cpu_low / event->cpu_high, row.cpu_high / event->cpu_low};
}

std::string ratio_text(const Ratio& ratio)
{
    const std::string low = two_digits(ratio.low), high = two_digits(ratio.high);
    return two_digits(ratio.value) + (low == high ? "" : " (" + low + "-" + high + ")");
}

}  // namespace carom::study
