/// \file
/// Contact coefficients looked up by material, computed once a run.
#pragma once

#include <carom/scene.hpp>

#include <vector>

namespace carom::stepping {

class LawTable {
public:
    explicit LawTable(const Scene& scene);

    const ContactLaw& spheres(int material_a, int material_b) const { return spheres_[index(material_a, material_b)]; }
    const ContactLaw& plane(int sphere_material, std::size_t plane) const
    {
        return planes_[plane * materials_ + static_cast<std::size_t>(sphere_material)];
    }

private:
    std::size_t index(int a, int b) const
    {
        return static_cast<std::size_t>(a) * materials_ + static_cast<std::size_t>(b);
    }
    std::size_t materials_;
    std::vector<ContactLaw> spheres_, planes_;
};

}  // namespace carom::stepping
