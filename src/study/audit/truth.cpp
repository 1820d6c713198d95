#include "study/audit/truth.hpp"

#include "core/patience.hpp"
#include "study/audit/series.hpp"
#include "study/flight_state.hpp"
#include "study/tolerances.hpp"

#include <algorithm>

namespace carom::study {

namespace {

TruthState state_on(const TruthFlight& flight, double drag, double time)
{
    const double t = time - flight.start;
    return {place_after(flight.place, flight.velocity, flight.acceleration, drag, t),
            velocity_after(flight.velocity, flight.acceleration, drag, t)};
}

bool starts_after(double time, const TruthFlight& flight)
{
    return time < flight.start;
}

bool starts_before(const TruthFlight& flight, double time)
{
    return flight.start < time;
}

using Flights = std::vector<TruthFlight>;

/// The flight before the first that `later` points to; the first one if there is none before.
const TruthFlight& one_before(const Flights& flights, Flights::const_iterator later)
{
    return later == flights.begin() ? flights.front() : *std::prev(later);
}

/// Collects a run as it goes.
class TruthRecorder {
public:
    TruthRecorder(const Scene& scene, Truth& truth) : scene_(scene), truth_(truth)
    {
        truth_.flights.resize(scene.spheres.size());
        truth_.impact_times.resize(scene.spheres.size());
    }

    void frame(const RunFrame& frame)
    {
        frame_ = frame;
        truth_.drag = frame.drag;
    }

    void flight(const FlightRecord& record)
    {
        const double start = seconds_of(frame_, record.start);
        end_series(record.body, start);
        truth_.flights[static_cast<std::size_t>(record.body)].push_back(
            {start, place_of(frame_, record), vector_of(record.velocity), acceleration_of(frame_, record),
             record.mode == Mode::flying});
        ++recorded_;
        if (record.mode == Mode::series) open_series_.push_back({record.body, record.support, start, *record.series});
    }

    void event(const Event& event)
    {
        if (event.kind == EventKind::rest) ++truth_.persistent;
        if (event.kind != EventKind::impact) return;
        impacts_.push_back({event.time, event.a, event.b, 0});
        normals_.push_back(event.normal);
    }

    bool is_full() const { return recorded_ > most_truth_flights; }

    void finish(double until);

private:
    struct OpenSeries {
        BodyId body;
        std::int32_t plane;
        double start;
        SeriesRecord series;
    };

    /// Writes the body's series out up to `end`, if it is in one.
    void end_series(BodyId body, double end);
    void add(const TruthContact& contact, double closing_speed);
    TruthState seen(BodyId body, double time, bool before) const;

