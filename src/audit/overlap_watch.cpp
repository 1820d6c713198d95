#include "audit/overlap_watch.hpp"

#include "audit/tolerances.hpp"
#include "scene/tolerances.hpp"

#include <algorithm>

namespace carom::audit {

double OverlapWatch::depth(const Pair& pair, const SeenFrame& frame) const
{
    const auto a = static_cast<std::size_t>(pair.first), b = static_cast<std::size_t>(pair.second);
    return -gap(scene_, pair.first, frame.places[a], pair.second,
                b < frame.places.size() ? frame.places[b] : Vec3::Zero());
}

double OverlapWatch::tolerance(const Pair& pair, const SeenFrame& frame) const
{
    const auto a = static_cast<std::size_t>(pair.first), b = static_cast<std::size_t>(pair.second);
    const bool is_sphere = b < frame.places.size();
    const double r = scene_.spheres[a].radius;
    const double smaller = is_sphere ? std::min(r, scene_.spheres[b].radius) : r;
    return frame.errors[a] + (is_sphere ? frame.errors[b] : 0) + declared_contact * smaller;
}

bool OverlapWatch::overlaps(const Pair& pair, const SeenFrame& frame) const
{
    return depth(pair, frame) > tolerance(pair, frame);
}

Finding OverlapWatch::begun(const Pair& pair, const SeenFrame& from, const SeenFrame& to) const
{
    Finding finding;
    finding.kind = FindingKind::overlap;
    finding.time = to.time;
    finding.a = pair.first;
    finding.b = pair.second;
    // The scene begins with the frame before, unless they overlap there, too.
    const double span = to.time - from.time;
    const bool approach = span > 0 && !overlaps(pair, from);
    finding.begin = approach ? from.time : to.time;
    finding.span = span;
    for (const BodyId body : {pair.first, pair.second}) {
        const auto i = static_cast<std::size_t>(body);
        if (i >= to.places.size()) continue;
        const bool moves = approach && !scene_.spheres[i].fixed;
        Vec3 velocity = Vec3::Zero();
        if (moves) {
            const Vec3 mean = (to.places[i] - from.places[i]) / span;
            velocity = mean - span / 2 * (scene_.gravity - scene_.drag * mean);
        }
        finding.bodies.push_back({body, (approach ? from : to).places[i], velocity});
    }
    return finding;
}

std::vector<Finding> OverlapWatch::look(const SeenFrame& from, const SeenFrame& to, const std::vector<Pair>& near)
{
    const auto see = [&](const Pair& pair) {
        if (overlaps(pair, to)) going_on_.try_emplace(pair, begun(pair, from, to));
    };
    for (const Pair& pair : near) see(pair);
    for (std::size_t i = 0; i < to.places.size(); ++i)
        for (std::size_t p = 0; p < scene_.planes.size() && !scene_.spheres[i].fixed; ++p)
            see({static_cast<BodyId>(i), scene_.plane_body(p)});
    std::vector<Finding> ended;
    for (auto each = going_on_.begin(); each != going_on_.end();) {
        Finding& finding = each->second;
        if (overlaps(each->first, to)) {
            finding.depth = std::max(finding.depth, depth(each->first, to));
            ++each;
            continue;
        }
        ended.push_back(finding);
        each = going_on_.erase(each);
    }
    return ended;
}

std::vector<Finding> OverlapWatch::rest() const
{
    std::vector<Finding> findings;
    for (const auto& [pair, finding] : going_on_) findings.push_back(finding);
    return findings;
}

Pairs OverlapWatch::pairs() const
{
    Pairs pairs;
    for (const auto& [pair, finding] : going_on_) pairs.insert(pair);
    return pairs;
}

}  // namespace carom::audit
