#include "generated/shrink.hpp"

#include <algorithm>

namespace carom::test {

namespace {

class Shrinker {
public:
    Shrinker(Scene scene, const std::function<bool(const Scene&)>& still_fails, int tries)
        : scene_(std::move(scene)), still_fails_(still_fails), left_(tries)
    {
    }

    Scene smallest()
    {
        shorten();
        for (bool smaller = true; smaller && left_ > 0;) {
            smaller = without_some(&Scene::spheres);
            smaller = without_some(&Scene::planes) || smaller;
        }
        shorten();
        return std::move(scene_);
    }

private:
    bool keep_if_failing(const Scene& candidate)
    {
        if (left_ <= 0 || candidate.spheres.empty() || !validate(candidate).empty()) return false;
        --left_;
        if (!still_fails_(candidate)) return false;
        scene_ = candidate;
        return true;
    }

    void shorten()
    {
        constexpr double shorter = 0.6;
        Scene candidate = scene_;
        do {
            candidate.end_time = scene_.end_time * shorter;
        } while (keep_if_failing(candidate));
    }

    /// Halves, quarters, .. of a list left out (delta debugging: Zeller and Hildebrandt 2002).
    template <class Body>
    bool without_some(std::vector<Body> Scene::*list)
    {
        bool smaller = false;
        for (std::size_t size = (scene_.*list).size(); size > 0; size /= 2)
            for (std::size_t first = 0; first < (scene_.*list).size();) {
                Scene candidate = scene_;
                auto& bodies = candidate.*list;
                const auto begin = bodies.begin() + static_cast<std::ptrdiff_t>(first);
                bodies.erase(begin, begin + static_cast<std::ptrdiff_t>(std::min(size, bodies.size() - first)));
                if (keep_if_failing(candidate))
                    smaller = true;
                else
                    first += size;
            }
        return smaller;
    }

    Scene scene_;
    const std::function<bool(const Scene&)>& still_fails_;
    int left_;
};

}  // namespace

Scene shrink(Scene scene, const std::function<bool(const Scene&)>& still_fails, int tries)
{
    return Shrinker(std::move(scene), still_fails, tries).smallest();
}

}  // namespace carom::test
