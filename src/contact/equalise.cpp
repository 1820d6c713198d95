#include "contact/equalise.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace carom {

namespace {

using Numbers = std::vector<double>;
using Vectors = std::vector<Vec3>;

/// How much further than the widest gap that is to close (or the fastest) a body may go: a tower of a thousand needs 640
/// (1000 * 2 / pi, from its smallest singular value). A sphere pinched between two that do not give way could close both
/// gaps a few radii aside, where their normals differ.
constexpr double stretch = 0x1p12;

double square(const Numbers& x)
{
    double sum = 0;
    for (const double each : x) sum += each * each;
    return sum;
}

double square(const Vectors& x)
{
    double sum = 0;
    for (const Vec3& each : x) sum += each.squaredNorm();
    return sum;
}

/// The contacts in mass-scaled coordinates, each row of unit length.
class Rows {
public:
    explicit Rows(const Cluster& cluster) : cluster_(cluster)
    {
        for (const ClusterBody& body : cluster.bodies) lightness_.push_back(std::sqrt(body.inverse_mass));
        for (const ClusterContact& c : cluster.contacts) {
            const double of_b = c.b == immovable ? 0 : cluster.bodies[static_cast<std::size_t>(c.b)].inverse_mass;
            const double of_a = cluster.bodies[static_cast<std::size_t>(c.a)].inverse_mass;
            scale_.push_back(1 / std::sqrt(c.normal.squaredNorm() * (of_a + of_b)));
        }
    }

    double scale(std::size_t contact) const { return scale_[contact]; }
    double lightness(std::size_t body) const { return lightness_[body]; }

    /// Of the changes that u stands for, the longest.
    double largest(const Vectors& u) const
    {
        double out = 0;
        for (std::size_t k = 0; k < u.size(); ++k) out = std::max(out, lightness_[k] * u[k].norm());
        return out;
    }

    Numbers times(const Vectors& u) const
    {
        Numbers out;
        for (std::size_t i = 0; i < scale_.size(); ++i) {
            const ClusterContact& c = cluster_.contacts[i];
            const auto a = static_cast<std::size_t>(c.a);
            double rate = lightness_[a] * c.normal.dot(u[a]);
            if (c.b != immovable) {
                const auto b = static_cast<std::size_t>(c.b);
                rate -= lightness_[b] * c.normal.dot(u[b]);
            }
            out.push_back(scale_[i] * rate);
        }
        return out;
    }

    Vectors transposed_times(const Numbers& x) const
    {
        Vectors out(lightness_.size(), Vec3::Zero());
        for (std::size_t i = 0; i < scale_.size(); ++i) {
            const ClusterContact& c = cluster_.contacts[i];
            const auto a = static_cast<std::size_t>(c.a);
            out[a] += (lightness_[a] * scale_[i] * x[i]) * c.normal;
            if (c.b == immovable) continue;
            const auto b = static_cast<std::size_t>(c.b);
            out[b] -= (lightness_[b] * scale_[i] * x[i]) * c.normal;
        }
        return out;
    }

private:
    const Cluster& cluster_;
    Numbers lightness_, scale_;
};

}  // namespace

EqualisingChange equalising_change(const Cluster& cluster, std::span<const double> wanted)
{
    const Rows rows(cluster);
    Numbers residual;
    for (std::size_t i = 0; i < wanted.size(); ++i) residual.push_back(rows.scale(i) * wanted[i]);
    // u = A x, and direction = A combination, throughout.
    Vectors u(cluster.bodies.size(), Vec3::Zero());
    Numbers x(residual.size(), 0), combination = residual;
    Vectors direction = rows.transposed_times(residual);
    double size = square(direction);
    const double enough = 0x1p-106 * square(residual);  // squares: the rounding of what is wanted
    const std::size_t most = 20 + 2 * (wanted.size() + 3 * u.size());
    double left = square(residual);
    double far = 0;
    for (const double each : wanted) far = std::max(far, stretch * std::abs(each));
    for (std::size_t step = 0; step < most && size > enough; ++step) {
        const Numbers image = rows.times(direction);
        const double length = size / square(image);
        if (!std::isfinite(length)) break;
        // Exactly, every step shrinks the residual by length * size. Once rounding has it otherwise, all is done.
        Numbers next_residual = residual;
        for (std::size_t i = 0; i < residual.size(); ++i) next_residual[i] -= length * image[i];
        const double next_left = square(next_residual);
        if (!(next_left < left)) break;
        left = next_left;
        Vectors next_u = u;
        for (std::size_t k = 0; k < u.size(); ++k) next_u[k] += length * direction[k];
        if (!(rows.largest(next_u) <= far)) break;
        u = std::move(next_u);
        for (std::size_t i = 0; i < residual.size(); ++i) x[i] += length * combination[i];
        residual = std::move(next_residual);
        const Vectors gradient = rows.transposed_times(residual);
        const double next = square(gradient), ratio = next / size;
        for (std::size_t k = 0; k < u.size(); ++k) direction[k] = gradient[k] + ratio * direction[k];
        for (std::size_t i = 0; i < x.size(); ++i) combination[i] = residual[i] + ratio * combination[i];
        size = next;
    }
    for (std::size_t k = 0; k < u.size(); ++k) u[k] *= rows.lightness(k);
    for (std::size_t i = 0; i < x.size(); ++i) x[i] *= rows.scale(i);
    return {std::move(u), std::move(x)};
}

}  // namespace carom
