/// \file
/// Multiprecision numbers and vectors of them: the arithmetic of the reference, apart from the engine's on
/// purpose.
#pragma once

#include <boost/multiprecision/mpfr.hpp>

#include <carom/types.hpp>

#include "reference/limits.hpp"

namespace carom::reference {

namespace mp = boost::multiprecision;
/// Decimal digits fixed at compile time and no allocation: a reference run makes some 1e8 of these.
template <unsigned Digits>
using Decimal = mp::number<mp::mpfr_float_backend<Digits, mp::allocate_stack>, mp::et_off>;

template <class Real>
struct Vector {
    Real x = 0, y = 0, z = 0;

    Vector() = default;
    Vector(const Real& x_in, const Real& y_in, const Real& z_in) : x(x_in), y(y_in), z(z_in) {}
    explicit Vector(const Vec3& v) : x(v.x()), y(v.y()), z(v.z()) {}

    Vector operator+(const Vector& b) const { return {x + b.x, y + b.y, z + b.z}; }
    Vector operator-(const Vector& b) const { return {x - b.x, y - b.y, z - b.z}; }
    Vector operator*(const Real& s) const { return {x * s, y * s, z * s}; }
    Vec3 rounded() const { return {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)}; }
};

template <class Real>
Real dot(const Vector<Real>& a, const Vector<Real>& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// A length of v that needs no square root: between |v| and sqrt(3) |v|.
template <class Real>
Real size(const Vector<Real>& v)
{
    return abs(v.x) + abs(v.y) + abs(v.z);
}

/// 0 for what is rounding, not data, of its scale.
template <class Real>
Real snapped(const Real& value, const Real& scale)
{
    return abs(value) <= rounding * scale ? Real(0) : value;
}

}  // namespace carom::reference
