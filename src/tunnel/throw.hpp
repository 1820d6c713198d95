/// \file
/// One throw: a scene that begins a random part of a step before a contact, and the truth two steps after its begin.
#pragma once

#include "tunnel/cell.hpp"

#include <carom/scene.hpp>

#include <cstdint>

namespace carom::tunnel {

/// The random part of a throw at a cell's target.
struct Aim {
    double phase = 1;   ///< part of a step from the begin to the contact, in (0, 1]
    double offset = 0;  ///< of the ball's path from the middle of a sphere, in radius + sphere's radius, in [0, 1)
};

struct Throw {
    Scene scene;                         ///< as it is at the begin
    BodyId body = 0, partner = no_body;  ///< who is thrown, and whom it meets
    double contact_time = 0;             ///< since the begin, > 0 [time]
    double speed_change = 0;             ///< |dv| of the contact [length/time]
    double exact_time = 0;               ///< error of the contact time that counts as none, of an exact method [time]
    Vec3 position = Vec3::Zero(), velocity = Vec3::Zero();  ///< true, of the body, two steps after the begin
    double steps_to_pass = 0;                               ///< that a free ball takes to leave the target behind
};

/// Throws at the target of a cell, along +x: no gravity, e = 1, the middle of the target at the origin.
class CellThrows {
public:
    explicit CellThrows(const Cell& cell);
    /// The throw with that aim, valid until the next one.
    const Throw& at(const Aim& aim);

private:
    Cell cell_;
    double reach_;  ///< at a central contact [length]
    Throw throw_;
};

/// Seed's stream of a cell: it depends on what the cell is, so that it has the same throws in every matrix.
std::uint64_t stream_of(const Cell& cell);

}  // namespace carom::tunnel
