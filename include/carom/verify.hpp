/// \file
/// The certificate of a recorded run: code that shares nothing with the engine asks whether what was recorded can be
/// what happened. Every pair of spheres and every sphere and plane is examined over every time interval.
#pragma once

#include <carom/event.hpp>
#include <carom/flight.hpp>
#include <carom/progress.hpp>
#include <carom/scene.hpp>

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace carom {

struct RecordedSphere {
    double radius = 0;          ///< > 0 [length]
    double mass = 1;            ///< > 0 [mass]
    std::int32_t material = 0;  ///< index into RecordedRun::materials
    bool fixed = false;
};

/// Place and velocity of a sphere when the run began, origin left out.
struct RecordedStart {
    Vec3 position = Vec3::Zero();  ///< [length]
    Vec3 velocity = Vec3::Zero();  ///< [length/time]
};

/// The end of a run, as the run states it.
struct RecordedEnd {
    double time = 0;               ///< reached, since the start [time]
    std::uint64_t event_hash = 0;  ///< see docs/recording.md
    std::int64_t events = 0, flights = 0;
};

/// The parts of a run beside its flights and events.
struct RecordedRun {
    RunFrame frame;
    Vec3 gravity = Vec3::Zero();        ///< [length/time^2]
    std::vector<Material> materials;    ///< names and colours are not needed
    std::vector<ContactRule> contacts;  ///< in the order of the scene
    std::vector<Plane> planes;          ///< ids are not needed
    std::vector<RecordedSphere> spheres;
    double closing_speed = 0;  ///< v_c: where some e < 1, slower impacts may be inelastic, >= 0 [length/time]
    /// tau_p: so may those of contacts that closed less than this ago, >= 0. 0: slower impacts are elastic, as the rest
    /// policy micro has them (another policy without such a time says the least positive number) [time]
    double window = 0;
    /// Contacts open by up to this fraction of the smaller radius may close together with one that is closed
    /// (ImpactOptions::tie), in [0, 0.01].
    double tie = 0;
    std::vector<RecordedStart> starts;  ///< by sphere; gone after FlightSource::forget_starts
    /// The run claims flights in double-double: gap >= min(0, initial gap) exactly, which none with drag can claim.
    /// Otherwise gap >= -16 eps max(r1 + r2, distance flown) is what it promises.
    bool certified = false;
    std::optional<RecordedEnd> end;  ///< none: the recording was cut off
};

/// One moment of a run: events, then the flights that they begin. The flights of the start, and those of a series that
/// ends in the middle, come without events.
struct Instant {
    std::span<const Event> events;
    std::span<const FlightRecord> flights;
};

/// A source of recorded flights.
class FlightSource {
public:
    virtual ~FlightSource() = default;
    virtual const RecordedRun& run() const = 0;
    /// The next instant in the order of the run; valid until the next call. False at the end. May throw InputError: the
    /// file is damaged.
    virtual bool next(Instant& instant) = 0;
    /// RecordedRun::starts will not be asked for any more: their memory may be given back.
    virtual void forget_starts() {}
};

/// Time that bodies spent, all bodies added, by what could be certified of the flights of that time.
struct CertifiedSeconds {
    double exact = 0;       ///< gap >= min(0, initial gap) [time]
    double bounded = 0;     ///< gap >= -16 eps max(r1 + r2, distance flown) [time]
    double in_contact = 0;  ///< in persistent contact with spheres or several planes: gap >= -1e-9 r [time]
    double numeric =
        0;  ///< pieces that no closed form gives, and bodies that touched one: Certificate::numeric_depth [time]
    double guarded = 0;        ///< windows of the guard: Certificate::guarded_depth [time]
    double not_certified = 0;  ///< none of these could be shown, nor a violation [time]
};

/// A fault of a run.
struct Violation {
    std::string what;  ///< for people, bodies by number: "sphere 3 and plane 0 overlap by 1e-9"
    double time = 0;   ///< since the start [time]
    BodyId a = no_body, b = no_body;
};

struct Certificate {
    std::int64_t spheres = 0, planes = 0, events = 0, flights = 0;
    double until = 0;           ///< examined up to here [time]
    bool complete = false;      ///< false: the recording was cut off at `until`, or the examination stopped there
    bool stopped = false;       ///< the examination was stopped on request: nothing is said of what came after `until`
    bool certified = false;     ///< the run claimed double-double flights and was held to that
    std::int64_t pairs = 0;     ///< pairs of spheres and of spheres and planes, all of them covered
    std::int64_t segments = 0;  ///< time intervals of pairs that came near enough to be examined one by one
    std::int64_t needed_double_double = 0, needed_exact = 0;        ///< of these
    double smallest_gap = std::numeric_limits<double>::infinity();  ///< over all pairs and times [length]
    double smallest_gap_time = 0;                                   ///< [time]
    std::int64_t impulses = 0;                                      ///< checked
    double largest_impact_gap = 0;                                  ///< |gap| at an impulse [length]
    double largest_jump = 0;            ///< of position at an event, beside its rounding bound [1]
    double largest_impulse_error = 0;   ///< |v+ - v- - J/m| beside the speeds of the impact [1]
    double largest_momentum_error = 0;  ///< beside the momenta of the impact [1]
    double largest_energy_error = 0;    ///< against the contact law, beside the kinetic energy of the impact [1]
    double largest_law_error = 0;  ///< of the impulse against the contact law, beside the momenta of the impact [1]
    std::int64_t clusters = 0;     ///< impacts of several connected contacts at one instant
    std::int64_t rests_on_spheres = 0;     ///< events of kind rest between two spheres
    std::int64_t releases_of_spheres = 0;  ///< events of kind release between two spheres
    std::int64_t guards = 0;               ///< events of kind guard
    std::int64_t settles = 0;              ///< events of kind settle
    double numeric_depth = 0;              ///< largest overlap in which a numeric piece takes part, >= 0 [length]
    double guarded_depth = 0;              ///< likewise of windows of the guard [length]
    double largest_numeric_jump = 0;       ///< of position where such a piece ends [length]
    double largest_numeric_kick = 0;       ///< of velocity there, beside impulses [length/time]
    /// Jump of velocity, beside its impulses, of a body that several contacts hold from there on: where some e < 1,
    /// persistence may take openings slower than v_c [length/time].
    double largest_absorbed = 0;
    CertifiedSeconds body_seconds;
    std::uint64_t event_hash = 0;       ///< of the events read
    std::int64_t violated = 0;          ///< how many violations were found
    std::vector<Violation> violations;  ///< the first of them

    /// Whether nothing wrong was found; up to `until`.
    bool holds() const { return violated == 0; }
};

struct VerifyOptions {
    bool all_pairs = false;            ///< examine all pairs without a grid: slow, for tests
    std::size_t most_violations = 20;  ///< to list
    OnProgress on_progress;  ///< stages "initial overlaps", "flights", "last flights"; false stops the examination
};

/// The certificate of a recorded run. Memory: at most 400 bytes a sphere beside the stream. \throws what the source
/// throws
Certificate verify(FlightSource& source, const VerifyOptions& options = {});

}  // namespace carom
