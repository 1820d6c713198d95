/// \file
/// A numeric cluster as the engine sees it: flights and contacts in, one piece of motion for each body out.
#pragma once

#include "event_driven/component.hpp"

namespace carom {

struct NumericPart {
    struct Body {
        BodyId id;
        Flight flight;  ///< as it begins now
    };
    struct Contact {
        Touch touch;
        double force;  ///< as the step begins [mass length/time^2]
        Place other;   ///< of the sphere that is none of the bodies, if one is
    };
    std::vector<Body>
        bodies;  ///< ascending; whoever moves; what they touch and does not move takes part as if it were fixed
    std::vector<Contact> contacts;
};

struct NumericMotion {
    std::vector<Piece> pieces;        ///< by body
    std::vector<Vec3> accelerations;  ///< by body: of the parabola that stands for the piece [length/time^2]
    std::vector<double> forces;       ///< by contact, mean [mass length/time^2]
    double correction = 0;            ///< [energy]
    std::vector<std::size_t> opened;  ///< see NumericStep; if there are any, the rest is of no use
    double depth = 0;                 ///< overlap of the parabolas, >= 0: where a cubic would stray most [length]
};

/// When the contact of a key closes, where one of its bodies is on a numeric piece: predictions see the parabola that
/// stands for the piece, and may come a little late. Not before `earliest`, not after the key's time.
EpochTime time_of_contact(const State& state, const Key& key, const EpochTime& earliest);

/// One step of rest.numeric_step; less if a contact opens, or where the last ones were cut short by impacts. \param
/// opening see NumericCluster
NumericMotion numeric_motion(const State& state, const NumericPart& part, const EpochTime& now, double opening);

}  // namespace carom
