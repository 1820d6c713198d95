#include <carom/verify.hpp>

#include "core/patience.hpp"
#include "verify/coverage.hpp"
#include "verify/flight_audit.hpp"
#include "verify/impact_audit.hpp"

#include <bit>
#include <unordered_set>

namespace carom {

namespace verification {

namespace {

/// The event hash (docs/recording.md): FNV-1a 64 over seven words an event.
class EventHash {
public:
    void add(const Event& e)
    {
        word(static_cast<std::uint64_t>(e.kind));
        word((static_cast<std::uint64_t>(static_cast<std::uint32_t>(e.a)) << 32) | static_cast<std::uint32_t>(e.b));
        word(static_cast<std::uint64_t>(e.at.epoch));
        number(e.at.offset);
        for (int k = 0; k < 3; ++k) number(e.impulse[k]);
    }
    std::uint64_t value() const { return hash_; }

private:
    void number(double x) { word(x == 0 ? 0 : std::bit_cast<std::uint64_t>(x)); }
    void word(std::uint64_t w) { hash_ = (hash_ ^ w) * 0x100000001b3u; }

    std::uint64_t hash_ = 0xcbf29ce484222325u;
};

class Verification {
public:
    Verification(FlightSource& source, const VerifyOptions& options)
        : source_(source),
          patience_(options.on_progress),
          data_(source.run()),
          findings_(out_, data_.units, options.most_violations),
          coverage_(data_, flights_, findings_, patience_, options.all_pairs),
          audit_(data_, flights_, coverage_, findings_)
    {
        out_.spheres = data_.spheres();
        out_.planes = data_.planes();
        out_.certified = data_.run.certified;
        flights_.drag = data_.drag;
        flights_.reserve(data_.run.spheres.size());
    }

    Certificate go()
    {
        check_frame();
        patience_.begin("first flights", static_cast<double>(data_.spheres()), "spheres");
        Instant instant;
        bool understood = true;
        while (understood && wanted() && source_.next(instant)) understood = take(instant);
        if (!patience_.ended()) {
            patience_.begin("last flights", static_cast<double>(data_.spheres()), "spheres");
            if (understood)
                end();
            else if (covering_)
                coverage_.finish(now_);
        }
        if (patience_.ended()) {
            out_.stopped = true;
            out_.complete = false;
            now_ = covering_ ? coverage_.leave() : EpochTime{};
        }
        out_.until = data_.units.seconds(now_);
        out_.event_hash = hash_.value();
        return std::move(out_);
    }

private:
    bool has_all() const { return flights_.size() == data_.run.spheres.size(); }

    /// Drag is a number >= 0, and entry 0 of the table is zero; what else it may say shows where it is used.
    void check_frame()
    {
        if (!(data_.drag >= 0 && std::isfinite(data_.drag))) findings_.violation("the drag is out of range", {});
        // A small drag would be a way out of the promise of gaps >= 0.
        if (data_.run.certified && data_.drag != 0)
            findings_.violation("certified flights have drag, of which no sign is exact", {});
        const auto& table = data_.accelerations;
        if (table.empty() || !table.front().isZero(0))
            findings_.violation("the table of accelerations has no zero", {});
    }

    bool wanted()
    {
        // The flights of the start come in large parts.
        if (!covering_) return patience_.lasts(static_cast<double>(flights_.size()));
        patience_.reach(data_.units.seconds(now_));
        return patience_.lasts_for(instant_work);
    }

    /// False: what follows cannot be understood any more.
    bool take(const Instant& instant)
    {
        out_.events += static_cast<std::int64_t>(instant.events.size());
        out_.flights += static_cast<std::int64_t>(instant.flights.size());
        for (const Event& event : instant.events) hash_.add(event);
        if (instant.flights.empty()) return impossible("events that begin no flight");
        const EpochTime at = data_.units.moment(instant.flights.front().start);
        if (!is_moment(at)) return impossible("a time out of range");
        if (!has_all()) {
            if (at != EpochTime{} || !instant.events.empty())
                return impossible("something happens before all flights have begun");
            return begin(instant.flights);
        }
        if (at < now_) return impossible("time runs backwards");
        for (const FlightRecord& flight : instant.flights)
            if (data_.units.moment(flight.start) != at)
                return impossible("flights of one instant begin at several times");
        for (const Event& event : instant.events)
            if (!check_event(event, at)) return false;
        now_ = at;
        return change(instant);
    }

    bool impossible(const char* what, BodyId a = no_body)
    {
        findings_.violation(what, now_, a);
        return false;
    }

