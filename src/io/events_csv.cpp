#include "io/events_csv.hpp"

#include "io/numbers.hpp"

#include <ostream>

namespace carom::io {

namespace {
std::string id_of(const Scene& scene, BodyId body)
{
    return body == no_body ? "" : csv_field(scene.body_name(body));
}
}  // namespace

std::string event_line(const Scene& scene, const Event& event, bool exact)
{
    std::string line = exact ? exact_time_text(event.at, implied_epoch_length(event)) : number_text(event.time);
    line.append(",").append(name(event.kind));
    line.append(",").append(id_of(scene, event.a)).append(",").append(id_of(scene, event.b));
    for (const Vec3* vector : {&event.normal, &event.impulse})
        for (int axis = 0; axis < 3; ++axis) line.append(",").append(number_text((*vector)[axis]));
    return line;
}

EventsCsv::EventsCsv(std::ostream& out, const Scene& scene, bool exact) : out_(out), scene_(scene), exact_(exact)
{
    out_ << events_csv_header << '\n';
}

void EventsCsv::write(const Event& event)
{
    out_ << event_line(scene_, event, exact_) << '\n';
}

}  // namespace carom::io
