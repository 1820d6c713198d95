#include "contact/equalise.hpp"

#include "support/random.hpp"

#include <catch2/catch.hpp>

#include <Eigen/Dense>

#include <cmath>

using namespace carom;
using carom::test::Random;

namespace {

ContactProblem random_cluster(Random& random, double mass_ratio)
{
    ContactProblem out;
    const int bodies = random.integer(1, 6);
    for (int k = 0; k < bodies; ++k) out.bodies.push_back({Vec3::Zero(), 1 / random.log_uniform(1, mass_ratio)});
    const int contacts = random.integer(1, 5 * bodies);
    for (int i = 0; i < contacts; ++i) {
        const int a = random.integer(0, bodies - 1);
        std::optional<int> b = random.integer(-1, bodies - 1);
        if (b < 0 || a == b) b.reset();
        out.contacts.push_back({a, b, random.direction().normalized(), 0, 1});
    }
    return out;
}

/// Rows m^-1/2 n, as the method scales them.
Eigen::MatrixXd rows(const ContactProblem& cluster)
{
    const auto bodies = static_cast<Eigen::Index>(cluster.bodies.size());
    Eigen::MatrixXd out = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(cluster.contacts.size()), 3 * bodies);
    for (std::size_t i = 0; i < cluster.contacts.size(); ++i) {
        const Contact& c = cluster.contacts[i];
        const auto row = static_cast<Eigen::Index>(i);
        const auto put = [&](int body, double sign) {
            const double root = std::sqrt(cluster.bodies[static_cast<std::size_t>(body)].inverse_mass);
            for (int k = 0; k < 3; ++k) out(row, 3 * body + k) = sign * root * c.normal[k];
        };
        put(c.a, 1);
        if (c.b) put(*c.b, -1);
        out.row(row).normalize();
    }
    return out;
}

}  // namespace

TEST_CASE("changes are those of least squares, and impulses make them, however contradictory the wishes")
{
    Random random(21);
    for (int trial = 0; trial < 2000; ++trial) {
        const ContactProblem cluster = random_cluster(random, trial % 2 == 0 ? 1 : 1e6);
        const Eigen::MatrixXd A = rows(cluster);
        Eigen::VectorXd scaled(A.rows());
        std::vector<double> wanted;
        for (std::size_t i = 0; i < cluster.contacts.size(); ++i) {
            const Contact& c = cluster.contacts[i];
            double w = cluster.bodies[static_cast<std::size_t>(c.a)].inverse_mass;
            if (c.b) w += cluster.bodies[static_cast<std::size_t>(*c.b)].inverse_mass;
            const double wish = random.uniform(-1, 1);
            scaled(static_cast<Eigen::Index>(i)) = wish;
            wanted.push_back(wish * std::sqrt(w));
        }
        const EqualisingChange change = equalising_change(cluster, wanted);
        const Eigen::JacobiSVD<Eigen::MatrixXd> svd(A, Eigen::ComputeThinU | Eigen::ComputeThinV);
        const Eigen::VectorXd least = svd.solve(scaled);
        const double small = svd.singularValues().tail(1)[0];
        Eigen::VectorXd got(A.cols()), made = Eigen::VectorXd::Zero(A.cols());
        for (std::size_t k = 0; k < cluster.bodies.size(); ++k)
            for (int j = 0; j < 3; ++j)
                got(static_cast<Eigen::Index>(3 * k) + j) =
                    change.change[k][j] / std::sqrt(cluster.bodies[k].inverse_mass);
        for (std::size_t i = 0; i < cluster.contacts.size(); ++i) {
            const Contact& c = cluster.contacts[i];
            const auto add = [&](int body, double sign) {
                const double root = std::sqrt(cluster.bodies[static_cast<std::size_t>(body)].inverse_mass);
                for (int k = 0; k < 3; ++k) made(3 * body + k) += sign * root * change.impulses[i] * c.normal[k];
            };
            add(c.a, 1);
            if (c.b) add(*c.b, -1);
        }
        CAPTURE(trial, small, least.norm(), got.norm());
        CHECK((made - got).norm() <= 1e-9 * (1 + least.norm()));
        // As good as least squares can be, and no longer; but nobody goes hundreds of times as far as is wanted.
        double far = 0, furthest = 0, asked = 0;
        for (const double wish : wanted) asked = std::max(asked, std::abs(wish));
        for (std::size_t k = 0; k < cluster.bodies.size(); ++k) {
            far = std::max(far, change.change[k].norm());
            furthest = std::max(furthest, std::sqrt(cluster.bodies[k].inverse_mass) *
                                              least.segment<3>(static_cast<Eigen::Index>(3 * k)).norm());
        }
        const bool allowed = furthest <= 250 * asked;
        if (allowed) CHECK((A * got - scaled).norm() <= (A * least - scaled).norm() + 1e-6);
        CHECK(far <= (256 + 4 * static_cast<double>(wanted.size())) * asked);
        if (small > 1e-3 && allowed) CHECK((got - least).norm() <= 1e-6 * (1 + least.norm()));
        CHECK(got.norm() <= 1.001 * least.norm() + 1e-6);
    }
}

TEST_CASE("a sphere pinched by two that do not give way is not moved aside to where their gaps would close")
{
    for (const double tilt : {0.0, 1e-12, 1e-9, 1e-6, 1e-2, 1.0}) {
        ContactProblem cluster;
        cluster.bodies.push_back({Vec3::Zero(), 1});
        cluster.contacts.push_back({0, immovable, Vec3::UnitZ(), 0, 1});
        cluster.contacts.push_back({0, immovable, Vec3(0, std::sin(tilt), -std::cos(tilt)), 0, 1});
        const std::vector<double> wanted{-1e-9, -1e-9};
        const Vec3 change = equalising_change(cluster, wanted).change.front();
        CAPTURE(tilt, change);
        CHECK(change.norm() <= 264e-9);
        if (tilt >= 1e-2) {  // it can be done, and is
            CHECK(cluster.contacts[0].normal.dot(change) == Approx(-1e-9));
            CHECK(cluster.contacts[1].normal.dot(change) == Approx(-1e-9));
        }
    }
}
