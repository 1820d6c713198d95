/// \file
/// carom_toi_bench [REPEATS]: what a time of impact costs and how exact it is, beside the textbook formula, FCL and
/// libccd, all in one run. Median of 5 (REPEATS) passes over the same generic pairs, half of them hits; errors against
/// 200 digits on the hits.
#include "support/multiprecision.hpp"
#include "support/random.hpp"
#include "toi/enclosure.hpp"
#include "toi/level_0.hpp"
#include "toi/sphere_sphere.hpp"

#include <carom/time_of_impact.hpp>

#include <ccd/ccd.h>
#include <fcl/fcl.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <limits>
#include <new>
#include <string>
#include <vector>

namespace {

using namespace carom;
using carom::test::Float200;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t count = 4096;  // stays in the cache: arithmetic is timed, not memory

/// Arrays that begin on a cache line, for the widest registers.
template <class T>
struct Aligned {
    using value_type = T;
    Aligned() = default;
    template <class U>
    Aligned(const Aligned<U>&)
    {
    }
    static constexpr std::align_val_t line{64};
    T* allocate(std::size_t n) { return static_cast<T*>(::operator new(n * sizeof(T), line)); }
    void deallocate(T* p, std::size_t) { ::operator delete(p, line); }
    bool operator==(const Aligned&) const { return true; }
};
using Array = std::vector<double, Aligned<double>>;

struct Pairs {
    Array rx, ry, rz, vx, vy, vz, s;
    std::vector<Float200> exact;  ///< < 0: a miss

    RelativeMotions view() const { return {rx, ry, rz, vx, vy, vz, s}; }
    Vec3 r(std::size_t i) const { return {rx[i], ry[i], rz[i]}; }
    Vec3 v(std::size_t i) const { return {vx[i], vy[i], vz[i]}; }
};

/// Approaching, some diameters apart, half of them hits that happen within one unit of time. Nothing grazes.
Pairs generic_pairs()
{
    Pairs p;
    test::Random random(1);
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 n = random.direction(), side = random.across(n);
        const double s = random.uniform(0.2, 2), miss = i % 2 == 0 ? random.uniform(0, 0.95) : random.uniform(1.05, 2);
        const double distance = random.uniform(2, 5);
        const Vec3 r = s * (miss * side - distance * n), v = s * distance * random.uniform(1.01, 1.5) * n;
        for (auto& [array, x] : {std::pair{&p.rx, r.x()},
                                 {&p.ry, r.y()},
                                 {&p.rz, r.z()},
                                 {&p.vx, v.x()},
                                 {&p.vy, v.y()},
                                 {&p.vz, v.z()},
                                 {&p.s, s}})
            array->push_back(x);
        const auto rr = test::lift<Float200>(r), vv = test::lift<Float200>(v);
        const Float200 a = test::dot(vv, vv), b = test::dot(rr, vv),
                       d = b * b - a * (test::dot(rr, rr) - Float200(s) * s);
        p.exact.push_back(d > 0 && b < 0 ? Float200((-b - sqrt(d)) / a) : Float200(-1));
    }
    return p;
}

/// (-b - sqrt(b^2 - 4 a c)) / (2 a), in a loop that vectorises.
void textbook_batch(std::size_t n, const double* __restrict rx, const double* __restrict ry,
                    const double* __restrict rz, const double* __restrict vx, const double* __restrict vy,
                    const double* __restrict vz, const double* __restrict s, double* __restrict out)
{
    for (std::size_t i = 0; i < n; ++i) {
        const double a = vx[i] * vx[i] + vy[i] * vy[i] + vz[i] * vz[i],
                     b = 2 * (rx[i] * vx[i] + ry[i] * vy[i] + rz[i] * vz[i]),
                     c = rx[i] * rx[i] + ry[i] * ry[i] + rz[i] * rz[i] - s[i] * s[i], d = b * b - 4 * a * c;
        const double t = (-b - std::sqrt(d > 0 ? d : 0)) / (2 * a);
        out[i] = (d >= 0) & (t >= 0) ? t : infinity;
    }
}

