/// \file
/// Events as CSV, written while the run goes: an interrupted run leaves whole lines.
#pragma once

#include <carom/event.hpp>
#include <carom/scene.hpp>

#include <iosfwd>
#include <string>

namespace carom::io {

inline constexpr const char* events_csv_header = "t,kind,a,b,nx,ny,nz,jx,jy,jz";

/// One line, without its end. Bodies by their ids; t exact for event-driven runs.
/// \param exact the event has its exact moment (`Event::at`); otherwise `Event::time` is written.
std::string event_line(const Scene& scene, const Event& event, bool exact);

class EventsCsv {
public:
    /// Writes the header. `scene` and `out` must outlive the writer.
    EventsCsv(std::ostream& out, const Scene& scene, bool exact);
    void write(const Event& event);

private:
    std::ostream& out_;
    const Scene& scene_;
    bool exact_;
};

}  // namespace carom::io
