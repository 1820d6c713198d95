/// \file
/// The coefficients of every pair of materials, looked up once a run.
#pragma once

#include <carom/scene.hpp>

#include <algorithm>
#include <vector>

namespace carom {

class ContactLaws {
public:
    explicit ContactLaws(const Scene& scene) : count_(scene.materials.size())
    {
        for (std::size_t i = 0; i < count_; ++i)
            for (std::size_t j = 0; j < count_; ++j) {
                spheres_.push_back(sphere_contact_law(scene, static_cast<int>(i), static_cast<int>(j)));
                planes_.push_back(plane_contact_law(scene, static_cast<int>(i), static_cast<int>(j)));
            }
    }

    bool lose_energy() const
    {
        const auto loses = [](const ContactLaw& law) { return law.restitution < 1; };
        return std::any_of(spheres_.begin(), spheres_.end(), loses) ||
               std::any_of(planes_.begin(), planes_.end(), loses);
    }
    /// The largest restitution of all that is at most this one; 0 if none is.
    double restitution_up_to(double most) const
    {
        double largest = 0;
        for (const auto* laws : {&spheres_, &planes_})
            for (const ContactLaw& law : *laws)
                if (law.restitution <= most) largest = std::max(largest, law.restitution);
        return largest;
    }
    const ContactLaw& spheres(int a, int b) const { return spheres_[index(a, b)]; }
    const ContactLaw& plane(int sphere, int plane) const { return planes_[index(sphere, plane)]; }

private:
    std::size_t index(int a, int b) const { return static_cast<std::size_t>(a) * count_ + static_cast<std::size_t>(b); }

    std::size_t count_;
    std::vector<ContactLaw> spheres_, planes_;
};

}  // namespace carom
