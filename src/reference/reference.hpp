/// \file
/// The answer that every method is measured against: a multiprecision run of the same scene by code that shares nothing
/// with the engine.
#pragma once

#include <carom/progress.hpp>
#include <carom/scene.hpp>
#include <carom/simulate.hpp>

#include <span>
#include <string>
#include <vector>

namespace carom {

struct ReferenceImpact {
    double time = 0;                  ///< since the start of the run [time]
    BodyId a = no_body, b = no_body;  ///< as in Event
};

/// A Zeno series of bounces on one plane, to be expanded by whoever matches impacts: bounce k >= 1 happens at
/// start + 2 v0 (1 - e^k) / (g_n (1 - e)); the last one before `end`.
struct ReferenceSeries {
    double start = 0;  ///< time of the impact that began it (that impact is listed among the impacts) [time]
    double end = 0;    ///< start + 2 v0 / (g_n (1 - e)), or the impact with another body that broke it off [time]
    BodyId body = no_body, plane = no_body;
    double normal_speed = 0;  ///< v0 after that impact [length/time]
    double restitution = 0;   ///< e
    double gravity = 0;       ///< g_n = -g.n > 0 [length/time^2]
};

struct Reference {
    enum class Kind { closed_form, multiprecision };
    Kind kind = Kind::multiprecision;
    double until = 0;                  ///< valid up to here, <= the end asked for [time]
    std::string reason;                ///< why it ends before the end asked for; empty if it does not
    bool stopped = false;              ///< on request, at `until`
    double bound = 0;                  ///< largest of `bounds` [length]
    std::vector<double> sample_times;  ///< those asked for that are <= until
    std::vector<double>
        bounds;  ///< per sample: 2 max |x50 - x100| over spheres, plus the rounding of the samples to double [length]
    std::vector<std::vector<BodyState>> samples;  ///< [sample][sphere]
    std::vector<ReferenceImpact> impacts;         ///< in time order, up to `until`
    std::vector<ReferenceSeries> series;
    std::int64_t root_solves = 0;
};

/// \pre the scene is valid. The end is the first sample at which the bound exceeds 1e-6 of the smallest radius, or the
/// first instant beyond which there is no closed form: contacts that carry force while their normals turn, impacts that
/// the guard takes over, rest under another policy than `contact`, several contacts at once for another operator than
/// `reflections` or with attenuation, or more than 128 of them. `reason` says which, who and when. Where `on_progress`
/// stops it, it ends at the last sample reached.
Reference make_reference(const Scene& scene, double until, std::span<const double> sample_times,
                         const OnProgress& on_progress = {});

}  // namespace carom
