/// \file
/// A contact that gives: a velocity constraint with the factors of an implicit damped spring (Catto, Soft constraints,
/// GDC 2011; Box2D's b2MakeSoft).
#pragma once

namespace carom::stepping {

/// The impulse that a solver adds is -mass_scale m (c + bias_rate s) - impulse_scale (impulse so far), with the mass m
/// that the contact meets, its normal velocity c, its gap s < 0.
struct Softness {
    double bias_rate = 0;      ///< [1/time]
    double mass_scale = 1;     ///< [1]
    double impulse_scale = 0;  ///< [1]
};

/// Implicit Euler of s" + 2 zeta omega s' + omega^2 s = 0 over a substep h, omega = 2 pi hertz: one body alone ends the
/// substep with exactly its velocity. \pre hertz > 0, damping_ratio >= 0, h > 0
Softness make_softness(double hertz, double damping_ratio, double h);

}  // namespace carom::stepping
