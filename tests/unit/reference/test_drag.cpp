#include "exactly.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

using namespace carom;
using namespace carom::test;

namespace {

/// Digits of another library than the reference's, with its own exponential.
using Other = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<80>, boost::multiprecision::et_off>;

/// One coordinate of dv/dt = g - k v, as the textbook has it.
struct Coordinate {
    Other x, v, g, k;

    Other place(const Other& t) const { return x + g * t / k + (v - g / k) * (1 - exp(-k * t)) / k; }
    Other velocity(const Other& t) const { return g / k + (v - g / k) * exp(-k * t); }
    void go(const Other& t)
    {
        const Other there = place(t);
        v = velocity(t);
        x = there;
    }
};

/// The root of a function that is above 0 at `low` and not at `high`, halved to 70 digits.
Other root(const std::function<Other(const Other&)>& f, Other low, Other high)
{
    for (int i = 0; i < 240; ++i) {
        const Other middle = (low + high) / 2;
        (f(middle) > 0 ? low : high) = middle;
    }
    return high;
}

double off(const Real& found, const Other& expected)
{
    return std::abs(static_cast<double>(Other(found.str(60, std::ios::scientific)) - expected));
}

Scene damped(Scene scene, double drag)
{
    scene.drag = drag;
    return scene;
}

constexpr double digits_48 = 1e-48;

}  // namespace

TEST_CASE("A throw in a viscous field is the textbook's, to 48 digits, for weak and strong drag", "[reference]")
{
    for (const double k : {1e-9, 0.03, 0.7, 55.0}) {
        Scene scene;
        scene.gravity = {0.5, 0, -9.75};
        scene.drag = k;
        scene.spheres = {ball("ball", {1, 2, 3}, {4, -5, 6})};
        Exact run = exactly(scene, 4);
        const Other t = 2.5;
        const Coordinate x{1, 4, 0.5, k}, y{2, -5, 0, k}, z{3, 6, -9.75, k};
        const auto p = run.flight(0).position(2.5), v = run.flight(0).velocity(2.5);
        // The textbook's formula itself loses digits where k t is small.
        const double lost = digits_48 + 1e-78 / (k * k);
        CAPTURE(k);
        CHECK(off(p.x, x.place(t)) < lost);
        CHECK(off(p.y, y.place(t)) < lost);
        CHECK(off(p.z, z.place(t)) < lost);
        CHECK(off(v.x, x.velocity(t)) < lost);
        CHECK(off(v.z, z.velocity(t)) < lost);
    }
}

TEST_CASE("Bounces under drag follow the textbook's flights, one by one, to 45 digits", "[reference]")
{
    const double e = 0.8, k = 0.9;
    Scene scene = damped(drop(1, e, 0.75, {0.5, 0, 0}), k);
    Coordinate z{1.125, 0, -9.81, k}, x{0, 0.5, 0, k};
    Other now = 0;
    std::vector<double> times;
    for (int bounce = 0; bounce < 20; ++bounce) {
        // A rebound w rises until log(1 + k w / g) / k, and is back before 2 w / g, when it would be without drag.
        const Other rise = log(1 + k * z.v / Other(9.81)) / k, latest = bounce == 0 ? Other(1) : 2 * z.v / Other(9.81);
        const Other flight = root([&](const Other& t) { return z.place(t) - Other(0.125); }, rise, latest);
        z.go(flight);
        x.go(flight);
        z.x = 0.125;
        z.v *= -Other(e);
        x.v *= Other(0.75);
        now += flight;
        times.push_back(static_cast<double>(now));
    }
    const Exact run = exactly(scene, std::nextafter(times.back(), 9.0));
    REQUIRE(run.record.impacts.size() == 20);
    for (std::size_t i = 0; i < times.size(); ++i) CHECK(run.record.impacts[i].time == times[i]);
    CHECK(run.record.series.empty());
    // The velocity after the last bounce has the errors of all: amplified some 1/e each.
    CHECK(off(run.flight(0).v.z, z.v) < 1e-45);
    CHECK(off(run.flight(0).v.x, x.v) < 1e-45);
    CHECK(off(run.flight(0).x.x, x.x) < 1e-45);
}

