/// \file
/// Frames of a run as CSV, written while it goes: an interrupted run leaves whole frames.
#pragma once

#include <carom/simulate.hpp>

#include <iosfwd>
#include <span>
#include <string>
#include <vector>

namespace carom::io {

inline constexpr const char* frames_csv_header = "t,id,x,y,z";

class FramesCsv {
public:
    /// Writes the header. `out` must outlive the writer.
    FramesCsv(std::ostream& out, const Scene& scene);
    /// One row for each sphere; places are relative to the scene's origin, as those of the scene's file are.
    void write(double time, std::span<const BodyState> states);

private:
    std::ostream& out_;
    std::vector<std::string> ids_;  ///< as fields
};

}  // namespace carom::io
