/// \file
/// The methods that can run a scene, as values: options are named, a method is one alternative of a variant.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace carom {

/// The search for candidate pairs: all pairs; a grid of cells; lists of neighbours, of event-driven runs alone
/// (discrete methods take all pairs instead). `automatic` is `automatic_broad_phase` and `event_broad_phase`. Results
/// do not depend on it, bit for bit; only the cost does.
enum class BroadPhase : std::uint8_t { automatic, all_pairs, cell_grid, neighbour_lists };

/// Exact in time: the next contact is a root, not a step.
struct EventDriven {
    static constexpr std::string_view method_name = "event";
    BroadPhase broad_phase = BroadPhase::automatic;
    std::string kernel{};  ///< name of a kernel (`kernels`); empty: the cheapest
                           ///< that covers the scene
    /// Positions in double-double, and each event of free flight carried out at a time that is certainly not after the
    /// exact contact: the gap never goes below 0. For runs that `verify` is to certify.
    bool certified = false;
};

/// Order in which a discrete method visits the contacts of one pass: pairs by a, then b; the same from the end; at
/// random; the deepest first, as the pass begins. `jacobi`, of pbd alone: index order over the list of overlaps as they
/// are before any is corrected, so that what a correction causes waits for the next pass or step. `shock`, of velocity
/// and moreau alone: from the ground up, and after all passes once more, each level infinitely heavy for the next
/// (Guendelman et al. 2003).
enum class ContactOrder : std::uint8_t { index, reverse, random, deepest, jacobi, shock };
inline constexpr std::array<std::string_view, 6> contact_order_names{"index",   "reverse", "random",
                                                                     "deepest", "jacobi",  "shock"};

/// Motion of a discrete method between its contacts, with h = dt / substeps and drag k. `euler`: semi-implicit Euler,
/// v += h (g - k v), then p += h v, for h k < 2. `parabola`: exact in flight, p += h v + h^2 g / 2, v += h g without
/// drag, with it the damped path of FlightRecord.
enum class Integrator : std::uint8_t { euler, parabola };
inline constexpr std::array<std::string_view, 2> integrator_names{"euler", "parabola"};

/// Options of all discrete methods. What a method reads of `passes` and `order` it says itself; most read no passes,
/// and of the orders index, reverse, random and deepest.
struct StepOptions {
    static constexpr bool reads_passes = false, reads_order = true;
    static constexpr std::array<ContactOrder, 0> more_orders{};  ///< beyond those four

    double dt = 1.0 / 240;  ///< > 0 [time]; the last step is shortened to end the run on time
    int substeps = 1;       ///< >= 1, steps of dt / substeps each
    int passes = 1;         ///< >= 1, how often the contact phases are repeated in a substep
    ContactOrder order = ContactOrder::index;
    bool literal = false;    ///< pbd only: the textbook's unconditional response
                             ///< (also when separating), once a substep
    std::uint64_t seed = 1;  ///< for ContactOrder::random
    Integrator integrator = Integrator::euler;
};

/// Position based: move, then, pair by pair in one pass, respond and project the overlap away; each pair is tested
/// where those before it have left it (after Mueller et al., Position based dynamics, 2007).
struct PositionBased : StepOptions {
    static constexpr std::string_view method_name = "pbd";
    static constexpr bool reads_passes = true;
    static constexpr std::array more_orders{ContactOrder::jacobi};
    bool mass_weighted = false;  ///< share a projection by inverse mass instead of half and half
};
/// Velocity based: respond on gaps at the start of the step, cancel velocities that would deepen an overlap, then move.
struct VelocityBased : StepOptions {
    static constexpr std::string_view method_name = "velocity";
    static constexpr bool reads_passes = true;
    static constexpr std::array more_orders{ContactOrder::shock};
};
/// Bisection: step, and when an overlap appears go back to the first contact by bisection of the step, respond there,
/// go on.
struct Bisection : StepOptions {
    static constexpr std::string_view method_name = "bisection";
};
/// Response on velocity alone, no approach test, no correction: it sinks and sticks. A warning, and a positive control
/// of tests.
struct Naive : StepOptions {
    static constexpr std::string_view method_name = "naive";
};

/// Moreau-Jean time stepping: one complementarity problem for all contacts of a step, by projected Gauss-Seidel
/// (Moreau 1988).
struct Moreau : StepOptions {
    static constexpr std::string_view method_name = "moreau";
    static constexpr std::array more_orders{ContactOrder::shock};
    int sweeps = 100;  ///< >= 1, of Gauss-Seidel, at most
};

/// Continuous collision by substeps: in each step to the first contact by a root on the step's own paths, respond
/// there, go on. Nothing is tunnelled through.
struct ImpactSubsteps : StepOptions {
    static constexpr std::string_view method_name = "toi";
    /// >= 1, responses of a sphere in a substep with its restitution; a contact beyond them closes without rebound.
    /// Bounces that die away in a step need as many as it takes them to fall below rounding: 70 at e = 0.8, 320 at
    /// 0.95.
    int most_impacts = 100;
};

/// Penalty: a spring and a damper while bodies overlap (Moore, Wilhelms 1988). All forces are those of one state.
struct Penalty : StepOptions {
    static constexpr std::string_view method_name = "penalty";
    static constexpr bool reads_order = false;
    /// > 0, of every spring [mass/time^2]; a step longer than the stable one, 2/sqrt(k/m) and with damping less, is
    /// refused. None: that with which two bodies alone stay in contact for ten substeps, from their reduced mass.
    std::optional<double> stiffness{};
};

/// Speculative contacts: nothing passes a gap within a step, then what closed faster than that rebounds (Catto; Firth
/// 2011).
struct Speculative : StepOptions {
    static constexpr std::string_view method_name = "speculative";
    int sweeps = 100;  ///< >= 1, of sequential impulses, at most
};

/// Soft contacts with relaxation, the solver of Box2D 3 ("TGS soft": Catto 2024), which takes 4 substeps. Contacts are
/// looked for once a step.
struct Soft : StepOptions {
    static constexpr std::string_view method_name = "soft";
    double hertz = 30;          ///< > 0, of the spring of an overlap, at most a quarter of
                                ///< the substeps' rate [1/time]
    double damping_ratio = 10;  ///< >= 0
};

/// Each alternative says what users call it, `method_name`; names, help texts and messages follow from this list.
using Method = std::variant<EventDriven, PositionBased, VelocityBased, Bisection, Naive, Moreau, ImpactSubsteps,
                            Penalty, Speculative, Soft>;

/// The word that users know it by: "event", "pbd", "velocity", "bisection", "naive", "moreau", "toi",
/// "penalty", "speculative", "soft".
std::string_view name(const Method& method);
/// All method names, in the order of the variant.
const std::vector<std::string>& method_names();
/// The method called `name`; discrete ones with these options, which are taken as they are: a run with options out of
/// range ends at once with Status::unresolved. \throws InputError naming the known methods.
Method make_method(std::string_view name, const StepOptions& options = {});
/// Step options of a discrete method, nullptr for the event-driven one. Valid as long as `method`.
const StepOptions* step_options(const Method& method);
/// The order of that name. \throws InputError naming the known ones
ContactOrder contact_order(std::string_view name);
std::string_view name(ContactOrder order);
/// The integrator of that name. \throws InputError naming the known ones
Integrator integrator(std::string_view name);
std::string_view name(Integrator integrator);

}  // namespace carom
