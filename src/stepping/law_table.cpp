#include "stepping/law_table.hpp"

namespace carom::stepping {

LawTable::LawTable(const Scene& scene) : materials_(scene.materials.size())
{
    const int n = static_cast<int>(materials_);
    for (int a = 0; a < n; ++a)
        for (int b = 0; b < n; ++b) spheres_.push_back(sphere_contact_law(scene, a, b));
    for (const Plane& p : scene.planes)
        for (int a = 0; a < n; ++a) planes_.push_back(plane_contact_law(scene, a, p.material));
}

}  // namespace carom::stepping
