/// \file
/// What the impact operators say of one instant of several contacts.
#pragma once

#include "reference/impact.hpp"
#include "reference/reference.hpp"

namespace carom::reference {

template <class Real>
ReferenceConvention convention(const Group<Real>& g, const std::vector<Vector<Real>>& v, LcpLaw law, const Real& t,
                               Patience& patience)
{
    ReferenceConvention out{static_cast<double>(t), g.bodies, {}, false};
    const Real scale = largest(v);
    std::vector<Vector<Real>> first_answer;
    for (const ImpactOperator which : {ImpactOperator::reflections, ImpactOperator::sequential, ImpactOperator::lcp}) {
        std::vector<Vector<Real>> after = v;
        impact_together(g, after, which, law, patience);
        if (out.answers.empty()) first_answer = after;
        ReferenceConvention::Answer answer{which, {}};
        for (std::size_t k = 0; k < after.size(); ++k) {
            answer.velocities.push_back(after[k].rounded());
            out.differ = out.differ || size(after[k] - first_answer[k]) > other_outcome * scale;
        }
        out.answers.push_back(std::move(answer));
    }
    return out;
}

}  // namespace carom::reference
