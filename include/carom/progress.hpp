/// \file
/// Progress of long work: it is told now and then to a function, whose answer says whether to go on.
#pragma once

#include <exception>
#include <functional>
#include <string>

namespace carom {

/// The stage that long work has come to.
struct Progress {
    std::string stage;    ///< "reference", "overlaps": amount and fraction begin anew with each
    std::string what;     ///< what is being done in the stage, for people; may change within it
    double fraction = 0;  ///< of the stage, in [0, 1]
    double amount = 0;    ///< of the stage so far, in `unit`, for a rate
    std::string unit;     ///< "spheres"; empty: nothing is counted
};

/// Called now and then, many times a second; false stops the work. An empty function never does. It must be cheap.
using OnProgress = std::function<bool(const Progress&)>;

/// Thrown at the border, by readers, where OnProgress stopped what has no half result.
class Stopped : public std::exception {
public:
    const char* what() const noexcept override { return "stopped on request"; }
};

}  // namespace carom
