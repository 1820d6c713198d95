/// \file
/// Broad phase for few spheres: everybody is a neighbour of everybody.
#pragma once

#include <carom/types.hpp>

namespace carom {

class AllPairs {
public:
    static constexpr bool has_cells = false;

    explicit AllPairs(BodyId count) : count_(count) {}

    template <class Visit>
    void neighbours(BodyId body, Visit&& visit) const
    {
        for (BodyId other = 0; other < body; ++other) visit(other);
        for (BodyId other = body + 1; other < count_; ++other) visit(other);
    }

private:
    BodyId count_;
};

}  // namespace carom
