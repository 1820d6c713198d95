/// \file
/// Answers of the impact operators to one instant of several contacts.
#pragma once

#include "reference/impact.hpp"
#include "reference/reference.hpp"

namespace carom::reference {

template <class Real>
ReferenceConvention convention(const Group<Real>& g, const std::vector<Vector<Real>>& v, LcpLaw law, const Real& t,
                               Patience& patience)
{
    ReferenceConvention out{static_cast<double>(t), {}, {}, false};
    std::vector<std::size_t> order = first(g.bodies.size());
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return g.bodies[a] < g.bodies[b]; });
    for (const std::size_t k : order) out.bodies.push_back(g.bodies[k]);
    const Real scale = largest(v);
    std::vector<Vector<Real>> first_answer;
    for (const ImpactOperator which : {ImpactOperator::reflections, ImpactOperator::sequential, ImpactOperator::lcp}) {
        std::vector<Vector<Real>> after = v;
        impact_together(g, after, which, law, patience);
        if (out.answers.empty()) first_answer = after;
        ReferenceConvention::Answer answer{which, {}};
        for (const std::size_t k : order) {
            answer.velocities.push_back(after[k].rounded());
            out.differ = out.differ || size(after[k] - first_answer[k]) > other_outcome * scale;
        }
        out.answers.push_back(std::move(answer));
    }
    return out;
}

}  // namespace carom::reference
