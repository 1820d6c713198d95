// Balls dropped into one box, window after window: carom_heap_bench COUNT RESTITUTION SECONDS SEED [LAYERS].
#include "heap_box.hpp"
#include "math/disjoint_sets.hpp"
#include "support/window_gap.hpp"
#include "window/contact_geometry.hpp"
#include "window/landing.hpp"
#include "window/window.hpp"

#include <array>
#include <bit>
#include <cstdio>
#include <cstdlib>
#include <ctime>

using namespace carom;
using namespace carom::bench;

namespace {

double cpu()
{
    std::timespec t{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

std::size_t at(int i)
{
    return static_cast<std::size_t>(i);
}

struct Pair {
    int a = 0;
    Partner b;
    double impulse = 0;
};

struct Counts {
    long windows = 0, shortened = 0, infeasible = 0, exact = 0, relaxations = 0, contacts = 0, factors = 0, lists = 0;
    long landings = 0, landed = 0, wakes = 0;
    double window_energy = 0, rebound_energy = 0, landing_energy = 0, rises = 0, largest_rise = 0;
    double cpu_exact = 0, cpu_landing = 0, cpu_window = 0, cpu_lists = 0;
    double least_gap = 1;
};

class Heap {
public:
    Heap(int count, double restitution, std::uint64_t seed, double layers)
        : box_(drop(count, seed, layers)),
          balls_(box_.balls),
          restitution_(restitution),
          asleep_(balls_.size(), 0),
          force_(balls_.size(), 0)
    {
        for (const WindowBody& ball : balls_)
            smallest_ = std::min(smallest_, ball.radius), largest_ = std::max(largest_, ball.radius);
        hot_ = std::sqrt(smallest_ / gravity) / 32;
        start_energy_ = energy();
        energy_ = start_energy_;
        list(0.35 * smallest_);
    }

    void run(double until, bool checks, bool verbose)
    {
        double begun = cpu(), next_word = 0;
        while (time_ < until && awake() > 0) {
            const bool calm = is_calm();
            step(calm, checks);
            if (calm && (windows_to_wait_ <= 0 || fastest_ < failed_speed_ / 4)) try_to_land();
            --windows_to_wait_;
            if (verbose && time_ >= next_word) {
                next_word = time_ + until / 15;
                std::printf(
                    "t %.3f cpu %.2f awake %d fastest %.2e rms %.2e windows %ld exact %ld short %ld relax/contact %.1f "
                    "rises %.1e gap %.1e landings %ld/%ld\n",
                    time_, cpu() - begun - checking_, awake(), fastest_, rms_, c.windows, c.exact, c.shortened,
                    double(c.relaxations) / double(c.contacts), c.rises, c.least_gap, c.landed, c.landings);
                std::fflush(stdout);
            }
        }
        cpu_ = cpu() - begun - checking_;
    }

    void tell() const
    {
        double height = 0, mass = 0;
        int resting = 0, sliding = 0;
        for (std::size_t i = 0; i < balls_.size(); ++i) {
            height += balls_[i].place.z() / balls_[i].inverse_mass, mass += 1 / balls_[i].inverse_mass;
            resting += asleep_[i];
            sliding += !asleep_[i] && balls_[i].place.z() - balls_[i].radius < 2e-3 * smallest_ &&
                       std::abs(balls_[i].velocity.z()) < 1e-3;
        }
        std::printf(
            "N %zu e %.2f: cpu %.2f s, t %.3f s, %s, resting %d + gliding %d, lowest gap %.1e r, rises %.1e (largest "
            "%.1e) E0, taken: window %.4f restitution %.4f landing %.1e E0 (sum %.1e off), height %.6f m\n"
            "   windows %ld (shortened %ld, infeasible %ld, exact %ld), relaxations a contact and window %.1f, "
            "contacts a ball %.2f, factors %ld, lists %ld; landings %ld of %ld, wakes %ld; cpu: windows %.2f, of it "
            "exact %.2f, landings %.2f, lists %.2f; residual %.1e g, least force %.1e mg, fingerprint %016llx\n",
            balls_.size(), restitution_, cpu_, time_, awake() ? "not all rest" : "all rest", resting, sliding,
            c.least_gap, c.rises, c.largest_rise, c.window_energy / start_energy_, c.rebound_energy / start_energy_,
            c.landing_energy / start_energy_,
            (start_energy_ - energy() - c.window_energy - c.rebound_energy - c.landing_energy) / start_energy_,
            height / mass, c.windows, c.shortened, c.infeasible, c.exact, double(c.relaxations) / double(c.contacts),
            double(c.contacts) / double(c.windows) / double(balls_.size()), c.factors, c.lists, c.landed, c.landings,
            c.wakes, c.cpu_window, c.cpu_exact, c.cpu_landing, c.cpu_lists, residual_, least_force_,
            static_cast<unsigned long long>(fingerprint()));
    }

private:
    double energy() const
    {
        double out = 0;
        for (const WindowBody& ball : balls_)
            out += (ball.velocity.squaredNorm() / 2 + gravity * ball.place.z()) / ball.inverse_mass;
        return out;
    }
    /// Of the bits of all places, FNV-1a: the same for every compiler.
    std::uint64_t fingerprint() const
    {
        std::uint64_t out = 0xcbf29ce484222325;
        for (const WindowBody& ball : balls_)
            for (int k = 0; k < 3; ++k) out = (out ^ std::bit_cast<std::uint64_t>(ball.place[k])) * 0x100000001b3;
        return out;
    }
    int awake() const { return static_cast<int>(std::count(asleep_.begin(), asleep_.end(), 0)); }

    /// Pairs nearer than the skin.
    void list(double skin)
    {
        const double begun = cpu();
        ++c.lists;
        skin_ = skin;
        const std::vector<Pair> old = std::move(pairs_);
        pairs_.clear();
        const Buckets buckets(balls_, box_.side, 2 * largest_ + skin);
        std::vector<int> near;
        std::size_t o = 0;
        for (std::size_t i = 0; i < balls_.size(); ++i) {
            near.clear();
            buckets.near(balls_[i].place, [&](int j) {
                if (j > static_cast<int>(i) && geometry(balls_[i], balls_[at(j)]).gap < skin) near.push_back(j);
            });
            std::sort(near.begin(), near.end());
            const std::size_t first = pairs_.size();
            for (const int j : near) pairs_.push_back({static_cast<int>(i), Partner::sphere(j)});
            for (std::size_t p = 0; p < box_.planes.size(); ++p)
                if (geometry(box_.planes[p], balls_[i]).gap < skin)
                    pairs_.push_back({static_cast<int>(i), Partner::plane(static_cast<int>(p))});
            while (o < old.size() && old[o].a < static_cast<int>(i)) ++o;
            for (std::size_t k = first; k < pairs_.size(); ++k)
                for (std::size_t q = o; q < old.size() && old[q].a == static_cast<int>(i); ++q)
                    if (old[q].b == pairs_[k].b) pairs_[k].impulse = old[q].impulse;
        }
        listed_at_.clear();
        for (const WindowBody& ball : balls_) listed_at_.push_back(ball.place);
        c.cpu_lists += cpu() - begun;
    }

    /// The list is good for windows in which no ball goes farther than half of the skin from where it was listed.
    void relist(double length)
    {
        double fastest = 0, farthest = 0;
        for (std::size_t i = 0; i < balls_.size(); ++i) {
            if (asleep_[i]) continue;
            fastest = std::max(fastest, balls_[i].velocity.norm());
            farthest = std::max(farthest, (balls_[i].place - listed_at_[i]).norm());
        }
        const double way = length * (fastest + gravity * length);
        if (farthest + way > skin_ / 2) list(std::max(0.35 * smallest_, 6 * way));
    }

    /// Balls that other balls hold, or nearly; those that lean on planes alone may glide for ever.
    bool is_calm()
    {
        std::vector<char> held(balls_.size(), 1);
        for (const Pair& p : pairs_)
            if (p.b.is_plane() && p.impulse > 0) held[at(p.a)] = 0;
        for (const Pair& p : pairs_)
            if (p.b.is_sphere() && p.impulse > 0) held[at(p.a)] = held[at(p.b.index)] = 1;
        double square = 0, mass = 0;
        fastest_ = 0;
        for (std::size_t i = 0; i < balls_.size(); ++i) {
            if (asleep_[i] || !held[i]) continue;
            const double v2 = balls_[i].velocity.squaredNorm();
            square += v2 / balls_[i].inverse_mass;
            mass += 1 / balls_[i].inverse_mass;
            fastest_ = std::max(fastest_, std::sqrt(v2));
        }
        rms_ = mass > 0 ? std::sqrt(square / mass) : 0;
        return mass > 0 && time_ > 10 * hot_ && rms_ < calm_speed / 4 && fastest_ < 4 * calm_speed;
    }

    WindowProblem problem_of(std::vector<int>& ball_of, std::vector<int>& pair_of) const
    {
        WindowProblem out;
        out.planes = box_.planes;
        std::vector<int> number(balls_.size(), -1);
        const auto enter = [&](int ball) {
            if (number[at(ball)] >= 0) return number[at(ball)];
            number[at(ball)] = static_cast<int>(out.bodies.size());
            ball_of.push_back(ball);
            out.bodies.push_back(balls_[at(ball)]);
            if (asleep_[at(ball)]) out.bodies.back().inverse_mass = 0, out.bodies.back().velocity = Vec3::Zero();
            return number[at(ball)];
        };
        for (std::size_t i = 0; i < balls_.size(); ++i)
            if (!asleep_[i]) enter(static_cast<int>(i));
        for (std::size_t k = 0; k < pairs_.size(); ++k) {
            const Pair& p = pairs_[k];
            if (asleep_[at(p.a)] && (p.b.is_plane() || asleep_[at(p.b.index)])) continue;
            const int a = enter(p.a);
            out.contacts.push_back(
                {a, p.b.is_plane() ? p.b : Partner::sphere(enter(p.b.index)), restitution_, p.impulse});
            pair_of.push_back(static_cast<int>(k));
        }
        return out;
    }

    void wake_all()
    {
        ++c.wakes;
        std::fill(asleep_.begin(), asleep_.end(), char{0});
        landing_delay_ = std::min(2 * landing_delay_, 256L);
        windows_to_wait_ = landing_delay_;
        for (Pair& p : pairs_) p.impulse = std::max(p.impulse, 0.0);
    }

    void step(bool calm, bool checks)
    {
        WindowOptions options;
        options.length = hot_;
        options.closing_speed = gravity * hot_;
        options.speed_tolerance = 0.1 * gravity * hot_;
        options.margin = 1e-3 * smallest_ * std::clamp(last_fastest_ / 0.05, 0.3, 1.0);
        if (calm) {
            options.solver = WindowSolver::exact;
            options.length = std::clamp(0.3 * smallest_ / std::max(fastest_, 1e-12), 4 * hot_, 128 * hot_);
        }
        for (;;) {
            relist(options.length);
            std::vector<int> ball_of, pair_of;
            WindowProblem problem = problem_of(ball_of, pair_of);
            for (WindowContact& each : problem.contacts) each.impulse *= options.length / last_length_;
            const double begun = cpu();
            const WindowOutcome out = take_window(problem, options);
            const double spent = cpu() - begun;
            c.cpu_window += spent;
            if (options.solver == WindowSolver::exact) c.cpu_exact += spent, ++c.exact;
            c.factors += out.interior_steps;
            if (out.status == WindowStatus::infeasible) {
                ++c.infeasible;
                options.length /= 4;
                if (options.length < 1e-6 * hot_) {
                    std::printf("stuck at %.6f\n", time_);
                    std::exit(1);
                }
                continue;
            }
            if (wakes(problem, out, ball_of)) {
                wake_all();
                continue;
            }
            commit(problem, out, ball_of, pair_of, options.length, checks);
            return;
        }
    }

    /// Whether a ball at rest is pushed.
    bool wakes(const WindowProblem& problem, const WindowOutcome& out, const std::vector<int>& ball_of) const
    {
        for (std::size_t k = 0; k < problem.contacts.size(); ++k) {
            const WindowContact& each = problem.contacts[k];
            if (!(out.impulses[k] > 0) || !each.b.is_sphere()) continue;
            if (asleep_[at(ball_of[at(each.a)])] || asleep_[at(ball_of[at(each.b.index)])]) return true;
        }
        return false;
    }

    void commit(const WindowProblem& problem, const WindowOutcome& out, const std::vector<int>& ball_of,
                const std::vector<int>& pair_of, double length, bool checks)
    {
        if (checks) check(problem, out, ball_of);
        ++c.windows;
        c.shortened += out.status == WindowStatus::shortened;
        c.relaxations += out.relaxations;
        c.contacts += static_cast<long>(problem.contacts.size());
        c.window_energy += out.taken_by_window;
        c.rebound_energy += out.taken_by_restitution;
        last_fastest_ = 0;
        for (std::size_t i = 0; i < ball_of.size(); ++i) {
            if (asleep_[at(ball_of[i])]) continue;
            WindowBody& ball = balls_[at(ball_of[i])];
            const WindowMotion& m = out.motions[i];
            ball.place += out.length * (m.velocity + (out.length / 2) * m.acceleration);
            ball.velocity = m.end_velocity;
            last_fastest_ = std::max(last_fastest_, m.velocity.norm());
        }
        for (Pair& p : pairs_)
            if (!asleep_[at(p.a)] || (p.b.is_sphere() && !asleep_[at(p.b.index)])) p.impulse = 0;
        for (std::size_t k = 0; k < pair_of.size(); ++k) pairs_[at(pair_of[k])].impulse = out.guess[k];
        last_length_ = out.length > 0 ? length : last_length_;
        time_ += out.length;
        const double now = energy(), rise = (now - energy_) / start_energy_;
        if (rise > 0) c.rises += rise, c.largest_rise = std::max(c.largest_rise, rise);
        energy_ = now;
    }

    /// The lowest gap of all pairs at any time of the window, found without lists.
    void check(const WindowProblem& problem, const WindowOutcome& out, const std::vector<int>& ball_of)
    {
        const double begun = cpu();
        std::vector<WindowMotion> motions(balls_.size());
        double way = 0;
        for (std::size_t i = 0; i < ball_of.size(); ++i) {
            if (asleep_[at(ball_of[i])]) continue;
            motions[at(ball_of[i])] = out.motions[i];
            way = std::max(way, out.length * (out.motions[i].velocity.norm() + gravity * out.length));
        }
        (void)problem;
        const Buckets buckets(balls_, box_.side, 2 * largest_ + 2 * way);
        for (std::size_t i = 0; i < balls_.size(); ++i) {
            if (asleep_[i]) continue;
            buckets.near(balls_[i].place, [&](int j) {
                if (j == static_cast<int>(i) || (!asleep_[at(j)] && j < static_cast<int>(i))) return;
                if (geometry(balls_[i], balls_[at(j)]).gap > 2 * way) return;
                c.least_gap = std::min(
                    c.least_gap,
                    test::least_gap(balls_[i], motions[i], balls_[at(j)], motions[at(j)], out.length) / smallest_);
            });
            for (const WindowPlane& plane : box_.planes)
                c.least_gap =
                    std::min(c.least_gap, test::least_gap(balls_[i], motions[i], plane, out.length) / smallest_);
        }
        checking_ += cpu() - begun;
    }

    void try_to_land()
    {
        const double begun = cpu();
        ++c.landings;
        LandingOptions options;
        options.speed = calm_speed;
        options.way = 0.3 * smallest_;
        for (std::size_t i = 0; i < balls_.size(); ++i)
            if (!asleep_[i] && balls_[i].velocity.norm() <= calm_speed)
                options.most_energy += balls_[i].velocity.squaredNorm() / (2 * balls_[i].inverse_mass);
        list(0.5 * smallest_);
        std::vector<int> ball_of, pair_of;
        const WindowProblem problem = problem_of(ball_of, pair_of);
        const LandingOutcome out = land(problem, options);
        c.factors += out.factorisations;
        c.cpu_landing += cpu() - begun;
        if (out.status != LandingStatus::rests) {
            failed_speed_ = fastest_;
            windows_to_wait_ = balls_.size() <= 100 ? 1 : 4;
            return;
        }
        ++c.landed;
        double kinetic = 0;
        for (std::size_t i = 0; i < ball_of.size(); ++i) {
            if (!out.rests[i]) continue;
            WindowBody& ball = balls_[at(ball_of[i])];
            for (const std::vector<Vec3>& move : out.moves) ball.place += move[i];
            kinetic += ball.velocity.squaredNorm() / (2 * ball.inverse_mass);
            ball.velocity = Vec3::Zero();
            asleep_[at(ball_of[i])] = 1;
        }
        c.landing_energy += kinetic - out.lifted;
        residual_ = out.residual / gravity;
        least_force_ = 1e9;
        for (std::size_t k = 0; k < pair_of.size(); ++k)
            if (out.forces[k] > 0) {
                least_force_ = std::min(
                    least_force_, out.forces[k] * problem.bodies[at(problem.contacts[k].a)].inverse_mass / gravity);
                pairs_[at(pair_of[k])].impulse = out.forces[k] * hot_;
            }
        const double now = energy(), rise = (now - energy_) / start_energy_;
        if (rise > 0) c.rises += rise, c.largest_rise = std::max(c.largest_rise, rise);
        energy_ = now;
        last_length_ = hot_;
    }

    static constexpr double calm_speed = 0.08;  ///< [m/s] a fall of a third of a millimetre
    Box box_;
    std::vector<WindowBody> balls_;
    double restitution_, smallest_ = 1, largest_ = 0, hot_ = 0, skin_ = 0, time_ = 0, cpu_ = 0, checking_ = 0;
    double start_energy_ = 0, energy_ = 0, fastest_ = 0, rms_ = 0, last_fastest_ = 1, last_length_ = 1, residual_ = 0,
           least_force_ = 0;
    double failed_speed_ = 0;
    long windows_to_wait_ = 0, landing_delay_ = 1;
    std::vector<char> asleep_;
    std::vector<int> force_;
    std::vector<Vec3> listed_at_;
    std::vector<Pair> pairs_;
    Counts c;
};

}  // namespace

int main(int argc, char** argv)
{
    if (argc < 5) {
        std::fprintf(stderr,
                     "usage: carom_heap_bench COUNT RESTITUTION SECONDS SEED [LAYERS] [check|free] [verbose]\n");
        return 2;
    }
    Heap heap(std::atoi(argv[1]), std::atof(argv[2]), static_cast<std::uint64_t>(std::atoll(argv[4])),
              argc > 5 ? std::atof(argv[5]) : 3.5);
    heap.run(std::atof(argv[3]), argc <= 6 || argv[6][0] == 'c', argc > 7);
    heap.tell();
}
