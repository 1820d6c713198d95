/// \file
/// Contacts from the ground up, and shock propagation over them (Guendelman, Bridson, Fedkiw, Nonconvex rigid bodies
/// with stacking, SIGGRAPH 2003, section 7): level by level; what is done is infinitely heavy for what stands above it,
/// so that the weight of a stack cannot push it down. What it ought to take is lost: neither momentum nor energy is
/// kept.
///
/// A level is the distance from what does not move, counted in contacts (breadth-first). The paper's graph is directed
/// by gravity, and a cycle is one level; the distance is this project's own, and asks for no direction of gravity.
#pragma once

#include "stepping/bodies.hpp"
#include "stepping/contact.hpp"

#include <cstddef>
#include <vector>

namespace carom::stepping {

class ContactLevels {
public:
    /// Arrange contacts by level, that of the higher one of the two, otherwise as they are; last those that hang
    /// together with nothing fixed, which have no level.
    void arrange(const Bodies& bodies, std::vector<Contact>& contacts);

    /// Calls on_level(begin, end) for the contacts [begin, end) of each level, lowest first, as `arrange` left them,
    /// while the spheres of all lower levels have inverse mass 0.
    template <class OnLevel>
    void propagate(Bodies& bodies, OnLevel&& on_level)
    {
        const std::vector<double> inverse_mass = bodies.inverse_mass;
        for (std::size_t level = 0; level + 1 < first_contact_.size(); ++level) {
            on_level(first_contact_[level], first_contact_[level + 1]);
            for (std::size_t k = first_sphere_[level]; k < first_sphere_[level + 1]; ++k)
                bodies.inverse_mass[spheres_[k]] = 0;
        }
        bodies.inverse_mass = inverse_mass;
    }

private:
    void find_neighbours(const Bodies& bodies, const std::vector<Contact>& contacts);
    void find_levels(const Bodies& bodies, const std::vector<Contact>& contacts);

    std::vector<std::size_t> level_;            ///< of each sphere; that of the lowest is 0
    std::vector<std::size_t> spheres_;          ///< those that have a level, by level
    std::vector<std::size_t> first_sphere_;     ///< index into spheres_ of the first of each level, and one beyond
    std::vector<std::size_t> first_contact_;    ///< the same for the contacts
    std::vector<std::size_t> neighbour_;        ///< spheres in contact with each sphere, one sphere after the other
    std::vector<std::size_t> first_neighbour_;  ///< index into neighbour_ for each sphere, and one beyond
};

}  // namespace carom::stepping
