#include "heap/window_past.hpp"

#include "heap/tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace carom {

namespace {

std::size_t at(int i)
{
    return static_cast<std::size_t>(i);
}

bool comes_first(const ContactForce& x, const ContactForce& y)
{
    return x.a != y.a ? x.a < y.a : x.b < y.b;
}

/// Whether all of `bodies` are in the part.
bool has_all(std::span<const BodyId> part, const std::vector<BodyId>& bodies)
{
    std::size_t count = 0;
    for (const BodyId body : part) count += std::binary_search(bodies.begin(), bodies.end(), body);
    return count == bodies.size();
}

}  // namespace

std::vector<double> forces_before(const State& state, const WindowProblem& problem, std::span<const BodyId> ids,
                                  const WindowHistory& history)
{
    std::vector<ContactForce> known;
    for (const auto& piece : history.pieces) known.insert(known.end(), piece->forces.begin(), piece->forces.end());
    for (const BodyId body : history.woken)
        for (const PersistentContact& c : state.bodies.contacts().of(body))
            if (c.partner.is_plane() || body < c.partner.index || state.is_fixed(c.partner.index))
                known.push_back({body, c.partner, c.force});
    if (history.pieces.size() + history.woken.size() > 1) std::sort(known.begin(), known.end(), comes_first);
    std::vector<double> out(problem.contacts.size(), 0);
    auto next = known.begin();
    for (std::size_t k = 0; k < out.size(); ++k) {
        const WindowContact& c = problem.contacts[k];
        const ContactForce wanted{ids[at(c.a)], c.b.is_plane() ? c.b : Partner::sphere(ids[at(c.b.index)]), 0};
        while (next != known.end() && comes_first(*next, wanted)) ++next;
        if (next != known.end() && !comes_first(wanted, *next)) out[k] = next->force;
    }
    return out;
}

Heat heat_of(const WindowProblem& problem, std::span<const double> forces, std::size_t count)
{
    std::vector<char> held(problem.bodies.size(), 1);
    for (std::size_t k = 0; k < forces.size(); ++k)
        if (problem.contacts[k].b.is_plane() && forces[k] > 0) held[at(problem.contacts[k].a)] = 0;
    for (std::size_t k = 0; k < forces.size(); ++k)
        if (problem.contacts[k].b.is_sphere() && forces[k] > 0)
            held[at(problem.contacts[k].a)] = held[at(problem.contacts[k].b.index)] = 1;
    Heat out;
    double square = 0, mass = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const WindowBody& body = problem.bodies[i];
        out.fastest = std::max(out.fastest, body.velocity.norm());
        if (!held[i]) continue;
        square += body.velocity.squaredNorm() / body.inverse_mass;
        mass += 1 / body.inverse_mass;
        out.fastest_held = std::max(out.fastest_held, body.velocity.norm());
    }
    out.rms_held = mass > 0 ? std::sqrt(square / mass) : 0;
    return out;
}

WindowPast past_of(std::span<const BodyId> bodies, const WindowHistory& history)
{
    WindowPast out;
    for (const auto& piece : history.pieces) {
        if (!std::binary_search(piece->bodies.begin(), piece->bodies.end(), bodies.front())) continue;
        out.wait = piece->wait;
        out.exists = true;
    }
    if (std::any_of(history.woken.begin(), history.woken.end(),
                    [&](BodyId body) { return std::find(bodies.begin(), bodies.end(), body) != bodies.end(); })) {
        out.wait.after_waking =
            std::min(2 * std::max(out.wait.after_waking, first_wait_after_waking), longest_wait_after_waking);
        out.wait.hot_windows = out.wait.after_waking;
    }
    for (std::size_t p = 0; p < history.pieces.size(); ++p) {
        const WindowPiece& piece = *history.pieces[p];
        if (!piece.landing || history.is_interrupted[p]) continue;
        if (piece.landing->move + 1 >= piece.landing->course->moves.size()) continue;
        if (has_all(bodies, piece.landing->course->bodies))
            out.course = LandingStage{piece.landing->course, piece.landing->move + 1};
    }
    return out;
}

}  // namespace carom
