/// \file
/// The rows of a recording's table `bodies`: spheres, planes, materials and contact rules as columns, ids as JSON.
#pragma once

#include "io/recording_format.hpp"

namespace carom::io {

std::vector<BodiesRow> bodies_rows(const Scene& scene);
/// Kinds of the rows, in their order.
const std::vector<std::string>& bodies_kinds();

/// The largest count of a row that a reader accepts: constant columns of any length take a few bytes of the file.
std::int64_t most_in_row(const std::string& kind);
/// \throws InputError if a row is not what its kind says, or a value is out of range
void read_bodies_row(RecordedRun& run, const BodiesRow& row, const std::string& file);
/// After all rows: do indices point at something?
void check_bodies(const RecordedRun& run, const std::string& file);
/// The ids in a row of kind sphere_ids or plane_ids.
std::vector<std::string> ids_of(const BodiesRow& row, const std::string& file);

/// Vectors as bytes, 3 doubles each.
Bytes bytes_of(std::span<const Vec3> vectors);
std::vector<Vec3> vectors_of(std::span<const unsigned char> bytes, const std::string& file);

}  // namespace carom::io
