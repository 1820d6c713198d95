/// \file
/// A sum that keeps what rounding would lose.
#pragma once

#include <cmath>

namespace carom::study {

/// Neumaier's variant of Kahan summation (Neumaier, Zeitschrift fuer Angewandte Mathematik und Mechanik 54, 1974): the
/// error of the sum does not grow with the number of terms.
class CompensatedSum {
public:
    void add(double x)
    {
        const double sum = sum_ + x;
        compensation_ += std::abs(sum_) >= std::abs(x) ? (sum_ - sum) + x : (x - sum) + sum_;
        sum_ = sum;
    }
    double value() const { return std::isfinite(compensation_) ? sum_ + compensation_ : sum_; }

private:
    double sum_ = 0, compensation_ = 0;
};

}  // namespace carom::study
