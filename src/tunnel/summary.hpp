/// \file
/// The matrix summed up by contestant and target.
#pragma once

#include "tunnel/study.hpp"

#include <optional>
#include <string>
#include <vector>

namespace carom::tunnel {

struct Summary {
    std::string name;  ///< method, integrator where a report has both, variant
    std::string who;   ///< the same without the variant
    std::string method;
    Target target = Target::plate;
    std::int64_t cells = 0, trials = 0, tunnelled = 0, wrong = 0;
    std::optional<double> worst_error;   ///< in radii of the ball
    std::optional<double> tunnels_from;  ///< lowest v dt / reach at which a throw tunnelled
    /// Largest distance of a share from the law, in standard deviations, of cells in which the law expects at least
    /// five throws of either kind; none without such a cell.
    std::optional<double> off_the_law;
};

/// In the order of the rows.
std::vector<Summary> summaries(const Report& report);

/// The result in sentences; the first says whether `event` hit in every throw.
std::vector<std::string> verdict(const Report& report);

}  // namespace carom::tunnel
