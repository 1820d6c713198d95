/// \file
/// The pair law of all contacts at once, again and again. For teaching: impulses that should share a body's motion add
/// up instead, so that energy may be gained.
///
/// Guarantee: impulses push, momentum is kept, symmetric scenes stay symmetric, and where it ends nothing closes.
/// Energy is not kept. After 100 + 10 m rounds, or with a million times the energy, the response is the inelastic one.
#pragma once

#include "impact/operators.hpp"

namespace carom {

NormalImpact jacobi(const Cluster& cluster);

}  // namespace carom
