#include "toi/accelerated_enclosure.hpp"

#include "toi/quartic_gap.hpp"
#include "toi/scaling.hpp"

#include <cmath>
#include <limits>
#include <vector>

namespace carom {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A place where H changes sign: from - to + a minimum of F, from + to - a maximum.
struct Turn {
    Isolated where;
    bool is_minimum;
};

/// Roots of functions of which the pieces between some points are known to be monotone.
class Pieces {
public:
    explicit Pieces(const QuarticGap& gap) : gap_(gap) {}

    /// Where F turns, in order of time.
    std::vector<Turn> turns()
    {
        std::vector<Turn> out;
        std::vector<Isolated> cuts = turns_of_h();
        Isolated left{};  // t = 0
        int sign_left = sign_after_start(gap_.h);
        for (std::size_t i = 0; i <= cuts.size(); ++i) {
            const bool last = i == cuts.size();
            const Isolated right = last ? point(root_bound(gap_.h)) : cuts[i];
            const int sign_right = last ? gap_.h.sign(right.low) : sign_at_cut(cuts[i], i + 1 == cuts.size());
            if (sign_left != 0 && sign_right != 0 && sign_left != sign_right)
                out.push_back({root_between(gap_.h, left, sign_left, right, sign_right), sign_left < 0});
            left = right;
            sign_left = sign_right;
        }
        return out;
    }

    /// The root of g, monotone from one place to the other, at which it has these signs.
    Isolated root_between(const ExactPolynomial& g, Isolated left, int sign_left, Isolated right, int sign_right) const
    {
        // The ends of the interval must lie on the inner sides of both places.
        while (!left.is_point() && g.sign(left.high) != sign_left) halve(rate_of(g), left);
        while (!right.is_point() && g.sign(right.low) != sign_right) halve(rate_of(g), right);
        Isolated root{left.high, right.low};
        if (left.is_point() && g.sign(root.low) != sign_left) {  // g is 0 at t = 0 and has its sign only after it
            root.low = between(root.low, root.high);
            while (g.sign(root.low) == sign_right) {
                root.high = root.low;
                root.low = between(left.high, root.high);
            }
            if (g.sign(root.low) == 0) return {root.low, root.low};
        }
        return narrow(g, root);
    }

    /// Of a polynomial just after t = 0.
    static int sign_after_start(const ExactPolynomial& g)
    {
        for (const Dyadic& c : g.coefficients())
            if (c.sign() != 0) return c.sign();
        return 0;
    }

private:
    static Isolated point(double t) { return {{t, {}}, {t, {}}}; }

    const ExactPolynomial& rate_of(const ExactPolynomial& g) const { return &g == &gap_.f ? gap_.h : gap_.h_rate; }

    /// A maximum of H that is 0 does not lift F out of its fall, a minimum that is 0 does not let it fall.
    int sign_at_cut(const Isolated& cut, bool is_minimum) const
    {
        const int sign = sign_at_root(gap_.h_rate, gap_.h, cut);
        return sign != 0 ? sign : is_minimum ? 1 : -1;
    }

    /// The positive roots of H', at which it changes sign; the last one is a minimum of H.
    std::vector<Isolated> turns_of_h() const
    {
        const auto& c = gap_.h_rate.coefficients();  // c[2] > 0
        const ExactPolynomial slope = gap_.h_rate.derivative();
        const double far = root_bound(gap_.h_rate);
        if (gap_.h_rate.sign(point(far).low) <= 0) return {};  // beyond all times
        if (c[0].sign() < 0) return {isolate(point(0).low, point(far).low)};
        if (c[1].sign() >= 0) return {};
        if ((c[1] * c[1] - Dyadic(4.0) * c[0] * c[2]).sign() <= 0) return {};
        // Between the two roots H' < 0: at its vertex, or as near it as need be.
        Isolated vertex{{0, {}}, {far, {}}};
        vertex = neighbours(slope, vertex, -c[1].rounded().high / (2 * c[2].rounded().high));
        while (gap_.h_rate.sign(vertex.low) >= 0 && gap_.h_rate.sign(vertex.high) >= 0) halve(slope, vertex);
        const Point below = gap_.h_rate.sign(vertex.low) < 0 ? vertex.low : vertex.high;
        std::vector<Isolated> out;
        if (c[0].sign() > 0) out.push_back(isolate(point(0).low, below));
        out.push_back(isolate(below, point(far).low));
        return out;
    }
    Isolated isolate(const Point& low, const Point& high) const { return narrow(gap_.h_rate, {low, high}); }

    /// To neighbouring doubles, or closer if the ends lie between doubles.
    static Isolated narrow(const ExactPolynomial& g, Isolated where)
    {
        if (where.low.is_double() && where.high.is_double()) return neighbours(g, where, root_guess(g, where));
        while (std::nextafter(where.low.value, infinity) < where.high.value) halve(g, where);
        return where;
    }

    const QuarticGap& gap_;
};

Enclosure<double> answer(const QuarticGap& gap, const Isolated& when, bool is_crossing)
{
    // The point between two doubles lies between a double and its neighbour.
    const auto down = [](const Point& p) { return p.rest.sign() < 0 ? std::nextafter(p.value, 0.0) : p.value; };
    const auto up = [](const Point& p) { return p.rest.sign() > 0 ? std::nextafter(p.value, infinity) : p.value; };
    const double low = down(when.low), high = up(when.high);
    const bool is_low = !is_crossing || std::abs(gap.f.value(low).high) <= std::abs(gap.f.value(high).high);
    const double t = is_low ? low : high;
    Enclosure<double> out{Decision::impact, std::ldexp(t, gap.time), scaled_down(low, gap.time),
                          scaled_up(high, gap.time), 2};
    if (out.t_hi > std::numeric_limits<double>::max()) return {Decision::none, 0, 0, 0, 2};
    return out;
}

}  // namespace

Enclosure<double> enclose_accelerated(const ExactMotion& motion)
{
    const QuarticGap gap = quartic_gap(motion);
    const Point start{};
    const int f_start = gap.f.sign(start), h_start = gap.h.sign(start);
    Enclosure<double> out{Decision::none, 0, 0, 0, 2};
    const bool falls = Pieces::sign_after_start(gap.h) < 0;
    if (f_start <= 0 && falls) {
        out.decided = h_start < 0 ? Decision::impact : Decision::pressed;
        return out;
    }
    Pieces pieces(gap);
    Isolated left{};  // where the current fall of F began, and the sign of F there
    int f_left = f_start;
    for (const Turn& turn : pieces.turns()) {
        const int f_turn = sign_at_root(gap.h, gap.f, turn.where);
        if (turn.is_minimum) {
            if (f_turn < 0) return answer(gap, pieces.root_between(gap.f, left, f_left, turn.where, f_turn), true);
        } else {
            if (f_turn <= 0) return answer(gap, turn.where, false);  // turns round while still inside
            left = turn.where;
            f_left = f_turn;
        }
    }
    return out;
}

}  // namespace carom
