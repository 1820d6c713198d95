#include "adversary/tally.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>

namespace carom::test {

namespace {

TimeOfImpact ask(const Query& q)
{
    return q.plane ? time_of_impact(q.a, *q.plane) : time_of_impact(q.a, q.b);
}

std::string describe(const Query& q, const TimeOfImpact& hit, const Answer& truth)
{
    std::ostringstream out;
    out << std::hexfloat;
    const auto body = [&](const MovingSphere& s) {
        out << "{{" << s.position.transpose() << "}, {" << s.velocity.transpose() << "}, {"
            << s.acceleration.transpose() << "}, " << s.radius << "} ";
    };
    body(q.a);
    if (q.plane)
        out << "plane {" << q.plane->normal.transpose() << "}, " << q.plane->offset << " thickness "
            << q.plane->thickness.value_or(-1);
    else
        body(q.b);
    out << std::defaultfloat << std::setprecision(17) << " answered " << static_cast<int>(hit.status) << " at " << hit.t
        << " in [" << hit.t_lo << ", " << hit.t_hi << "], exact " << static_cast<int>(truth.status) << " at "
        << truth.t.str(22);
    return out.str();
}

double ulp_of(double t)
{
    return std::nextafter(t, std::numeric_limits<double>::infinity()) - t;
}

void judge_time(const TimeOfImpact& hit, const Answer& truth, Tally& tally)
{
    const Float200 room = truth.t * truth.uncertainty;
    if (!(hit.t_lo <= truth.t + room && truth.t - room <= hit.t_hi)) ++tally.outside;
    if (truth.status == ImpactStatus::touching) return;
    const double ulp = ulp_of(truth.t.convert_to<double>());
    const double error = Float200(abs(hit.t - truth.t) / ulp).convert_to<double>();
    tally.worst_ulp = std::max(tally.worst_ulp, error);
    tally.widest_ulp = std::max(tally.widest_ulp, (hit.t_hi - hit.t_lo) / ulp);
    if (!(error <= 1)) ++tally.beyond_ulp;
}

/// Lengths by 2^k; the time stays.
Query scaled_by(const Query& q, int k)
{
    Query out = q;
    const double unit = std::ldexp(1, k);
    for (MovingSphere* s : {&out.a, &out.b}) {
        s->position *= unit;
        s->velocity *= unit;
        s->acceleration *= unit;
        s->radius *= unit;
    }
    if (out.plane) {
        out.plane->offset *= unit;
        if (out.plane->thickness) *out.plane->thickness *= unit;
    }
    return out;
}

/// Numbers so small that a power of two costs digits.
bool loses_bits(const Query& q)
{
    const auto small = [](double x) { return x != 0 && std::abs(x) < 0x1p-960; };
    for (const MovingSphere* s : {&q.a, &q.b})
        for (const Vec3* each : {&s->position, &s->velocity, &s->acceleration})
            for (const double x : *each)
                if (small(x)) return true;
    return small(q.a.radius) || small(q.b.radius) || (q.plane && small(q.plane->offset));
}

bool is_symmetric(const Query& q, const TimeOfImpact& hit, Random& random)
{
    const auto same = [&](const TimeOfImpact& other) {
        return other.status == hit.status && other.t == hit.t && other.t_lo == hit.t_lo && other.t_hi == hit.t_hi;
    };
    if (!q.plane) {
        Query swapped = q;
        std::swap(swapped.a, swapped.b);
        const TimeOfImpact other = ask(swapped);
        if (!same(other) || other.normal != -hit.normal) return false;
        Query mirrored = q;
        for (MovingSphere* s : {&mirrored.a, &mirrored.b})
            for (Vec3* each : {&s->position, &s->velocity, &s->acceleration}) *each = -*each;
        if (!same(ask(mirrored))) return false;
    }
    return loses_bits(q) || same(ask(scaled_by(q, random.integer(-40, 40))));
}

void put(const Family& family, const Query& q, Random& random, Tally& tally)
{
    const Answer truth = family.needs_digits ? answer_to<Float700>(q) : answer_to<Float200>(q);
    ++tally.queries;
    if (truth.no_digits) {
        ++tally.undecided;
        return;
    }
    const long long failures = tally.failures();
    const TimeOfImpact hit = ask(q);
    const ImpactStatus meant = truth.t > std::numeric_limits<double>::max() ? ImpactStatus::none : truth.status;
    ++tally.level[hit.level];
    (meant == ImpactStatus::none ? tally.none : meant == ImpactStatus::touching ? tally.touching : tally.impacts)++;
    if (hit.status == meant) {
        if (hit) judge_time(hit, truth, tally);
    } else if (!hit) {
        ++tally.missed;
    } else if (meant == ImpactStatus::none) {
        ++tally.spurious;
    } else {
        ++tally.wrong_status;
    }
    constexpr int sometimes = 16;
    if (tally.queries % sometimes == 0 && !is_symmetric(q, hit, random)) ++tally.asymmetric;
    if (tally.failures() > failures && tally.example.empty()) tally.example = describe(q, hit, truth);
}

}  // namespace

std::vector<Tally> challenge(long long count, std::uint64_t seed)
{
    const std::vector<Family> families = all_families();
    long long shares = 0;
    for (const Family& family : families) shares += family.share;
    std::vector<Tally> out;
    for (std::size_t f = 0; f < families.size(); ++f) {
        Random random(seed * 1000 + f);
        Tally tally;
        tally.family = families[f].name;
        const long long queries = std::max(1LL, count * families[f].share / shares);
        for (long long i = 0; i < queries; ++i) put(families[f], families[f].make(random), random, tally);
        out.push_back(tally);
    }
    return out;
}

std::string table(const std::vector<Tally>& tallies)
{
    std::ostringstream out;
    const auto line = [&](const Tally& t) {
        out << std::left << std::setw(26) << t.family << std::right;
        for (const long long x :
             {t.queries, t.impacts, t.touching, t.none, t.missed, t.spurious, t.wrong_status, t.outside, t.beyond_ulp,
              t.asymmetric, t.undecided, t.level[0], t.level[1], t.level[2]})
            out << std::setw(10) << x;
        out << std::fixed << std::setprecision(4) << std::setw(9) << t.worst_ulp << std::setprecision(1) << std::setw(9)
            << t.widest_ulp << "\n";
    };
    out << std::left << std::setw(26) << "family" << std::right;
    for (const char* head : {"queries", "impacts", "touching", "none", "missed", "spurious", "status", "outside",
                             "> 1 ulp", "asymm.", "undecided", "level 0", "level 1", "level 2"})
        out << std::setw(10) << head;
    out << std::setw(9) << "max ulp" << std::setw(9) << "width"
        << "\n";
    Tally all;
    all.family = "all";
    for (const Tally& t : tallies) {
        line(t);
        all.queries += t.queries;
        all.impacts += t.impacts;
        all.touching += t.touching;
        all.none += t.none;
        all.missed += t.missed;
        all.spurious += t.spurious;
        all.wrong_status += t.wrong_status;
        all.outside += t.outside;
        all.beyond_ulp += t.beyond_ulp;
        all.asymmetric += t.asymmetric;
        all.undecided += t.undecided;
        for (int k = 0; k < 3; ++k) all.level[k] += t.level[k];
        all.worst_ulp = std::max(all.worst_ulp, t.worst_ulp);
        all.widest_ulp = std::max(all.widest_ulp, t.widest_ulp);
    }
    line(all);
    for (const Tally& t : tallies)
        if (!t.example.empty()) out << t.family << ": " << t.example << "\n";
    return out.str();
}

}  // namespace carom::test
