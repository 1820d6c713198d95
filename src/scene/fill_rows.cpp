// Patterns without a region: line and triangle.
#include <cmath>

#include "scene/fill_patterns.hpp"

namespace carom {

Places place(const LinePattern& line, const std::vector<double>& radii)
{
    Places places;
    places.centres.reserve(radii.size());
    double along = 0;
    for (std::size_t k = 0; k < radii.size(); ++k) {
        if (k > 0) along += radii[k - 1] + line.gap + radii[k];
        places.centres.push_back(line.origin + along * line.axis);
    }
    return places;
}

Places place(const TrianglePattern& triangle, const std::vector<double>& radii)
{
    const Vec3 sideways(triangle.axis.y(), -triangle.axis.x(), 0);  // axis x z
    const Vec3 across = sideways / std::sqrt(sideways.squaredNorm());
    const double spacing = 2 * radii.front() + triangle.gap;
    const double row_spacing = spacing * std::sqrt(3.0) / 2;
    Places places;
    places.centres.reserve(radii.size());
    for (std::size_t row = 0; places.centres.size() < radii.size(); ++row)
        for (std::size_t k = 0; k <= row && places.centres.size() < radii.size(); ++k) {
            const double along = static_cast<double>(row) * row_spacing;
            const double aside = (static_cast<double>(k) - static_cast<double>(row) / 2) * spacing;
            places.centres.push_back(triangle.origin + along * triangle.axis + aside * across);
        }
    return places;
}

}  // namespace carom
