#include "motion/motion.hpp"

namespace carom {

namespace {

template <class... Cases>
struct Visitor : Cases... {
    using Cases::operator()...;
};
template <class... Cases>
Visitor(Cases...) -> Visitor<Cases...>;

}  // namespace

Mode mode_of(const Motion& motion)
{
    return std::visit(Visitor{[](const Fixed&) { return Mode::fixed; },                                  //
                              [](const Flying&) { return Mode::flying; },                                //
                              [](const Bouncing&) { return Mode::series; },                              //
                              [](const Leaning& m) { return m.rests ? Mode::resting : Mode::sliding; },  //
                              [](const Held& m) { return m.rests ? Mode::resting : Mode::sliding; },     //
                              [](const Stepping&) { return Mode::numeric; },                             //
                              [](const Windowed&) { return Mode::numeric; }},
                      motion);
}

std::optional<int> carrier_of(const Motion& motion)
{
    if (const auto* m = std::get_if<Leaning>(&motion)) return m->plane;
    if (const auto* m = std::get_if<Bouncing>(&motion)) return m->plane;
    return {};
}

EpochTime end_of(const Motion& motion, const Frame& frame, const EpochTime& start)
{
    if (const auto* m = std::get_if<Bouncing>(&motion)) return frame.after(start, m->series.duration());
    if (const auto* m = std::get_if<Stepping>(&motion)) return m->end;
    if (const auto* m = std::get_if<Windowed>(&motion)) return m->end;
    return never;
}

}  // namespace carom