TEST_CASE("Bounces under drag end in rest on the floor, after a time that has a limit", "[reference]")
{
    const double e = 0.5, k = 0.9;
    const Scene scene = damped(drop(1, e), k);
    const Reference ref = make_reference(scene, 3, std::vector<double>{0, 1, 3});
    REQUIRE(ref.reason.empty());
    CHECK(ref.series.empty());
    REQUIRE(ref.contacts.size() == 1);
    Coordinate z{1.125, 0, -9.81, k};
    Other now = 0;
    for (int bounce = 0; bounce < 90; ++bounce) {
        const Other rise = log(1 + k * z.v / Other(9.81)) / k;
        const Other latest = bounce == 0 ? Other(1) : 2 * z.v / Other(9.81);
        const Other flight = root([&](const Other& t) { return z.place(t) - Other(0.125); }, rise, latest);
        now += flight;
        z.v = -Other(e) * z.velocity(flight);
        z.x = 0.125;
    }
    CHECK(ref.contacts[0].begin == Approx(static_cast<double>(now)).epsilon(1e-15).margin(0));
    CHECK(ref.samples[2][0].mode == Mode::resting);
    CHECK(ref.samples[2][0].position == Vec3(0, 0, 0.125));
    CHECK(ref.bound < 1e-15);
}

TEST_CASE("Two fliers in one field meet when s has come to their distance over their speed, or never", "[reference]")
{
    const double k = 0.5;
    Scene scene;
    scene.gravity = {0, 0, -9.81};
    scene.drag = k;
    scene.spheres = {ball("a", {0, 0, 0}, {1, 0, 0}), ball("b", {1.25, 0, 0}, {-1, 0, 0})};
    const Exact run = exactly(scene, 5);
    REQUIRE(!run.record.impacts.empty());
    // The radii are doubles, 0.1 each.
    const Other gap = Other(1.25) - Other(0.1) - Other(0.1);
    CHECK(run.record.impacts[0].time == static_cast<double>(-log(1 - k * gap / 2) / k));
    CHECK(run.record.impacts.size() == 1);
    // Each gets 1/k = 2 far at most.
    scene.spheres[1].position.x() = 4.25;
    CHECK(exactly(scene, 1000).record.impacts.empty());
    scene.spheres[1].position.x() = 4.125;
    CHECK(exactly(scene, 1000).record.impacts.size() == 1);
}

TEST_CASE("A ball bounces on a fixed ball under drag as a root in another library has it", "[reference]")
{
    const double k = 1.3, e = 0.7;
    Scene scene;
    scene.gravity = {0, 0, -9.81};
    scene.drag = k;
    scene.materials[0].restitution = e;
    scene.spheres = {ball("fixed", {0, 0, 0}, {0, 0, 0}, 1, 0.5), ball("ball", {-0.75, 0.125, 2}, {1, 0, 0}, 1, 0.25)};
    scene.spheres[0].fixed = true;
    Coordinate x{-0.75, 1, 0, k}, y{0.125, 0, 0, k}, z{2, 0, -9.81, k};
    const auto gap = [&](const Other& t) {
        const Other a = x.place(t), b = y.place(t), c = z.place(t);
        return Other(a * a + b * b + c * c - Other(0.75) * Other(0.75));
    };
    Other begin = 0, end = 0;
    while (gap(end) > 0) begin = end, end += Other(1) / 64;
    const Other t = root(gap, begin, end);
    for (Coordinate* each : {&x, &y, &z}) each->go(t);
    const Other part = (1 + Other(e)) * (x.v * x.x + y.v * y.x + z.v * z.x) / (x.x * x.x + y.x * y.x + z.x * z.x);
    for (Coordinate* each : {&x, &y, &z}) each->v -= part * each->x;
    const Exact run = exactly(scene, static_cast<double>(t) + 1e-9);
    REQUIRE(run.record.impacts.size() == 1);
    CHECK(run.record.impacts[0].time == static_cast<double>(t));
    const auto v = run.flight(1).v;
    CHECK(off(v.x, x.v) < 1e-46);
    CHECK(off(v.y, y.v) < 1e-46);
    CHECK(off(v.z, z.v) < 1e-46);
}

TEST_CASE("Low bounces on the top of a fixed ball under drag come to rest", "[reference]")
{
    Scene scene;
    scene.gravity = {0, 0, -9.81};
    scene.drag = 0.5;
    scene.materials[0].restitution = 0.5;
    scene.spheres = {ball("fixed", {0, 0, 0}, {0, 0, 0}, 1, 0.5), ball("ball", {0, 0, 0.8}, {0, 0, 0}, 1, 0.25)};
    scene.spheres[0].fixed = true;
    const Reference ref = make_reference(scene, 2, std::vector<double>{0, 2});
    REQUIRE(ref.reason.empty());
    REQUIRE(ref.contacts.size() == 1);
    CHECK(ref.samples[1][1].mode == Mode::resting);
    CHECK(ref.samples[1][1].position.z() == Approx(0.75).epsilon(1e-15).margin(0));
    CHECK(ref.contacts[0].begin > std::sqrt(0.1 / 9.81) * 2.9);
    CHECK(ref.contacts[0].begin < std::sqrt(0.1 / 9.81) * 3);
}

