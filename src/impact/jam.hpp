/// \file
/// Contacts whose normals leave no way out: a sphere between two parallel planes, a row of them between walls.
#pragma once

#include "projection/half_space.hpp"

namespace carom {

/// Marks a set of contacts of which no velocities open all, given that those marked already stay closed: the support
/// of mu >= 0 with sum mu = 1 and |sum mu_i a_i| <= 1e-7, a_i unit normals in the metric (Gordan's alternative).
/// Contacts that the marked ones hold closed are such a set, too.
/// \param asked contacts to look among, those that are marked included
/// \returns whether there was a new one
bool mark_jammed(const ProjectionProblem& problem, std::span<const int> asked, std::vector<char>& jammed);

}  // namespace carom
