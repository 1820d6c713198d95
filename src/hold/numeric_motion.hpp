/// \file
/// A numeric cluster as the engine sees it: a part of a component in, one piece of motion for each body out.
#pragma once

#include "gather/component.hpp"

#include <functional>

namespace carom {

struct NumericMotion {
    std::vector<Stepping> pieces;  ///< by body of the part
    std::vector<double>
        mean_forces;        ///< by contact of the component, 0 for those that take no part [mass length/time^2]
    double correction = 0;  ///< [energy]
    std::vector<std::size_t>
        opened;        ///< contacts of the component, see NumericStep; if there are any, the rest is of no use
    double depth = 0;  ///< overlap of the parabolas, >= 0: where a cubic would stray most [length]
};

/// When the contact of a key closes, where one of its bodies is on a numeric piece: predictions see the parabola that
/// stands for the piece, and may come a little late. Not before `earliest`, not after the key's time.
EpochTime time_of_contact(const State& state, const Key& key, const EpochTime& earliest);

/// One step of rest.numeric_step; less if a contact opens, or where the last ones were cut short by impacts.
/// \param part bodies of the component that move, ascending; what they touch and does not move takes part as if it were
/// fixed
/// \param held contacts that persist, those of other bodies among them
/// \param force of a contact as the step begins [mass length/time^2]
/// \param opening see NumericCluster
NumericMotion numeric_motion(const State& state, const ContactComponent& component, std::span<const std::size_t> part,
                             std::span<const std::size_t> held, const std::function<double(std::size_t)>& force,
                             const EpochTime& now, double opening);

}  // namespace carom
