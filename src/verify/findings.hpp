/// \file
/// The certificate while it is being written.
#pragma once

#include "verify/run_data.hpp"

namespace carom::verification {

class Findings {
public:
    Findings(Certificate& certificate, const Units& units, std::size_t most)
        : out(certificate), units_(units), most_(most)
    {
    }

    void violation(std::string what, const EpochTime& at, BodyId a = no_body, BodyId b = no_body)
    {
        ++out.violated;
        if (out.violations.size() < most_) out.violations.push_back({std::move(what), units_.seconds(at), a, b});
    }
    static void keep_largest(double& largest, double value)
    {
        if (value > largest) largest = value;
    }

    Certificate& out;

private:
    const Units& units_;
    std::size_t most_;
};

/// A number for a message.
std::string figure(double value);

}  // namespace carom::verification
