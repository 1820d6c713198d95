/// \file
/// The rows of a trace, gathered into frames: t,id,x,y,z in any order of columns, others and lines that begin with #
/// left alone.
#pragma once

#include "audit/trace.hpp"

#include <carom/scene.hpp>

#include <array>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace carom::io {

/// The fields of a line of CSV (RFC 4180), spaces around them taken off. \param fields are replaced
void split_fields(std::string_view line, std::vector<std::string>& fields);

class TraceRows {
public:
    /// Reads the header. \throws InputError "FILE:LINE: what is wrong (the cure)", so does `next`
    TraceRows(const std::filesystem::path& file, const Scene& scene);

    /// The next frame; false at the end. Bodies may come in any order, fixed ones may be left out.
    bool next(audit::Frame& frame);

    /// Digits of what was read so far.
    const audit::Rounding& places() const { return places_; }
    const audit::Rounding& times() const { return times_; }
    std::size_t bytes_read() const { return bytes_; }

private:
    struct Row {
        std::size_t line = 0;
        std::size_t sphere = 0;
        double time = 0;
        Vec3 place = Vec3::Zero();
    };

    bool read_line();
    void read_header();
    bool read_row();
    double number(std::size_t column, audit::Rounding& rounding);
    std::size_t sphere_of(const std::string& id) const;
    void enter(audit::Frame& frame);
    void check_complete(const audit::Frame& frame) const;
    [[noreturn]] void fail(std::size_t line, const std::string& what) const;

    const Scene& scene_;
    std::string file_;
    std::ifstream stream_;
    std::string line_;
    std::size_t line_number_ = 0, bytes_ = 0, columns_ = 0;
    std::array<std::size_t, 5> column_{};  ///< of t, id, x, y, z
    std::vector<std::string> fields_;
    std::unordered_map<std::string, std::size_t> spheres_;
    Row row_;  ///< read, but not in a frame yet
    bool has_row_ = false;
    std::vector<std::size_t> seen_at_;  ///< by sphere: line of its row in the frame, 0 for none
    std::size_t frame_line_ = 0;
    audit::Rounding places_, times_;
};

}  // namespace carom::io
