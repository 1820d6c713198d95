/// \file
/// Rows that differ in their step alone.
#pragma once

#include <carom/study.hpp>

#include <optional>
#include <string>
#include <tuple>

namespace carom::study {

/// Settings that the rows of a family have in common.
using Family = std::tuple<std::string, std::optional<int>, std::optional<int>, std::optional<ContactOrder>,
                          std::optional<Integrator>>;

inline Family family_of(const CompareRow& row)
{
    return {row.method, row.substeps, row.passes, row.order, row.integrator};
}

}  // namespace carom::study
