#include "generated/tally.hpp"

#include <cstdio>

namespace carom::test {

namespace {

/// Without friction the balls of a pile roll over each other, in numeric pieces, for some 30 sqrt(r/g) until it jams.
constexpr double least_reached = 0.99, most_numeric = 0.05, most_guarded = 0.001;

template <class... Values>
std::string line(const char* format, Values... values)
{
    char text[400];
    std::snprintf(text, sizeof text, format, values...);
    return text;
}

double share(double part, double whole)
{
    return whole > 0 ? part / whole : 0;
}

}  // namespace

void Tally::add(std::uint64_t index, const std::string& kind, const Trial& t)
{
    const std::string wrong = complaint(t);
    ++all_;
    Share& of_kind = kinds_[kind];
    ++of_kind.all;
    if (t.ended && t.status == Status::reached_end) ++of_kind.reached;
    of_kind.bodies += t.closed_form + t.numeric + t.guarded;
    of_kind.numeric += t.numeric;
    ++statuses_[t.ended ? name(t.status) : "crashed or hung"];
    no_status_ += t.ended ? 0 : 1;
    lost_ += t.lost;
    deeper_ += wrong == "deeper than stated" || wrong == "sunk" ? 1 : 0;
    closed_form_ += t.closed_form;
    numeric_ += t.numeric;
    guarded_ += t.guarded;
    cpu_ += t.cpu_seconds;
    busiest_.add(t.busiest_window, index);
    penetration_.add(t.penetration, index);
    slowest_.add(t.cpu_seconds, index);
    counts_.impacts += t.counts.impacts;
    counts_.clusters += t.counts.clusters;
    counts_.rests += t.counts.rests;
    counts_.releases += t.counts.releases;
    counts_.guarded += t.counts.guarded;
    counts_.numeric_steps += t.counts.numeric_steps;
}

std::string Tally::table(double seconds) const
{
    const double all = static_cast<double>(all_), bodies = closed_form_ + numeric_ + guarded_;
    std::string text = line("%lld scenes, limit %.3g s each, %.1f CPU s in all; slowest %.2f s (scene %llu)\n", all_,
                            seconds, cpu_, slowest_.value, static_cast<unsigned long long>(slowest_.index));
    for (const auto& [status, count] : statuses_)
        text += line("  %-16s %6lld  %6.2f %%\n", status.c_str(), count, 100 * share(static_cast<double>(count), all));
    text += "by kind          reached_end       numeric of all body-seconds\n";
    for (const auto& [kind, s] : kinds_)
        text += line("  %-16s %6lld of %-6lld %6.2f %%\n", kind.c_str(), s.reached, s.all,
                     100 * share(s.numeric, s.bodies));
    text += line(
        "impacts %lld, in clusters at %lld instants, rests %lld, releases %lld, guarded windows %lld, numeric steps "
        "%lld\n",
        static_cast<long long>(counts_.impacts), static_cast<long long>(counts_.clusters),
        static_cast<long long>(counts_.rests), static_cast<long long>(counts_.releases),
        static_cast<long long>(counts_.guarded), static_cast<long long>(counts_.numeric_steps));
    text += line("busiest window   %.3g of the bound B n (scene %llu)\n", busiest_.value,
                 static_cast<unsigned long long>(busiest_.index));
    text += line("body-seconds     closed form %.4f %%, numeric %.4f %%, guarded %.4f %%\n",
                 100 * share(closed_form_, bodies), 100 * share(numeric_, bodies), 100 * share(guarded_, bodies));
    text += line("spheres lost     %lld\n", lost_);
    text += line("deepest          %.3g r (scene %llu); deeper than stated, or sunk, in %lld scenes\n",
                 penetration_.value, static_cast<unsigned long long>(penetration_.index), deeper_);
    return text + (targets_met() ? "targets met\n" : "targets MISSED\n");
}

bool Tally::targets_met() const
{
    const double bodies = closed_form_ + numeric_ + guarded_;
    const auto reached = statuses_.find(name(Status::reached_end));
    const double share_reached =
        reached == statuses_.end() ? 0 : share(static_cast<double>(reached->second), static_cast<double>(all_));
    return share_reached >= least_reached && no_status_ == 0 && lost_ == 0 && deeper_ == 0 && busiest_.value <= 1 &&
           share(numeric_, bodies) <= most_numeric && share(guarded_, bodies) <= most_guarded;
}

}  // namespace carom::test
