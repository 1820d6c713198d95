/// \file
/// The table of impact operators, measured: what each does to the clusters of the literature and to random ones.
/// Usage: carom_operator_table [SETS]; SETS random clusters (default 2000) for the operators, and as many for the
/// promises of `reflections`, mass ratios up to 1e9; each set that meets its bound is named. Exit 1: a promise was
/// broken.
#include "contact/contact_forces.hpp"
#include "contact/contact_problem.hpp"
#include "impact/operators.hpp"

#include "support/clusters.hpp"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>

using namespace carom;
using namespace carom::test;

namespace {

struct Operator {
    const char* name;
    std::function<NormalImpact(const ContactProblem&)> resolve;
};

std::vector<Operator> operators()
{
    return {{"sequential", sequential},
            {"jacobi", jacobi},
            {"lcp Newton",
             [](const ContactProblem& c) {
                 return lcp(c, {LcpLaw::newton, LcpSolver::exact, 1});
             }},
            {"lcp Newton, 100 sweeps",
             [](const ContactProblem& c) {
                 return lcp(c, {LcpLaw::newton, LcpSolver::gauss_seidel, 100});
             }},
            {"lcp Poisson",
             [](const ContactProblem& c) {
                 return lcp(c, {LcpLaw::poisson, LcpSolver::exact, 1});
             }},
            {"reflections, no jam test", [](const ContactProblem& c) { return reflections(c, {false}); }},
            {"reflections", [](const ContactProblem& c) { return reflections(c); }},
            {"shock", shock}};
}

/// What the operator itself answers, without the last inelastic impact of resolve_cluster.
ClusterImpact raw(const Operator& which, const ContactProblem& cluster)
{
    const NormalImpact normal = which.resolve(cluster);
    ClusterImpact out;
    for (std::size_t i = 0; i < normal.impulses.size(); ++i)
        out.impulses.push_back(normal.impulses[i] * cluster.contacts[i].normal);
    out.velocities =
        !normal.velocities ? velocities_after(cluster, velocities_before(cluster), out.impulses) : *normal.velocities;
    out.rounds = normal.rounds;
    out.jammed = normal.jammed;
    out.capped = normal.capped;
    return out;
}

bool breaks_away(const Operator& which)
{
    const ClusterImpact impact = raw(which, cradle(1));
    return impact.velocities[4].x() - impact.velocities[3].x() > 1e-9;
}

/// The largest difference between the rack's balls and their mirror images.
double asymmetry(const Operator& which)
{
    const ClusterImpact impact = raw(which, rack_of_15());
    double out = 0;
    for (std::size_t r = 0; r < 5; ++r)
        for (std::size_t k = 0; k <= r; ++k) {
            const std::size_t first = 1 + r * (r + 1) / 2;
            Vec3 v = impact.velocities[first + r - k];
            v.y() = -v.y();
            out = std::max(out, (impact.velocities[first + k] - v).norm());
        }
    return out;
}

/// Energy after by that before, the largest of random clusters without jams.
double largest_energy(const Operator& which, int sets, bool mixed)
{
    carom::Random random(7);
    RandomClusters options;
    options.most_contacts = 12;
    options.mass_ratio = 8;
    options.share_jammed = 0;
    double out = 0;
    for (int k = 0; k < sets; ++k) {
        ContactProblem cluster = random_cluster(random, options);
        for (Contact& contact : cluster.contacts) contact.restitution = mixed ? random.uniform() : 1;
        out = std::max(out, 1 + debts(cluster, raw(which, cluster)).energy);
    }
    return out;
}

const char* answer(const Operator& which, const ContactProblem& cluster)
{
    const ClusterImpact impact = raw(which, cluster);
    if (impact.capped) return "capped";
    return debts(cluster, impact).closing > 1e-9 ? "closes" : "ok";
}

/// Three balls that fill the way between two walls, the middle one hit from the side.
ContactProblem jammed()
{
    ContactProblem out = row({1, 1, 1}, {0.5, 0, 0});
    out.contacts.push_back({0, immovable, Vec3(1, 0, 0), 1, 1});
    out.contacts.push_back({2, immovable, Vec3(-1, 0, 0), 1, 1});
    out.bodies.push_back({Vec3(0, -1, 0), 1});
    out.contacts.push_back({3, 1, Vec3(0, 1, 0), 1, 1});
    return out;
}

void print_table(int sets)
{
    std::printf(
        "| operator, e = 1 | break-away | asymmetry of the rack | energy, e = 1 | energy, mixed e | "
        "rounds: cradle / rack of 15 / tower of 5 | pinched | jammed |\n|---|---|---|---|---|---|---|---|\n");
    for (const Operator& which : operators()) {
        char rounds[64];
        std::snprintf(rounds, sizeof rounds, "%d / %d / %d", which.resolve(cradle(1)).rounds,
                      which.resolve(rack_of_15()).rounds, which.resolve(hit_tower(5)).rounds);
        std::printf("| %s | %s | %.1e | x %.6g | x %.6g | %s | %s | %s |\n", which.name, breaks_away(which) ? "y" : "N",
                    asymmetry(which), largest_energy(which, sets, false), largest_energy(which, sets, true), rounds,
                    answer(which, pinched()), answer(which, jammed()));
    }
}

/// \returns whether `reflections` kept all it promises
bool print_promises(int sets)
{
    carom::Random random(1);
    RandomClusters options;
    options.mass_ratio = 1e9;
    Debts worst;
    int failures = 0, capped = 0, jams = 0, most_rounds = 0;
    const auto begin = std::chrono::steady_clock::now();
    for (int k = 0; k < sets; ++k) {
        const ContactProblem cluster = random_cluster(random, options);
        const ClusterImpact impact = resolve_cluster(cluster, {});
        const Debts owed = debts(cluster, impact);
        worst.closing = std::max(worst.closing, owed.closing);
        worst.momentum = std::max(worst.momentum, owed.momentum);
        worst.energy = std::max(worst.energy, owed.energy);
        worst.pull = std::max(worst.pull, owed.pull);
        if (impact.capped)
            std::printf("set %d: %zu bodies, %zu contacts, capped after %d rounds\n", k, cluster.bodies.size(),
                        cluster.contacts.size(), impact.rounds);
        capped += impact.capped ? 1 : 0;
        jams += impact.jammed ? 1 : 0;
        most_rounds = std::max(most_rounds, impact.rounds);
        const bool kept = owed.closing <= 1e-9 && owed.momentum <= 1e-12 && owed.energy <= 1e-12 && owed.pull <= 1e-12;
        failures += kept ? 0 : 1;
    }
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    std::printf("\nreflections, %d random sets of up to 40 contacts, mass ratios to 1e9: %d failures\n", sets,
                failures);
    std::printf("closing %.1e of the largest speed, momentum %.1e, energy gained %.1e, pull %.1e\n", worst.closing,
                worst.momentum, worst.energy, worst.pull);
    std::printf("jammed %d, capped %d, most rounds %d, %.1f s\n", jams, capped, most_rounds, seconds);
    return failures == 0;
}

/// A pile of some thousand contacts: its forces, and a hit.
void print_pile()
{
    const auto milliseconds = [](const std::function<void()>& work) {
        const auto begin = std::chrono::steady_clock::now();
        work();
        return 1e3 * std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    };
    ContactProblem cluster = pile(10, 10);
    const std::vector<double> curvature(cluster.contacts.size(), 0.0);
    for (ContactBody& body : cluster.bodies) body.velocity = Vec3(0, 0, -9.81);
    ContactForces forces;
    const double cold = milliseconds([&] { forces = solve_contact_forces(cluster, curvature); });
    const double warm = milliseconds([&] { forces = solve_contact_forces(cluster, curvature, forces.forces); });
    for (ContactBody& body : cluster.bodies) body.velocity = Vec3::Zero();
    cluster.bodies.back().velocity = Vec3(0.1, 0.2, -1);
    ClusterImpact impact;
    const double elastic = milliseconds([&] { impact = resolve_cluster(cluster, {}); });
    for (Contact& contact : cluster.contacts) contact.restitution = 0.5;
    const double inelastic_hit = milliseconds([&] { resolve_cluster(cluster, {}); });
    std::printf(
        "\npile of %zu spheres, %zu contacts: forces %.0f ms, again from these %.1f ms; hit, e = 1: %.0f ms in %d "
        "rounds, e = 0.5: %.0f ms\n",
        cluster.bodies.size(), cluster.contacts.size(), cold, warm, elastic, impact.rounds, inelastic_hit);
}

}  // namespace

int main(int argc, char** argv)
{
    const int sets = argc > 1 ? std::atoi(argv[1]) : 2000;
    print_table(std::min(sets, 2000));
    print_pile();
    return print_promises(sets) ? 0 : 1;
}
