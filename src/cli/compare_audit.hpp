/// \file
/// The one-step audit on the terminal.
#pragma once

#include <carom/study.hpp>

#include <string>

namespace carom::cli {

/// "27 %", "0"; "-" without a row's audit or where nothing was asked.
std::string share_cell(const std::optional<Audit>& audit, std::int64_t Audit::*part,
                       std::int64_t Audit::*whole = &Audit::audited);
/// "27 % (25-29)", with the interval of 95 %.
std::string share_with_interval(const std::optional<Audit>& audit, std::int64_t Audit::*part);
/// Line on what was asked about and what was not, with its end; empty without an audit.
std::string audit_line(const Comparison& comparison);

}  // namespace carom::cli
