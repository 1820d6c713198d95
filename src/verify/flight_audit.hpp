/// \file
/// Can this flight be? Numbers in range, an acceleration and a mode that go with each other, and at the start the
/// place and speed that the scene says.
#pragma once

#include "verify/findings.hpp"
#include "verify/flights.hpp"

#include <optional>

namespace carom::verification {

/// In the verifier's units; none if no path can be made of it, which ends the examination.
struct Accepted {
    Path path;
    std::optional<SeriesRecord> series;
};
std::optional<Accepted> accept(const RunData& data, Findings& findings, const FlightRecord& flight);

/// The first flight of a body. \returns by how much its velocity is not the scene's, beyond rounding, if only contacts
/// that open can tell why [cells/epoch]
std::optional<Vec3> check_first(const RunData& data, Findings& findings, BodyId body, const Path& path);
/// Is that what such contacts do? \param normals of those that are closed \param speeds the largest of the start
void check_first_speed(const RunData& data, Findings& findings, BodyId body, const Vec3& off,
                       std::span<const Vec3> normals, double speeds);

/// Is the moment one that can be? 0 <= offset < 1, a number of epochs that doubles hold exactly.
bool is_moment(const EpochTime& t);

}  // namespace carom::verification
