/// \file
/// Multiprecision numbers, vectors of them, and a flight: the arithmetic of the reference, apart from the engine's on
/// purpose.
#pragma once

#include <boost/multiprecision/mpfr.hpp>

#include <carom/types.hpp>

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

/// What is below 1e-30 of its scale is rounding, not data: 50 digits leave errors near 1e-50, the scene's doubles come
/// in steps of 1e-16.
template <class Real>
Real snapped(const Real& value, const Real& scale)
{
    return abs(value) <= 1e-30 * scale ? Real(0) : value;
}

template <class Real>
struct Flight {
    Real t = 0;  ///< its start, since the start of the run [time]
    Vector<Real> x, v, a;

    Vector<Real> position(const Real& at) const { return x + (v + a * ((at - t) / 2)) * (at - t); }
    Vector<Real> velocity(const Real& at) const { return v + a * (at - t); }
};

}  // namespace carom::reference
