/// \file
/// The one exception type of carom. It is thrown at the border only, by readers and by validation: bad input with its
/// place and its cure. Numerical outcomes are statuses in results, never exceptions.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace carom {

class InputError : public std::runtime_error {
public:
    /// \param problems one line each: "FILE: JSON-POINTER: what is wrong (the cure)"; not empty.
    explicit InputError(std::vector<std::string> problems);
    /// One line each; what() is all of them.
    const std::vector<std::string>& problems() const { return problems_; }

private:
    std::vector<std::string> problems_;
};

}  // namespace carom
