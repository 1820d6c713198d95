#include "event_driven/range.hpp"

#include "core/text.hpp"
#include "event_driven/tolerances.hpp"
#include "flight/frame.hpp"
#include "math/length.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carom {

namespace {

double largest(const Vec3& v)
{
    return v.cwiseAbs().maxCoeff();
}

std::string too_large(const std::string& what, double x, const char* limit = "2^400")
{
    return what + " of " + to_text(x) + " is beyond " + limit + ", where products leave the range of doubles";
}

std::string too_small(const std::string& what, double x, const char* limit = "2^-400")
{
    return what + " of " + to_text(x) + " is below " + limit + ", where products leave the range of doubles";
}

std::string of_sphere(const Sphere& s)
{
    const double size = std::max(s.radius, largest(s.position));
    if (!(size <= largest_size)) return too_large(s.id + ": a length", size);
    if (!(s.radius >= smallest_size)) return too_small(s.id + ": a radius", s.radius);
    if (!(s.mass <= largest_size)) return too_large(s.id + ": a mass", s.mass);
    if (!(s.mass >= smallest_size)) return too_small(s.id + ": a mass", s.mass);
    if (!(largest(s.velocity) <= largest_size)) return too_large(s.id + ": a speed", largest(s.velocity));
    return {};
}

struct Speeds {
    double fastest = 0;  ///< [length/time]
    double gain = 1;     ///< with which the lightest sphere would have the energy of all, if all were the fastest [1]
};

Speeds speeds_of(const Scene& scene)
{
    double heaviest = 0, lightest = std::numeric_limits<double>::infinity(), fastest = 0;
    for (const Sphere& s : scene.spheres) {
        if (s.fixed) continue;
        heaviest = std::max(heaviest, s.mass);
        lightest = std::min(lightest, s.mass);
        fastest = std::max(fastest, length(s.velocity));
    }
    return {fastest, std::sqrt(static_cast<double>(scene.spheres.size()) * (heaviest / lightest))};
}

std::string of_frame(const Scene& scene, double until)
{
    const Frame frame = make_frame(scene);
    for (const Sphere& s : scene.spheres)
        if (!(largest(s.position) <= furthest_in_scenes * frame.cell_size))
            return s.id + ": a place " + to_text(largest(s.position)) +
                   " is beyond 2^60 times the smallest radius (move the origin, or leave the smallest sphere out)";
    if (!(until <= furthest_in_scenes * frame.epoch_length))
        return "an end at " + to_text(until) + " is too far for the fastest sphere: it passes its radius in " +
               to_text(frame.epoch_length) + ", and times are exact up to " +
               to_text(furthest_in_scenes * frame.epoch_length) + " (choose an earlier end)";
    return {};
}

}  // namespace

std::string out_of_range(const Scene& scene, double until)
{
    if (!(std::max(until, scene.end_time) <= longest_run))
        return too_large("a time", std::max(until, scene.end_time), "2^800");
    if (!(largest(scene.gravity) <= largest_size)) return too_large("an acceleration", largest(scene.gravity));
    if (const double g = largest(scene.gravity); g > 0 && g < weakest_gravity)
        return too_small("an acceleration", g, "2^-1000");
    if (!(scene.drag <= largest_size)) return too_large("a drag", scene.drag);
    if (!(scene.drag * until <= longest_run)) return too_large("drag times the end", scene.drag * until, "2^800");
    for (const Sphere& s : scene.spheres)
        if (std::string why = of_sphere(s); !why.empty()) return why;
    for (const Plane& p : scene.planes)
        if (const double size = std::max(std::abs(p.offset), p.thickness.value_or(0)); !(size <= largest_size))
            return too_large(p.id + ": a length", size);
    const auto [fastest, gain] = speeds_of(scene);
    const double reached = fastest == 0 ? 0 : gain * fastest;
    if (!(reached <= largest_size)) return too_large("the lightest sphere with all the energy: a speed", reached);
    if (!((reached + length(scene.gravity) * until) * until <= longest_flight))
        return "an end at " + to_text(until) + " is so late that a flight until then leaves the range of doubles";
    return of_frame(scene, until);
}

bool goes_far(const Scene& scene, double until)
{
    const auto [fastest, gain] = speeds_of(scene);
    const double way = gain * (fastest + length(scene.gravity) * until) * until;
    double radius = std::numeric_limits<double>::infinity(), apart = 0;
    for (const Sphere& s : scene.spheres) {
        radius = std::min(radius, s.radius);
        apart = std::max(apart, length(s.position - scene.spheres.front().position));
    }
    return !(apart + way <= furthest_in_lists * radius);
}

}  // namespace carom
