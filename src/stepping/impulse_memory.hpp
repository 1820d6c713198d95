/// \file
/// The impulses of the step before, with which a solver begins: what rests needs the same ones again ("warm starting":
/// Catto, Iterative dynamics with temporal coherence, 2005).
#pragma once

#include "stepping/contact.hpp"

#include <utility>
#include <vector>

namespace carom::stepping {

class ImpulseMemory {
public:
    /// Normal impulse that this contact had, 0 if it had none [mass length/time].
    double recall(const Contact& contact) const;

    /// Forget all, and remember these rows, those for which lasts(row): an impact is not to be repeated. A row has a
    /// `contact` and an `impulse`.
    template <class Rows, class Lasts>
    void keep(const Rows& rows, Lasts&& lasts)
    {
        entries_.clear();
        for (const auto& row : rows)
            if (row.impulse > 0 && lasts(row)) entries_.push_back({{row.contact.a, row.contact.b}, row.impulse});
        sort();
    }

private:
    struct Entry {
        std::pair<BodyId, BodyId> bodies;
        double impulse;
    };
    void sort();

    std::vector<Entry> entries_;  ///< by bodies
};

}  // namespace carom::stepping
