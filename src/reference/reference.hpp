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

/// A Zeno series of bounces of one sphere on a plane or a fixed sphere, lower than a thousandth of its radius, to be
/// expanded by whoever matches impacts: bounce k >= 1 happens at start + 2 v0 (1 - e^k) / (g_n (1 - e)), on a sphere up
/// to the turning of the normal; the last one before `end`.
struct ReferenceSeries {
    double start = 0;  ///< time of the impact that began it (that impact is listed among the impacts) [time]
    double end = 0;    ///< start + 2 v0 / (g_n (1 - e)), or the impact with another body that broke it off [time]
    BodyId body = no_body, plane = no_body;  ///< the sphere, and what it bounces on
    double normal_speed = 0;                 ///< v0 after that impact [length/time]
    double restitution = 0;                  ///< e
    double gravity = 0;  ///< g_n = -g.n > 0, on a sphere less what its curvature takes [length/time^2]
};

/// A contact that persists: declared by the scene, or left by bounces whose rest is below 1e-30 of the first.
struct ReferenceContact {
    double begin = 0, end = 0;        ///< [time]
    BodyId a = no_body, b = no_body;  ///< as in Event
};

/// An instant of several contacts, whose outcome the axioms of rigid bodies leave open: what each operator makes of it.
struct ReferenceConvention {
    struct Answer {
        ImpactOperator impact_operator = ImpactOperator::reflections;
        std::vector<Vec3> velocities;  ///< after it, of `bodies` [length/time]
    };
    double time = 0;              ///< since the start of the run [time]
    std::vector<BodyId> bodies;   ///< those of it that move
    std::vector<Answer> answers;  ///< `reflections`, `sequential`, and `lcp` by the scene's law
    bool differ = false;          ///< by more than 1e-9 of the largest speed
};

struct Reference {
    enum class Kind { closed_form, multiprecision };
    Kind kind = Kind::multiprecision;
    double until = 0;                  ///< valid up to here, <= the end asked for [time]
    std::string reason;                ///< why it ends before the end asked for; empty if it does not
    bool stopped = false;              ///< on request, at `until`
    double bound = 0;                  ///< largest of `bounds` [length]
    std::vector<double> sample_times;  ///< those asked for that are <= until
    std::vector<double> bounds;  ///< per sample: 2 max |x50 - x100| over spheres, runs that differ in precision and in
                                 ///< the tolerance of their steps, plus the rounding of the samples to double [length]
    std::vector<std::vector<BodyState>> samples;  ///< [sample][sphere]
    std::vector<ReferenceImpact> impacts;  ///< in time order, up to `until`; of a pair those at different doubles
    std::vector<ReferenceSeries> series;
    std::vector<ReferenceContact> contacts;        ///< by their beginning
    std::vector<ReferenceConvention> conventions;  ///< in time order, the first 100
    std::int64_t root_solves = 0;
};

/// The truth that materials and the impact operator of the scene define; its thresholds of rest and guard are not read.
/// Bounces are followed until their speeds are below 1e-30 of the first, contacts that carry force while their normals
/// turn are integrated, and where several contacts make one instant it goes on with the scene's operator and notes what
/// others say.
/// \pre the scene is valid. The end is the first sample at which the bound exceeds 1e-6 of the smallest radius (chaos),
/// or what is not done: more work than 250,000 impacts (e near 1, bounces within bounces), several contacts
/// at once for `shock` or `jacobi` or with attenuation, more than 128 of them, or contacts whose forces are not unique
/// while their normals turn. `reason` says which, who and when. Where `on_progress` stops it, it ends at the last
/// sample reached.
Reference make_reference(const Scene& scene, double until, std::span<const double> sample_times,
                         const OnProgress& on_progress = {});

}  // namespace carom
