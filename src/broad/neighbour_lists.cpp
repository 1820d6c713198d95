#include "broad/neighbour_lists.hpp"

#include "flight/flight.hpp"

#include <algorithm>

namespace carom {

namespace {

double largest(const std::vector<double>& reaches)
{
    return *std::max_element(reaches.begin(), reaches.end());
}

std::vector<Place> seen_from(const Place& origin, std::vector<Place> places)
{
    for (Place& place : places)
        for (int k = 0; k < 3; ++k) place.cell[k] -= origin.cell[k];
    return places;
}

}  // namespace

NeighbourLists::NeighbourLists(const Frame& frame, const Place& origin, const std::vector<Place>& places,
                               std::vector<double> reaches, double shell)
    : origin_(origin),
      grid_(frame, seen_from(origin, places), (2 * largest(reaches) + shell) * (1 + shell_slack)),
      reaches_(std::move(reaches)),
      escape_radius_(shell / 2 * (1 - shell_slack)),
      counts_(places.size(), 0),
      room_(first_room),
      lists_(places.size() * room_)
{
    for (double& reach : reaches_) reach += shell / 2;
    for (const Place& place : places) centres_.push_back(separation(frame, place, origin));
    for (std::size_t i = 0; i < places.size(); ++i) {
        const auto body = static_cast<BodyId>(i);
        grid_.neighbours(body, [&](BodyId other) {
            if (other > body || !is_near(centres_[i], reaches_[i], other)) return;
            add(body, other);
            add(other, body);
        });
    }
}

bool NeighbourLists::is_near(const Vec3& centre, double reach, BodyId other) const
{
    const auto j = static_cast<std::size_t>(other);
    const double x = centre[0] - centres_[j][0], y = centre[1] - centres_[j][1], z = centre[2] - centres_[j][2],
                 both = reach + reaches_[j];
    return x * x + y * y + z * z < both * both;
}

void NeighbourLists::file(BodyId body, const Vec3& position)
{
    const auto i = static_cast<std::size_t>(body);
    const Vec3 before = centres_[i];
    const double reach = reaches_[i];
    for (std::uint32_t k = counts_[i]; k-- > 0;) {
        BodyId& other = lists_[i * room_ + k];
        if (is_near(position, reach, other)) continue;
        remove(other, body);
        other = lists_[i * room_ + --counts_[i]];
    }
    centres_[i] = position;
    grid_.file_at(body, position);
    // Lists hold exactly those that are near, so that only newcomers are to be added.
    grid_.neighbours(body, [&](BodyId other) {
        if (!is_near(position, reach, other) || is_near(before, reach, other)) return;
        add(body, other);
        add(other, body);
    });
}

void NeighbourLists::remove(BodyId from, BodyId other)
{
    const auto i = static_cast<std::size_t>(from);
    BodyId* const list = lists_.data() + i * room_;
    *std::find(list, list + counts_[i], other) = list[counts_[i] - 1];
    --counts_[i];
}

void NeighbourLists::add(BodyId to, BodyId other)
{
    const auto i = static_cast<std::size_t>(to);
    if (counts_[i] == room_) {
        std::vector<BodyId> wider(2 * lists_.size());
        for (std::size_t k = 0; k < counts_.size(); ++k)
            std::copy_n(lists_.data() + k * room_, counts_[k], wider.data() + 2 * k * room_);
        lists_ = std::move(wider);
        room_ *= 2;
    }
    lists_[i * room_ + counts_[i]++] = other;
}

}  // namespace carom
