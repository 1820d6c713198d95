/// \file
/// Broad phase for few spheres: every sphere is a neighbour of every other.
#pragma once

#include <carom/types.hpp>

namespace carom {

class AllPairs {
public:
    static constexpr bool bodies_leave = false, has_lists = false;

    explicit AllPairs(BodyId count) : count_(count) {}

    template <class Visit>
    void neighbours(BodyId body, Visit&& visit) const
    {
        for (BodyId other = 0; other < body; ++other) visit(other);
        for (BodyId other = body + 1; other < count_; ++other) visit(other);
    }

    template <class Visit>
    void wide_neighbours(BodyId body, Visit&& visit) const
    {
        neighbours(body, visit);
    }

private:
    BodyId count_;
};

}  // namespace carom
