/// \file
/// Polynomials with exact coefficients: signs at points, and at roots that no number of digits would give.
#pragma once

#include "math/dyadic.hpp"

#include <utility>
#include <vector>

namespace carom {

/// A point of time: a double, and a rest for points between two doubles.
struct Point {
    double value = 0;
    Dyadic rest;  ///< most often 0

    Dyadic exact() const { return Dyadic(value) + rest; }
    bool is_double() const { return rest.sign() == 0; }
};
bool operator==(const Point& a, const Point& b);
/// The point halfway between two, to the last bit.
Point between(const Point& a, const Point& b);

/// A polynomial c[0] + c[1] x + ...
class ExactPolynomial {
public:
    ExactPolynomial() = default;
    explicit ExactPolynomial(std::vector<Dyadic> coefficients);

    const std::vector<Dyadic>& coefficients() const { return c_; }
    /// The degree; -1 for the zero polynomial.
    int degree() const { return static_cast<int>(c_.size()) - 1; }
    ExactPolynomial derivative() const;

    /// The sign at a point, always right: in double-double where its bound tells, else exactly. \pre x >= 0
    int sign(const Point& x) const;
    /// The value at a point, to the rounding of double-double, in a unit in which the largest coefficient is of order
    /// 1.
    DoubleDouble value(double x) const;
    /// Exponent of that unit, 2^unit.
    int unit() const { return unit_; }

    friend ExactPolynomial operator*(const ExactPolynomial& a, const ExactPolynomial& b);
    /// The remainder -(a mod b), times a positive number. \pre b != 0
    friend ExactPolynomial negative_remainder(const ExactPolynomial& a, const ExactPolynomial& b);

private:
    int exact_sign(const Dyadic& x) const;

    std::vector<Dyadic> c_;              ///< the last one is not 0
    std::vector<DoubleDouble> rounded_;  ///< in units of 2^unit_
    int unit_ = 0;
};

/// An interval of points that contains one root; if both ends are one point, that is the root.
struct Isolated {
    Point low, high;

    bool is_point() const { return low == high; }
};

/// The sign of `q` at the one root of `g` in `where`: a Tarski query, that is, Sturm's theorem for g and g' q.
/// \pre g is not 0 at the ends unless they are the root (Basu, Pollack, Roy, Algorithms in Real Algebraic Geometry,
/// theorem 2.61)
int sign_at_root(const ExactPolynomial& g, const ExactPolynomial& q, const Isolated& where);

/// Halves an interval on whose ends g has opposite signs.
void halve(const ExactPolynomial& g, Isolated& where);

/// A guess of the root in such an interval, as Newton's iteration in double-double finds it.
double root_guess(const ExactPolynomial& g, const Isolated& where);

/// Shrinks such an interval to two neighbouring doubles, or to the root if it is a double.
/// \param guess of the root; a good one saves time \pre both ends are doubles
Isolated neighbours(const ExactPolynomial& g, const Isolated& where, double guess);

}  // namespace carom
