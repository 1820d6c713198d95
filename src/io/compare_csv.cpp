#include "io/compare_files.hpp"
#include "io/numbers.hpp"

namespace carom::io {

namespace {

std::string integer(const std::optional<int>& value)
{
    return value ? std::to_string(*value) : std::string();
}

std::string line(const CompareRow& row)
{
    const std::string fields[] = {row.method,
                                  number_text(row.dt),
                                  integer(row.substeps),
                                  integer(row.passes),
                                  number_text(row.cpu_seconds),
                                  number_text(row.cpu_min),
                                  number_text(row.cpu_max),
                                  number_text(row.position_rms),
                                  number_text(row.position_max),
                                  number_text(row.position_final_rms),
                                  number_text(row.position_final_max),
                                  number_text(row.velocity_rms),
                                  number_text(row.energy_error),
                                  number_text(row.max_penetration),
                                  std::to_string(row.missed_impacts),
                                  std::to_string(row.invented_impacts),
                                  std::to_string(row.impacts),
                                  number_text(row.rest_jitter),
                                  number_text(row.divergence_time),
                                  number_text(row.reference_bound),
                                  std::to_string(row.steps),
                                  std::to_string(row.root_solves),
                                  std::to_string(row.pair_tests),
                                  name(row.status)};
    std::string text;
    for (const std::string& field : fields) text += (&field == fields ? "" : ",") + field;
    return text;
}

}  // namespace

std::string compare_csv(const Comparison& comparison)
{
    std::string text = std::string(compare_csv_header) + "\n";
    for (const CompareRow& row : comparison.rows) text += line(row) + "\n";
    return text;
}

}  // namespace carom::io
