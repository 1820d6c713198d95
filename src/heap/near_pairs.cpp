#include "heap/near_pairs.hpp"

#include "heap/tolerances.hpp"
#include "motion/height.hpp"

#include <algorithm>
#include <limits>
#include <unordered_map>

namespace carom {

namespace {

class Lister {
public:
    Lister(const State& state, Moment& moment, double skin, const StandsStill& stands_still, const Neighbourhood& wide)
        : state_(state), moment_(moment), skin_(skin), stands_still_(stands_still), wide_(wide)
    {
    }

    std::shared_ptr<const NearPairs> list(const std::vector<BodyId>& seeds)
    {
        for (const BodyId seed : seeds) enter(seed);
        for (std::size_t k = 0; k < frontier_.size(); ++k) look_around(frontier_[k]);
        auto out = std::make_shared<NearPairs>();
        out->skin = skin_;
        for (const auto& [body, place] : places_) out->bodies.push_back(body);
        std::sort(out->bodies.begin(), out->bodies.end());
        std::unordered_map<BodyId, int> number;
        for (const BodyId body : out->bodies) {
            number.emplace(body, static_cast<int>(number.size()));
            out->places.push_back(places_.at(body));
            out->still.push_back(stands_still_(body));
        }
        out->smallest = std::numeric_limits<double>::infinity();
        for (const BodyId body : frontier_) out->smallest = std::min(out->smallest, state_.radius(body));
        for (const NearPair& pair : found_)
            out->pairs.push_back(
                {number.at(pair.a), pair.b.is_plane() ? pair.b : Partner::sphere(number.at(pair.b.index))});
        std::sort(out->pairs.begin(), out->pairs.end(),
                  [](const NearPair& x, const NearPair& y) { return x.a != y.a ? x.a < y.a : x.b < y.b; });
        return out;
    }

private:
    void enter(BodyId body)
    {
        if (places_.try_emplace(body, moment_.flight(body).place).second && !stands_still_(body))
            frontier_.push_back(body);
    }

    void look_around(BodyId body)
    {
        const Place place = places_.at(body);
        for (int p = 0; p < state_.planes(); ++p)
            if (height_above(state_, body, p, place) < skin_) found_.push_back({body, Partner::plane(p)});
        near_.clear();
        for (const BodyId other : wide_(body)) near_.push_back(other);
        for (const BodyId other : near_) {
            const auto known = places_.find(other);
            const Place its = known != places_.end() ? known->second : moment_.flight(other).place;
            const double reach = state_.radius(body) + state_.radius(other) + skin_;
            if (!(separation(state_.frame, place, its).squaredNorm() < reach * reach)) continue;
            enter(other);
            if (body < other || stands_still_(other)) found_.push_back({body, Partner::sphere(other)});
        }
    }

    const State& state_;
    Moment& moment_;
    const double skin_;
    const StandsStill& stands_still_;
    const Neighbourhood& wide_;
    std::unordered_map<BodyId, Place> places_;  ///< of all that was found
    std::vector<BodyId> frontier_, near_;
    std::vector<NearPair> found_;  ///< with the numbers of the scene
};

}  // namespace

std::shared_ptr<const NearPairs> list_near(const State& state, Moment& moment, const std::vector<BodyId>& seeds,
                                           double skin, const StandsStill& stands_still, const Neighbourhood& wide)
{
    return Lister(state, moment, skin, stands_still, wide).list(seeds);
}

double widest_skin(const State& state)
{
    double largest = 0;
    for (BodyId i = 0; i < state.count(); ++i) largest = std::max(largest, state.radius(i));
    return widest_skin_of_grid * largest;
}

}  // namespace carom
