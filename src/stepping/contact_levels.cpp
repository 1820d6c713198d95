#include "stepping/contact_levels.hpp"

#include <algorithm>
#include <limits>

namespace carom::stepping {

namespace {

constexpr std::size_t no_level = std::numeric_limits<std::size_t>::max();

std::size_t index(BodyId body)
{
    return static_cast<std::size_t>(body);
}

/// Whether it never moves: a wall or a fixed sphere.
bool is_ground(const Bodies& bodies, BodyId body)
{
    return index(body) >= bodies.size() || bodies.inverse_mass[index(body)] == 0;
}

}  // namespace

void ContactLevels::find_neighbours(const Bodies& bodies, const std::vector<Contact>& contacts)
{
    const auto for_each_free_pair = [&](auto&& visit) {
        for (const Contact& c : contacts) {
            if (is_ground(bodies, c.a) || is_ground(bodies, c.b)) continue;
            visit(index(c.a), index(c.b));
            visit(index(c.b), index(c.a));
        }
    };
    first_neighbour_.assign(bodies.size() + 1, 0);
    for_each_free_pair([&](std::size_t of, std::size_t) { ++first_neighbour_[of + 1]; });
    for (std::size_t i = 0; i < bodies.size(); ++i) first_neighbour_[i + 1] += first_neighbour_[i];
    neighbour_.resize(first_neighbour_.back());
    std::vector<std::size_t> next(first_neighbour_.begin(), first_neighbour_.end() - 1);
    for_each_free_pair([&](std::size_t of, std::size_t other) { neighbour_[next[of]++] = other; });
}

void ContactLevels::find_levels(const Bodies& bodies, const std::vector<Contact>& contacts)
{
    find_neighbours(bodies, contacts);
    level_.assign(bodies.size(), no_level);
    spheres_.clear();
    first_sphere_.assign(1, 0);
    const auto reach = [&](std::size_t sphere, std::size_t level) {
        if (level_[sphere] != no_level) return;
        level_[sphere] = level;
        spheres_.push_back(sphere);
    };
    for (const Contact& c : contacts) {
        if (is_ground(bodies, c.b) && !is_ground(bodies, c.a)) reach(index(c.a), 0);
        if (is_ground(bodies, c.a) && !is_ground(bodies, c.b)) reach(index(c.b), 0);
    }
    for (std::size_t level = 0; first_sphere_.back() < spheres_.size(); ++level) {
        const std::size_t begin = first_sphere_.back(), end = spheres_.size();
        first_sphere_.push_back(end);
        for (std::size_t k = begin; k < end; ++k)
            for (std::size_t m = first_neighbour_[spheres_[k]]; m < first_neighbour_[spheres_[k] + 1]; ++m)
                reach(neighbour_[m], level + 1);
    }
}

void ContactLevels::arrange(const Bodies& bodies, std::vector<Contact>& contacts)
{
    find_levels(bodies, contacts);
    const auto level_of = [&](BodyId body) { return is_ground(bodies, body) ? 0 : level_[index(body)]; };
    const auto level = [&](const Contact& c) { return std::max(level_of(c.a), level_of(c.b)); };
    std::stable_sort(contacts.begin(), contacts.end(),
                     [&](const Contact& c, const Contact& d) { return level(c) < level(d); });
    const std::size_t levels = first_sphere_.size() - 1;
    first_contact_.assign(1, 0);
    for (std::size_t k = 0, passed = 0; passed < levels; ++passed) {
        while (k < contacts.size() && level(contacts[k]) <= passed) ++k;
        first_contact_.push_back(k);
    }
}

}  // namespace carom::stepping
