/// \file
/// Studies: one run with its figures, and the comparison of methods by error against run time. Link `carom::study`.
#pragma once

#include <carom/metrics.hpp>
#include <carom/progress.hpp>
#include <carom/simulate.hpp>

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace carom {

/// Equal intervals at which studies look at a run.
inline constexpr std::size_t study_intervals = 200;

/// Equal intervals at which `run_study` looks at an event-driven run of so many spheres: `study_intervals` up to 125
/// spheres; for more of them fewer, though not less than 2, so that looking costs no more than an ordinary run itself.
std::size_t look_intervals(std::size_t spheres);

struct RunStudyOptions {
    RunOptions run;
    std::optional<std::size_t> intervals;  ///< >= 1; none: `look_intervals`; discrete: 200
    std::vector<double> more_times;        ///< ascending, in [0, until]: looked at as well [time]
    /// Gets each state that is looked at; may be empty.
    std::function<void(double time, std::span<const BodyState>)> on_state;
    std::function<void(const Event&)> on_event;          ///< may be empty; its time counts as the run's
    std::function<void(const RunFrame&)> on_frame;       ///< as Observer's; so is
    std::function<void(const FlightRecord&)> on_flight;  ///< this one
    std::function<bool(double)> on_progress;             ///< may be empty; false interrupts
};

/// A sphere that began inside a plane and was put on it at rest: energy that no contact gave.
struct Lift {
    BodyId sphere = no_body, plane = no_body;  ///< as in Event
    double depth = 0;                          ///< along the normal of the plane, > 0 [length]
    double energy = 0;                         ///< m g.n depth, g towards the plane [mass length^2/time^2]
};

/// One run and its figures. Non-finite figures are possible where a discrete method blows up; writers turn them into
/// null.
struct RunStudy {
    std::string method;
    Outcome outcome;
    double initial_energy = 0, final_energy = 0;  ///< [mass length^2/time^2]
    /// Energy that drag took, from closed forms of the flights, not from energies; none for discrete methods with drag
    /// [mass length^2/time^2].
    std::optional<double> drag_energy;
    /// max |E + D - E0| / max kinetic energy over samples, D what drag took until then; none where contacts take
    /// energy, or where D is not known.
    std::optional<double> max_relative_drift;
    double max_energy_change = 0;   ///< max |E-E0| over samples [mass length^2/time^2]
    double max_kinetic_energy = 0;  ///< over samples [mass length^2/time^2]
    Vec3 initial_momentum = Vec3::Zero(), final_momentum = Vec3::Zero();  ///< [mass length/time]
    double max_penetration = 0;  ///< event: at impacts and samples; discrete: before correction [length]
    std::vector<Lift> lifts;     ///< event: in the order of the run; only where overlap was allowed
    std::int64_t escaped = 0;    ///< at the end
    std::vector<std::optional<double>>
        plane_forces;         ///< mean normal force per plane, resting included; none for a run of no length
    double cpu_seconds = 0;   ///< of this thread, without the time that looking at samples took [s]
    double wall_seconds = 0;  ///< likewise [s]
};

/// \pre as `simulate`; intervals >= 1. Nothing is thrown but what the functions of the options throw.
RunStudy run_study(const Scene& scene, const Method& method, const RunStudyOptions& options = {});

/// A run of an engine that is none of carom's.
struct PeerRun {
    std::vector<std::vector<BodyState>> samples;  ///< of the first of the times asked for; all if it reached the end
    bool has_velocities = true;                   ///< false: velocities of the samples mean nothing
    double cpu_seconds = 0;                       ///< of its own steps, as it says itself [s]
    std::int64_t steps = 0;
    std::string settings;  ///< name, version, and what was set, in words
    Status status = Status::reached_end;
    std::string message;  ///< why it did not reach the end
};

/// An engine that is none of carom's, with its settings: what takes a scene and a step and shows its states. Programs
/// are started by `src/peers`; a test may have one of its own.
struct Peer {
    std::string name;  ///< as rows name it, "bullet"
    /// \param times ascending, >= 0 [time] \param keep_going asked now and then; false ends the run: `interrupted`
    std::function<PeerRun(const Scene&, double dt, const std::vector<double>& times,
                          const std::function<bool()>& keep_going)>
        run;
};

struct CompareOptions {
    // Every combination is a row, but none twice: a method is run once for values of options that it does not read.
    std::vector<std::string> methods;                        ///< as `make_method`
    std::vector<Peer> peers;                                 ///< rows of their own, at each step
    std::vector<double> dt;                                  ///< > 0, for discrete methods and peers [time]
    std::vector<int> substeps{1}, passes{1};                 ///< >= 1
    std::vector<ContactOrder> orders{ContactOrder::index};   ///< for methods that visit contacts one by one
    std::vector<Integrator> integrators{Integrator::euler};  ///< where there is gravity or drag
    std::optional<std::vector<ImpactOperator>> impacts;      ///< for `event`; none: the scene's
    StepOptions step;                                        ///< literal, seed for all
    std::optional<double> stiffness;                         ///< of `penalty`, see there [mass/time^2]
    double hertz = Soft{}.hertz;                             ///< of `soft`, see there [1/time]
    double damping_ratio = Soft{}.damping_ratio;             ///< of `soft`, see there
    double until = 0;                                        ///< > 0 [time]
    int repeats = 3;                  ///< timed runs at least, >= 1; more until the median is known to 5 %
    double repeat_seconds = 5;        ///< fewer repeats where they would take longer than this for one row [s]
    std::optional<double> tolerance;  ///< position error that the verdict asks for [length]; none: `default_tolerance`
    bool search_steps = false;        ///< find for each discrete method the largest step within the tolerance
    std::size_t intervals = study_intervals;
    OnProgress on_progress;  ///< stages "reference: ...", "reference", "methods"; false interrupts
};

/// An impact of the reference that a method missed, or one of the method's that never was.
struct ImpactMismatch {
    double time = 0;                  ///< since the start [time]
    BodyId a = no_body, b = no_body;  ///< as in Event
};

/// Series of a row that the page draws, at the sample times up to the end of the row's run.
struct RowSeries {
    std::vector<double>
        energy_error;  ///< (E-E_ref) / max kinetic energy of the reference; as far as the reference goes
    std::vector<double> position_max;  ///< [length]; as far as the reference goes
    std::vector<double> penetration;   ///< of the sampled state [length]
    std::vector<double> energy;        ///< total energy [mass length^2/time^2]
    /// [sample][sphere] centres, empty for scenes of more than `max_track_spheres` [length].
    std::vector<std::vector<std::array<float, 3>>> tracks;
};
inline constexpr std::size_t max_track_spheres = 2000;
inline constexpr std::size_t max_listed_mismatches = 200;  ///< of each kind and row

/// Impacts that a method was put to one at a time: begun anew from the exact state at a random phase of the step before
/// each, it takes two steps. For `event` they are those of its run beside those of the reference.
struct Audit {
    std::int64_t audited = 0;     ///< found + late + missed + wrong
    std::int64_t found = 0;       ///< answered in its step, and after two steps the velocity is right to 1 % of |dv|
    std::int64_t late = 0;        ///< answered in the step after
    std::int64_t missed = 0;      ///< not answered
    std::int64_t wrong = 0;       ///< answered in its step, but the velocity is not right
    std::int64_t crowded = 0;     ///< questions not asked: a body has another contact within the two steps
    std::int64_t looked_at = 0;   ///< two steps of bodies that have no impact in them, at random
    std::int64_t invented = 0;    ///< of these, those in which the body answers all the same
    std::optional<double> delay;  ///< mean time from impact to answer; none without an answer [steps]
};

/// The run from which the audit takes impacts and exact states.
struct AuditSummary {
    double until = 0;             ///< impacts up to here [time]
    std::int64_t contacts = 0;    ///< impacts closing at v_c or faster
    std::int64_t drawn = 0;       ///< of these, those that each method is asked about, chosen at random
    int phases = 1;               ///< random phases of the step at which each of them is asked about
    std::int64_t slow = 0;        ///< not asked about: closings below v_c, and tails of series, one each
    std::int64_t persistent = 0;  ///< not asked about: contacts that began to last
};

/// One line of compare.csv. Optional figures are those that the comparison cannot give.
struct CompareRow {
    std::string method;
    std::optional<double> dt;                          ///< none for `event` [time]
    std::optional<int> substeps, passes;               ///< none for `event`; passes for methods that read it
    std::optional<ContactOrder> order;                 ///< of methods that read it
    std::optional<Integrator> integrator;              ///< none for `event`
    std::optional<ImpactOperator> impact;              ///< of `event`
    std::optional<double> stiffness;                   ///< of `penalty`; none: each contact has its own [mass/time^2]
    std::optional<double> hertz, damping_ratio;        ///< of `soft` [1/time], [1]
    std::optional<std::string> peer_settings;          ///< of a peer, which shows states and no contacts
    double cpu_seconds = 0, cpu_min = 0, cpu_max = 0;  ///< median, least and greatest of `repeats` timed runs [s]
    double cpu_low = 0, cpu_high = 0;                  ///< interval of the median, 95 % from six repeats on [s]
    int repeats = 0;  ///< 0: the recorded run alone was timed, it was too long to repeat
    /// Errors up to the end of the reference; none if that is before the first sample after the start [length]
    std::optional<double> position_rms, position_max;
    std::optional<double> position_final_rms,
        position_final_max;              ///< at the end of what is compared; none if the run ends before [length]
    std::optional<double> velocity_rms;  ///< [length/time]
    std::optional<double> energy_error;  ///< max |E-E_ref| / max kinetic energy of the reference
    double max_penetration = 0;          ///< discrete: before correction [length]
    double overlap_left = 0;             ///< at samples, after correction [length]
    std::int64_t missed_impacts = 0, invented_impacts = 0;  ///< up to divergence_time
    /// Missed impacts that came, but more than 3 steps early or late: the pair has as many impacts left over.
    std::int64_t mistimed_impacts = 0;
    std::int64_t reference_impacts = 0;  ///< that could have been missed
    std::int64_t impacts = 0;
    std::optional<Audit> audit;                    ///< none where there is no truth or reference to ask
    std::optional<std::int64_t> absorbed_impacts;  ///< event: impacts of the reference, slower than v_c, taken for rest
    std::optional<double> rest_jitter;             ///< none if nothing rests in the reference [length/time]
    std::optional<double> divergence_time;         ///< none: never further than 0.01 r_min from the reference [time]
    double reference_bound = 0;                    ///< [length]
    std::int64_t steps = 0, root_solves = 0, pair_tests = 0;
    Status status = Status::reached_end;
    std::string message;  ///< of the run, for people
    double time = 0;      ///< reached [time]
    RowSeries series;
    std::vector<ImpactMismatch> missed, invented;  ///< the first `max_listed_mismatches`
    std::vector<Lift> lifts;                       ///< event: as RunStudy::lifts
};

/// An instant of several contacts, whose outcome the axioms of rigid bodies leave open, as the reference met it: what
/// each operator makes of it. The reference goes on with the scene's.
struct Convention {
    struct Answer {
        ImpactOperator impact_operator = ImpactOperator::reflections;
        std::vector<Vec3> velocities;  ///< after it, one for each of `bodies` [length/time]
    };
    double time = 0;             ///< since the start of the run [time]
    std::vector<BodyId> bodies;  ///< those of it that move
    std::vector<Answer> answers;
    bool differ = false;  ///< by more than 1e-9 of the largest speed
};

struct ReferenceSummary {
    std::string kind;    ///< "closed_form" or "multiprecision"
    double bound = 0;    ///< [length]
    double until = 0;    ///< valid up to here [time]
    std::string reason;  ///< why it ends early; empty if it does not
    std::int64_t impacts = 0, series = 0;
    std::vector<Convention> conventions;                    ///< in time order, the first 100
    std::vector<double> sample_times;                       ///< [time]
    std::vector<std::vector<std::array<float, 3>>> tracks;  ///< as RowSeries::tracks
    double cpu_seconds = 0;                                 ///< [s]
};

/// How fast the errors of rows that differ in their step alone fall: error ~ dt^order.
struct Convergence {
    std::string method, variant;  ///< "pbd", ", parabola": what the rows have in common
    double order = 0;             ///< by least squares through the logarithms
    double uncertainty = 0;       ///< its standard error
    std::size_t steps = 0;        ///< >= 3, that it was fitted to
    bool stalled = false;         ///< the last three steps are of an order below 0.2
    double last_error = 0;        ///< at the smallest step [length]
};

/// The step of a method, with what else it is given, that is enough for the tolerance: the largest from which every
/// smaller one tried keeps within it and loses no impact. Errors scatter from step to step, and so steps are tried
/// close together from a quarter of it up to the first that fails.
struct StepSearch {
    enum class End : std::uint8_t {
        found,
        stalls,      ///< errors no longer fall
        not_reached  ///< smaller steps would take too long, or it was interrupted
    };
    struct Try {
        double dt = 0;                ///< [time]
        std::optional<double> error;  ///< the largest at any sample; none if not finite [length]
        bool holds = false;           ///< to the end, within the tolerance, no impact lost
    };
    End end = End::not_reached;
    std::string method, variant;    ///< as Convergence
    std::optional<CompareRow> row;  ///< found, measured in full
    std::vector<Try> tries;         ///< every step run, rows asked for among them, from the smallest step up
    bool is_complete = false;       ///< all steps of that range that a search wants were run
    double largest = 0;             ///< larger ones than this are not tried [time]
};
inline constexpr std::array<std::string_view, 3> step_search_names{"found", "stalls", "not_reached"};

struct Comparison {
    double until = 0;                  ///< end asked for [time]
    double compared_until = 0;         ///< end of what the rows cover: errors, counts and times [time]
    double tolerance = 0;              ///< [length]
    bool is_default_tolerance = true;  ///< nobody asked for another
    bool interrupted = false;          ///< rows are those finished before
    std::vector<double> sample_times;  ///< all, up to `compared_until` [time]
    ReferenceSummary reference;
    AuditSummary audit;
    std::vector<CompareRow> rows;
    std::vector<Convergence> convergence;
    std::vector<StepSearch> searches;  ///< what they found is among the rows, too
    std::vector<std::string> verdict;  ///< sentences; the first says which method is right and by how much
};

/// Position error that the verdict asks for by default [length]: 1 mm where the scene's unit of length is "m" and that
/// lies within [1e-4, 0.5] of the smallest radius, otherwise 0.01 of the smallest radius.
double default_tolerance(const Scene& scene);

/// Reference, then for each method and step one recorded run (errors), then timed ones that give the same samples.
/// \pre the scene is valid, options in range. \throws InputError for unknown method names.
Comparison compare_methods(const Scene& scene, const CompareOptions& options);

/// The verdict on the rows in plain English, for a tolerance of `comparison.tolerance`; the first sentence is the
/// headline.
std::vector<std::string> verdict(const Scene& scene, const Comparison& comparison);

}  // namespace carom
