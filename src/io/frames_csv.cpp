#include "io/frames_csv.hpp"

#include "io/numbers.hpp"

#include <ostream>

namespace carom::io {

FramesCsv::FramesCsv(std::ostream& out, const Scene& scene) : out_(out)
{
    for (const Sphere& sphere : scene.spheres) ids_.push_back(csv_field(sphere.id));
    out_ << frames_csv_header << '\n';
}

void FramesCsv::write(double time, std::span<const BodyState> states)
{
    const std::string t = number_text(time);
    std::string rows;
    for (std::size_t i = 0; i < states.size(); ++i) {
        rows.append(t).append(",").append(ids_[i]);
        for (int axis = 0; axis < 3; ++axis) rows.append(",").append(number_text(states[i].position[axis]));
        rows.append("\n");
    }
    out_ << rows;
}

}  // namespace carom::io
