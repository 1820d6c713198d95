/// \file
/// A spring and a damper between two surfaces that overlap, and what they make of two bodies alone: with reduced mass m
/// the overlap x obeys m x" + c x' + k x = 0 from x = 0 until it is 0 again, half a period of a damped oscillation.
/// With omega = sqrt(k/m), zeta = c / (2 m omega): it lasts pi / (omega sqrt(1 - zeta^2)), and the bodies part with
/// e = exp(-pi zeta / sqrt(1 - zeta^2)) of the speed with which they met.
#pragma once

namespace carom::stepping {

/// Damping ratio zeta of a spring after which two bodies part with `restitution` of their speed: -ln e / sqrt(pi^2 +
/// ln^2 e); 1, critical, for restitution 0: they never part, nor overshoot. \pre restitution in [0, 1]
double damping_ratio(double restitution);

/// Longest step [time] in which the spring does not gain energy by itself, 2 (sqrt(1 + zeta^2) - zeta) / omega; without
/// damping 2 / omega = 2 / sqrt(k/m). The map of a step, v += h (-omega^2 x - 2 zeta omega v), x += h v, has
/// determinant 1 - 2 zeta omega h and trace 2 - 2 zeta omega h - (omega h)^2; both eigenvalues are in the unit circle
/// while -trace < 1 + determinant (Jury). The same holds of leapfrog with the forces at velocities half a step earlier.
/// \param frequency omega [1/time]
double stable_step(double frequency, double damping_ratio);

}  // namespace carom::stepping