    bool begin(std::span<const FlightRecord> flights)
    {
        for (const FlightRecord& flight : flights) {
            if (has_all() || flight.body != static_cast<BodyId>(flights_.size()))
                return impossible("the flights of the start are not one for each sphere, in their order", flight.body);
            if (data_.units.moment(flight.start) != EpochTime{})
                return impossible("a first flight begins late", flight.body);
            const auto accepted = accept(data_, findings_, flight);
            if (!accepted) return false;
            if (accepted->series) return impossible("a first flight is a series", flight.body);
            if (const auto off = check_first(data_, findings_, flight.body, accepted->path))
                off_.emplace_back(flight.body, *off);
            largest_speed_ = std::max(largest_speed_, accepted->path.velocity.norm());
            flights_.add(accepted->path);
        }
        if (!has_all()) return true;
        source_.forget_starts();
        coverage_.begin();
        covering_ = true;
        if (patience_.ended()) return false;
        patience_.begin("flights", data_.run.end ? data_.run.end->time : 0, "time units");
        for (const auto& [body, off] : off_)
            check_first_speed(data_, findings_, body, off, coverage_.closed_normals(body, now_), largest_speed_);
        off_ = {};
        return true;
    }

    bool check_event(const Event& event, const EpochTime& at)
    {
        const BodyId bodies = data_.spheres() + data_.planes();
        if (data_.units.moment(event.at) != at)
            return impossible("an event is not at the time of the flights that it begins", event.a);
        const bool guard = event.kind == EventKind::guard;
        if (event.a < 0 || event.a >= data_.spheres() ||
            (guard ? event.b != no_body : event.b <= event.a || event.b >= bodies))
            return impossible("an event of bodies that are not there", event.a);
        if (!event.normal.allFinite() || !event.impulse.allFinite())
            return impossible("an event with a number out of range", event.a);
        return true;
    }

    bool change(const Instant& instant)
    {
        coverage_.advance(now_);
        if (patience_.ended()) return false;
        for (const FlightRecord& flight : instant.flights)
            if (flight.body < 0 || flight.body >= data_.spheres()) return impossible("a flight of nobody", flight.body);
        std::span<const Event> events = instant.events;
        for (std::span<const FlightRecord> left = instant.flights; !left.empty() || !events.empty();) {
            const std::size_t count = until_repeated(left);
            if (!change(events, left.first(count))) return false;
            left = left.subspan(count);
            events = {};
        }
        return true;
    }

    /// How many flights there are before one of a body that has begun one already. Without an event between them: two
    /// numeric pieces, the first of bodies that those of the second join. (The guard takes over in the same breath.)
    static std::size_t until_repeated(std::span<const FlightRecord> flights)
    {
        if (flights.size() <= few_flights) {
            for (std::size_t i = 1; i < flights.size(); ++i)
                for (std::size_t k = 0; k < i; ++k)
                    if (flights[k].body == flights[i].body && !flights[i].guarded) return i;
            return flights.size();
        }
        std::unordered_set<BodyId> seen;
        for (std::size_t i = 0; i < flights.size(); ++i)
            if (!seen.insert(flights[i].body).second && !flights[i].guarded) return i;
        return flights.size();
    }

    bool change(std::span<const Event> events, std::span<const FlightRecord> flights)
    {
        audit_.begin(events, flights, now_);
        for (const FlightRecord& flight : flights) {
            auto accepted = accept(data_, findings_, flight);
            if (!accepted) return false;
            coverage_.close(flight.body, now_);
            flights_.set(flight.body, accepted->path);
            flights_.series.erase(flight.body);
            if (accepted->series) flights_.series.emplace(flight.body, *accepted->series);
            coverage_.open(flight.body, now_);
            audit_.change(flight.body);
        }
        audit_.end();
        for (const FlightRecord& flight : flights) coverage_.check_support(flight.body, now_, Coverage::Edge::begins);
        return true;
    }

    void end()
    {
        const auto& end = data_.run.end;
        out_.complete = end.has_value();
        if (!has_all()) {
            if (end) findings_.violation("spheres without flights", now_);
            return;
        }
        if (end) {
            const EpochTime said = moment_of(end->time);
            if (said < now_ && end->time < data_.units.seconds(now_))
                findings_.violation("flights after the end", now_);
            now_ = std::max(now_, said);
            if (end->event_hash != hash_.value()) findings_.violation("the event hash is not that of the events", now_);
            if (end->events != out_.events || end->flights != out_.flights)
                findings_.violation("events or flights are missing", now_);
        }
        coverage_.finish(now_);
    }

    /// A time in seconds, split exactly.
    EpochTime moment_of(double seconds) const
    {
        const double epochs = seconds / data_.units.time, whole = std::floor(epochs);
        return {static_cast<std::int64_t>(std::min(whole, most_recorded)), epochs - whole};
    }

    FlightSource& source_;
    Patience patience_;
    Certificate out_;
    RunData data_;
    Flights flights_;
    Findings findings_;
    Coverage coverage_;
    bool covering_ = false;  ///< coverage has begun
    ImpactAudit audit_;
    EventHash hash_;
    EpochTime now_;
    std::vector<std::pair<BodyId, Vec3>> off_;  ///< first flights that are not quite as fast as the scene says
    double largest_speed_ = 0;                  ///< of the first flights [cells/epoch]
};

}  // namespace

}  // namespace verification

Certificate verify(FlightSource& source, const VerifyOptions& options)
{
    return verification::Verification(source, options).go();
}

}  // namespace carom