TEST_CASE("A ball slides down an incline under drag as the textbook's throw along it", "[reference]")
{
    Scene scene;
    scene.gravity = {0, 0, -9.75};
    scene.drag = 0.7;
    scene.materials[0].restitution = 0;
    scene.planes = {plane("slope", {0.6, 0, 0.8}, 0)};
    scene.spheres = {ball("ball", {0, 0, 0}, {0, 0.5, 0}, 1, 0.25)};
    scene.spheres[0].position = 0.25 * scene.planes[0].normal;
    Exact run = exactly(scene, 2);
    // Down (0.8, 0, -0.6), by 0.6 g; the stored normal is not quite a unit.
    const Other n = Other(0.6) * Other(0.6) + Other(0.8) * Other(0.8);
    const Other normal = Other(-9.75) * Other(0.8) / n;
    const Coordinate x{Other(scene.spheres[0].position.x()), 0, -normal * Other(0.6), 0.7}, y{0, 0.5, 0, 0.7},
        z{Other(scene.spheres[0].position.z()), 0, Other(-9.75) - normal * Other(0.8), 0.7};
    const auto p = run.flight(0).position(2);
    CHECK(off(p.x, x.place(2)) < 1e-28);  // it is put on the plane to 1e-30 of what it falls
    CHECK(off(p.y, y.place(2)) < 1e-28);
    CHECK(off(p.z, z.place(2)) < 1e-28);
    CHECK(run.mode(0, 2) == Mode::sliding);
}

TEST_CASE("A ball slides off a ball under drag where its equation of motion has no pressure left", "[reference]")
{
    const double radius = 0.75, k = 0.8, first = 0.25;
    Scene scene;
    scene.gravity = {0, 0, -9.81};
    scene.drag = k;
    scene.materials[0].restitution = 0;
    scene.spheres = {ball("fixed", {0, 0, 0}, {0, 0, 0}, 1, 0.5),
                     ball("ball", radius * Vec3(std::sin(first), 0, std::cos(first)), {0, 0, 0}, 1, 0.25)};
    scene.spheres[0].fixed = true;
    // angle'' = g / R sin(angle) - k angle', by Runge and Kutta in long double; it leaves at R angle'^2 = g cos(angle).
    using Angle = std::pair<long double, long double>;
    const auto slope = [&](const Angle& a) {
        return Angle(a.second, 9.81L / radius * std::sin(a.first) - k * a.second);
    };
    const auto stepped = [&](const Angle& a, long double h) {
        const auto ahead = [&](const Angle& s, long double part) {
            return Angle(a.first + part * s.first, a.second + part * s.second);
        };
        const Angle k1 = slope(a), k2 = slope(ahead(k1, h / 2)), k3 = slope(ahead(k2, h / 2)), k4 = slope(ahead(k3, h));
        return Angle(a.first + h / 6 * (k1.first + 2 * k2.first + 2 * k3.first + k4.first),
                     a.second + h / 6 * (k1.second + 2 * k2.second + 2 * k3.second + k4.second));
    };
    const auto pressure = [&](const Angle& a) { return 9.81L * std::cos(a.first) - radius * a.second * a.second; };
    Angle angle(std::atan2(scene.spheres[1].position.x(), scene.spheres[1].position.z()), 0);
    const long double h = 1e-4L;
    long double t = 0;
    while (pressure(stepped(angle, h)) > 0) angle = stepped(angle, h), t += h;
    long double low = 0, high = h;
    for (int i = 0; i < 60; ++i) {
        const long double middle = (low + high) / 2;
        (pressure(stepped(angle, middle)) > 0 ? low : high) = middle;
    }
    angle = stepped(angle, high);
    t += high;
    const auto leaves = static_cast<double>(t);
    const Reference ref = make_reference(scene, leaves + 0.125, std::vector<double>{leaves, leaves + 0.125});
    REQUIRE(ref.reason.empty());
    REQUIRE(ref.contacts.size() == 1);
    CHECK(ref.contacts[0].end == Approx(leaves).epsilon(1e-12).margin(0));
    const auto sine = static_cast<double>(std::sin(angle.first)), cosine = static_cast<double>(std::cos(angle.first));
    CHECK((ref.samples[0][1].position - radius * Vec3(sine, 0, cosine)).norm() < 1e-12);
    // From there on it flies.
    const double speed = radius * static_cast<double>(angle.second);
    const Coordinate x{radius * sine, speed * cosine, 0, k}, z{radius * cosine, -speed * sine, -9.81, k};
    const Vec3 end(static_cast<double>(x.place(0.125)), 0, static_cast<double>(z.place(0.125)));
    CHECK((ref.samples[1][1].position - end).norm() < 1e-11);
}

