/// \file
/// The tangential factor in clusters: v_t <- alpha v_t of the contacts that got an impulse.
#pragma once

#include "contact/contact.hpp"

#include <span>
#include <vector>

namespace carom {

/// Impulses -(1 - alpha) m_red v_t on the relative tangential velocities v_t, all at once. Where a body has k contacts
/// with an impulse each acts at 1/k (ours): so the sum takes energy and never gives it, and no order matters. With one
/// contact this is the pair law.
/// \param impulses by contact, along the normal
/// \returns by contact, on a
std::vector<Vec3> tangential_impulses(const ContactProblem& cluster, const std::vector<Vec3>& velocities,
                                      std::span<const double> impulses);

}  // namespace carom