    const Scene& scene_;
    Truth& truth_;
    RunFrame frame_;
    double slow_ = rest_thresholds(scene_).closing_speed;
    std::size_t recorded_ = 0;
    std::vector<OpenSeries> open_series_;
    std::vector<TruthContact> impacts_;
    std::vector<Vec3> normals_;
};

void TruthRecorder::end_series(BodyId body, double end)
{
    const auto open = std::find_if(open_series_.begin(), open_series_.end(),
                                   [&](const OpenSeries& each) { return each.body == body; });
    if (open == open_series_.end()) return;
    auto& flights = truth_.flights[static_cast<std::size_t>(body)];
    const Plane& plane = scene_.planes[static_cast<std::size_t>(open->plane)];
    const Vec3 place = flights.back().place;
    flights.pop_back();
    const bool is_behind = plane.thickness && plane.normal.dot(place) < plane.offset;
    const WrittenSeries written =
        write_out(open->series, {open->start, place, is_behind ? -plane.normal : plane.normal}, end, slow_);
    for (const SeriesBounce& bounce : written.bounces)
        add({bounce.time, body, scene_.plane_body(static_cast<std::size_t>(open->plane)), bounce.speed_change},
            bounce.closing_speed);
    flights.insert(flights.end(), written.flights.begin(), written.flights.end());
    recorded_ += written.flights.size();
    if (written.has_tail) ++truth_.slow;
    open_series_.erase(open);
}

void TruthRecorder::add(const TruthContact& contact, double closing_speed)
{
    for (const BodyId body : {contact.a, contact.b})
        if (static_cast<std::size_t>(body) < scene_.spheres.size())
            truth_.impact_times[static_cast<std::size_t>(body)].push_back(contact.time);
    if (closing_speed < slow_ || !(contact.speed_change > 0))
        ++truth_.slow;
    else
        truth_.contacts.push_back(contact);
}

TruthState TruthRecorder::seen(BodyId body, double time, bool before) const
{
    if (static_cast<std::size_t>(body) >= scene_.spheres.size()) return {};
    return before ? truth_.state_before(body, time) : truth_.state(body, time);
}

void TruthRecorder::finish(double until)
{
    truth_.until = until;
    for (std::size_t i = 0; i < scene_.spheres.size(); ++i) {
        end_series(static_cast<BodyId>(i), until);
        // A run that is refused shows no flight: what is known of a body is its start, and nobody is asked about it.
        const Sphere& sphere = scene_.spheres[i];
        if (truth_.flights[i].empty()) truth_.flights[i] = {{0, sphere.position, sphere.velocity, Vec3::Zero(), false}};
    }
    for (std::size_t k = 0; k < impacts_.size(); ++k) {
        TruthContact& contact = impacts_[k];
        const Vec3 before = seen(contact.a, contact.time, true).velocity - seen(contact.b, contact.time, true).velocity;
        const Vec3 after =
            seen(contact.a, contact.time, false).velocity - seen(contact.b, contact.time, false).velocity;
        contact.speed_change = (after - before).norm();
        add(contact, -normals_[k].dot(before));
    }
    std::stable_sort(truth_.contacts.begin(), truth_.contacts.end(),
                     [](const TruthContact& x, const TruthContact& y) { return x.time < y.time; });
    for (auto& times : truth_.impact_times) std::sort(times.begin(), times.end());
}

}  // namespace

TruthState Truth::state(BodyId body, double time) const
{
    const Flights& own = flights[static_cast<std::size_t>(body)];
    return state_on(one_before(own, std::upper_bound(own.begin(), own.end(), time, starts_after)), drag, time);
}

TruthState Truth::state_before(BodyId body, double time) const
{
    const Flights& own = flights[static_cast<std::size_t>(body)];
    return state_on(one_before(own, std::lower_bound(own.begin(), own.end(), time, starts_before)), drag, time);
}

bool Truth::is_quiet(BodyId body, double begin, double end) const
{
    const Flights& own = flights[static_cast<std::size_t>(body)];
    const auto next = std::upper_bound(own.begin(), own.end(), begin, starts_after);
    return one_before(own, next).is_free && (next == own.end() || next->start > end);
}

bool Truth::is_alone(BodyId body, double begin, double end, double time) const
{
    const Flights& own = flights[static_cast<std::size_t>(body)];
    if (!(begin < time && time <= end)) return false;
    // The first flight of the run begins with nothing that happens: it came from somewhere.
    auto next = std::max(std::upper_bound(own.begin(), own.end(), begin, starts_after), std::next(own.begin()));
    if (!std::prev(next)->is_free) return false;
    for (; next != own.end() && next->start <= end; ++next)
        if (next->start != time || !next->is_free) return false;
    const auto& times = impact_times[static_cast<std::size_t>(body)];
    return std::upper_bound(times.begin(), times.end(), end) - std::lower_bound(times.begin(), times.end(), begin) == 1;
}

Truth record_truth(const Scene& scene, double until, const OnProgress& on_progress)
{
    Truth truth;
    Patience patience(on_progress);
    patience.begin("truth of the audit", until);
    TruthRecorder recorder(scene, truth);
    Observer observer;
    observer.on_frame = [&](const RunFrame& frame) { recorder.frame(frame); };
    observer.on_flight = [&](const FlightRecord& flight) { recorder.flight(flight); };
    observer.on_event = [&](const Event& event) { recorder.event(event); };
    observer.on_progress = [&](double time) { return patience.lasts(time) && !recorder.is_full(); };
    const Outcome outcome = simulate(scene, EventDriven{}, {.until = until}, observer);
    recorder.finish(outcome.time);
    truth.stopped = patience.ended();
    if (outcome.status != Status::interrupted) {
        truth.status = outcome.status;
        truth.message = outcome.message;
    }
    return truth;
}

}  // namespace carom::study