TEST_CASE("A flier meets a ball that slides off another under drag where sampled paths meet", "[reference]")
{
    Scene scene;
    scene.gravity = {0, 0, -9.81};
    scene.drag = 0.8;
    scene.materials[0].restitution = 0;
    scene.spheres = {ball("fixed", {0, 0, 0}, {0, 0, 0}, 1, 0.5),
                     ball("slides", 0.75 * Vec3(std::sin(0.25), 0, std::cos(0.25)), {0, 0, 0}, 1, 0.25),
                     ball("flies", {2, 0, 2}, {-3, 0, 0}, 1, 0.25)};
    scene.spheres[0].fixed = true;
    const Exact whole = exactly(scene, 1);
    const auto& impacts = whole.record.impacts;
    const auto first = std::find_if(impacts.begin(), impacts.end(), [](const auto& each) { return each.b == 2; });
    REQUIRE(first != impacts.end());
    REQUIRE(first->a == 1);
    const double met = first->time;
    // Until then the two know nothing of each other: both alone, at that time, touch.
    Scene slider = scene, flier = scene;
    slider.spheres.pop_back();
    flier.spheres.erase(flier.spheres.begin() + 1);
    const Exact slides = exactly(slider, met), flies = exactly(flier, met);
    const auto gap = [&](double t) {
        const ExactVector r = slides.flight(1).position(t) - flies.flight(1).position(t);
        return static_cast<double>(sqrt(dot(r, r))) - 0.5;
    };
    CHECK(std::abs(gap(met)) < 1e-15);
    for (int i = 1; i <= 20; ++i) {
        const double before = met * i / 21;
        const ExactVector r = exactly(slider, before).flight(1).position(before) - flies.flight(1).position(before);
        CHECK(static_cast<double>(sqrt(dot(r, r))) > 0.5);
    }
}

TEST_CASE("The energy of the reference falls by the work of drag, the integral of m k v^2", "[reference]")
{
    Scene scene = damped(gas(3, 0.25, {0, 0, -1}), 0.4);
    const int n = 4000;
    std::vector<double> times;
    for (int i = 0; i <= n; ++i) times.push_back(0.5 * i / n);
    scene.planes.clear();
    const Reference ref = make_reference(scene, 0.5, times);
    REQUIRE(ref.reason.empty());
    REQUIRE(ref.impacts.size() > 0);
    const auto kinetic = [&](std::size_t k) {
        double sum = 0;
        for (std::size_t i = 0; i < scene.spheres.size(); ++i)
            sum += scene.spheres[i].mass * ref.samples[k][i].velocity.squaredNorm() / 2;
        return sum;
    };
    const auto energy = [&](std::size_t k) {
        double sum = kinetic(k);
        for (std::size_t i = 0; i < scene.spheres.size(); ++i)
            sum -= scene.spheres[i].mass * scene.gravity.dot(ref.samples[k][i].position);
        return sum;
    };
    // Impacts are elastic: kinetic energy is continuous, and the trapezoidal rule has an error of its kinks alone.
    double work = 0;
    for (std::size_t k = 0; k < static_cast<std::size_t>(n); ++k)
        work += 2 * scene.drag * (kinetic(k) + kinetic(k + 1)) / 2 * (0.5 / n);
    CHECK(energy(0) - energy(n) == Approx(work).epsilon(1e-5));
    CHECK(work > 0.05);
}

TEST_CASE("A tower stands under drag, and bodies that fall together with it keep their distance", "[reference]")
{
    Scene scene;
    scene.gravity = {0, 0, -9.81};
    scene.drag = 2;
    scene.materials[0].restitution = 0.5;
    scene.planes = {plane("floor", {0, 0, 1}, 0)};
    for (int i = 0; i < 3; ++i)
        scene.spheres.push_back(ball("b" + std::to_string(i), {0, 0, 0.125 + 0.25 * i}, {0, 0, 0}, 1, 0.125));
    const Reference stands = make_reference(scene, 2, std::vector<double>{2});
    REQUIRE(stands.reason.empty());
    for (int i = 0; i < 3; ++i) CHECK(stands.samples[0][static_cast<std::size_t>(i)].mode == Mode::resting);
    scene.planes.clear();
    const Reference falls = make_reference(scene, 2, std::vector<double>{2});
    REQUIRE(falls.reason.empty());
    const Coordinate z{0, 0, -9.81, 2};
    for (int i = 0; i < 3; ++i)
        CHECK(falls.samples[0][static_cast<std::size_t>(i)].position.z() ==
              Approx(0.125 + 0.25 * i + static_cast<double>(z.place(2))).epsilon(1e-14));
}