/// The same with D = A S^2 - |r x v|^2 and C / (sqrt(D) - B): no bounds.
void cross_batch(std::size_t n, const double* __restrict rx, const double* __restrict ry, const double* __restrict rz,
                 const double* __restrict vx, const double* __restrict vy, const double* __restrict vz,
                 const double* __restrict s, double* __restrict out)
{
    for (std::size_t i = 0; i < n; ++i) {
        const double a = vx[i] * vx[i] + vy[i] * vy[i] + vz[i] * vz[i],
                     b = rx[i] * vx[i] + ry[i] * vy[i] + rz[i] * vz[i],
                     c = rx[i] * rx[i] + ry[i] * ry[i] + rz[i] * rz[i] - s[i] * s[i];
        const double x = ry[i] * vz[i] - rz[i] * vy[i], y = rz[i] * vx[i] - rx[i] * vz[i],
                     z = rx[i] * vy[i] - ry[i] * vx[i], d = a * (s[i] * s[i]) - (x * x + y * y + z * z);
        const double t = c / (std::sqrt(d > 0 ? d : 0) - b);
        out[i] = (b < 0) & (d > 0) ? (c > 0 ? t : 0) : infinity;
    }
}

double textbook(const Vec3& r, const Vec3& v, double s)
{
    const double a = v.squaredNorm(), b = 2 * r.dot(v), c = r.squaredNorm() - s * s, d = b * b - 4 * a * c;
    if (!(d >= 0)) return infinity;
    const double t = (-b - std::sqrt(d)) / (2 * a);
    return t >= 0 ? t : infinity;
}

/// Conservative advancement over one unit of time, as FCL ships it.
class Fcl {
public:
    explicit Fcl(double s) : a_(std::make_shared<fcl::Sphered>(s / 2)), b_(a_) {}
    double operator()(const Vec3& r, const Vec3& v) const
    {
        const auto at = [](const Vec3& p) {
            fcl::Transform3d t = fcl::Transform3d::Identity();
            t.translation() = p;
            return t;
        };
        fcl::ContinuousCollisionRequestd request;
        request.ccd_solver_type = fcl::CCDC_CONSERVATIVE_ADVANCEMENT;
        request.ccd_motion_type = fcl::CCDM_TRANS;
        fcl::ContinuousCollisionResultd result;
        fcl::continuousCollide(a_.get(), at(r), at(r + v), b_.get(), at({0, 0, 0}), at({0, 0, 0}), request, result);
        return result.is_collide ? result.time_of_contact : infinity;
    }

private:
    std::shared_ptr<fcl::Sphered> a_, b_;
};

struct CcdSphere {
    Vec3 centre;
    double radius;
};
void ccd_support(const void* body, const ccd_vec3_t* direction, ccd_vec3_t* out)
{
    const auto& sphere = *static_cast<const CcdSphere*>(body);
    const Vec3 d(direction->v[0], direction->v[1], direction->v[2]), p = sphere.centre + sphere.radius * d.normalized();
    ccdVec3Set(out, p.x(), p.y(), p.z());
}
void ccd_centre(const void* body, ccd_vec3_t* out)
{
    const Vec3& c = static_cast<const CcdSphere*>(body)->centre;
    ccdVec3Set(out, c.x(), c.y(), c.z());
}

/// libccd knows no motion: its MPR test, asked by bisection up to the closest approach.
double libccd(const Vec3& r, const Vec3& v, double s)
{
    ccd_t ccd;
    CCD_INIT(&ccd);
    ccd.support1 = ccd.support2 = ccd_support;
    ccd.center1 = ccd.center2 = ccd_centre;
    const CcdSphere b{Vec3::Zero(), s / 2};
    const auto overlaps = [&](double t) {
        const CcdSphere a{r + t * v, s / 2};
        return ccdMPRIntersect(&a, &b, &ccd) != 0;
    };
    double low = 0, high = -r.dot(v) / v.squaredNorm();
    if (!overlaps(high)) return infinity;
    constexpr int halvings = 40;
    for (int i = 0; i < halvings; ++i) {
        const double middle = low + (high - low) / 2;
        (overlaps(middle) ? high : low) = middle;
    }
    return high;
}

struct Row {
    std::string name;
    std::size_t queries;
    std::function<void()> run;
    Array* times;  ///< what it found, infinity for a miss
};

/// Seconds that this thread computed: others on the machine do not count, as far as that goes.
double cpu_seconds()
{
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// [ns/query]; long enough for the clock.
double time_once(const Row& row)
{
    int rounds = 0;
    const double start = cpu_seconds();
    double seconds = 0;
    do {
        row.run();
        ++rounds;
        seconds = cpu_seconds() - start;
    } while (seconds < 0.01);
    return 1e9 * seconds / rounds / static_cast<double>(row.queries);
}

double median(std::vector<double> x)
{
    std::nth_element(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(x.size() / 2), x.end());
    return x[x.size() / 2];
}

}  // namespace

int main(int argc, char** argv)
{
    const int repeats = argc > 1 ? std::clamp(std::atoi(argv[1]), 1, 1000) : 5;
    const Pairs p = generic_pairs();
    Array t(count), lo(count), hi(count);
    std::vector<ImpactStatus> status(count);
    const ImpactTimes out{status, t, lo, hi};
    const auto each = [&](std::size_t n, auto&& solve) {
        return [&t, &p, n, solve] {
            for (std::size_t i = 0; i < n; ++i) t[i] = solve(p.r(i), p.v(i), p.s[i]);
        };
    };
    const auto batch = [&](auto&& solve) {
        return [&, solve] {
            solve(count, p.rx.data(), p.ry.data(), p.rz.data(), p.vx.data(), p.vy.data(), p.vz.data(), p.s.data(),
                  t.data());
        };
    };
    constexpr std::size_t few = 256;
    const std::vector<Row> rows{
        {"batch: textbook", count, batch(textbook_batch), &t},
        {"batch: cross form", count, batch(cross_batch), &t},
        {"batch: certified t_lo", count, [&] { lower_bound_batch(p.view(), out); }, &lo},
        {"batch: enclosure", count, [&] { time_of_impact_batch(p.view(), out); }, &t},
        {"scalar: textbook", count, each(count, textbook), &t},
        {"scalar: engine (sphere_sphere_root)", count,
         each(count,
              [](const Vec3& r, const Vec3& v, double s) {
                  const Root root = sphere_sphere_root(r, v, s);
                  return root.kind == RootKind::impact ? root.t : infinity;
              }),
         &t},
        {"scalar: enclosure", count,
         [&] {
             for (std::size_t i = 0; i < count; ++i) {
                 const ImpactTime time = quick_time_of_impact(p.r(i), p.v(i), p.s[i]);
                 t[i] = time.status == ImpactStatus::none ? infinity : time.t;
                 lo[i] = time.t_lo;
                 hi[i] = time.t_hi;
             }
         },
         &t},
        {"scalar: double-double enclosure", count,
         each(count,
              [](const Vec3& r, const Vec3& v, double s) {
                  const auto sharp =
                      enclose(DoubleDouble3{r.x(), r.y(), r.z()}, DoubleDouble3{v.x(), v.y(), v.z()}, DoubleDouble(s));
                  return sharp.decided == Decision::impact ? sharp.t.high : infinity;
              }),
         &t},
        {"scalar: time_of_impact (1 ulp, normal)", count,
         each(count,
              [](const Vec3& r, const Vec3& v, double s) {
                  MovingSphere a, b;
                  a.position = r;
                  a.velocity = v;
                  a.radius = s;
                  const TimeOfImpact hit = time_of_impact(a, b);
                  return hit ? hit.t : infinity;
              }),
         &t},
        {"FCL: conservative advancement", few,
         each(few, [](const Vec3& r, const Vec3& v, double s) { return Fcl(s)(r, v); }), &t},
        {"libccd: MPR and 40 bisections", few, each(few, libccd), &t},
    };
    std::printf("%-40s %10s %8s %12s %12s %8s\n", "4096 generic pairs, half of them hits", "ns/query", "ratio",
                "median ulp", "max ulp", "wrong");
    // Pass by pass over all rows, so that a busy moment hits them alike.
    std::vector<std::vector<double>> ns(rows.size()), ratio(rows.size());
    for (int pass = 0; pass < repeats; ++pass) {
        double base = 0;
        for (std::size_t k = 0; k < rows.size(); ++k) {
            ns[k].push_back(time_once(rows[k]));
            if (rows[k].name.find("textbook") != std::string::npos) base = ns[k].back();
            ratio[k].push_back(ns[k].back() / base);
        }
    }
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const Row& row = rows[k];
        row.run();
        std::vector<double> errors;
        int wrong = 0;
        for (std::size_t i = 0; i < row.queries; ++i) {
            const bool is_batch = row.name.find("certified") != std::string::npos || row.name == "batch: enclosure";
            const double found = is_batch && status[i] == ImpactStatus::none ? infinity : (*row.times)[i];
            const bool hit = std::isfinite(found);
            wrong += hit != (p.exact[i] >= 0);
            if (hit && p.exact[i] >= 0) errors.push_back(test::ulps(found, p.exact[i]));
        }
        std::sort(errors.begin(), errors.end());
        std::printf("%-40s %10.2f %8.2f %12.3g %12.3g %8d\n", row.name.c_str(), median(ns[k]), median(ratio[k]),
                    errors.empty() ? 0 : errors[errors.size() / 2], errors.empty() ? 0 : errors.back(), wrong);
    }
    return 0;
}
