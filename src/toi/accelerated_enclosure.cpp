#include "toi/accelerated_enclosure.hpp"

#include "toi/quartic_gap.hpp"
#include "toi/scaling.hpp"
#include "toi/tolerances.hpp"

#include <cmath>
#include <limits>
#include <vector>

namespace carom {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The doubles on either side of a point, or the point itself if it is one.
double rounded_down(const Point& p)
{
    return p.rest.sign() < 0 ? std::nextafter(p.value, 0.0) : p.value;
}
double rounded_up(const Point& p)
{
    return p.rest.sign() > 0 ? std::nextafter(p.value, infinity) : p.value;
}

/// A place where H changes sign: from - to + a minimum of F, from + to - a maximum.
struct Turn {
    Isolated where;
    bool is_minimum;
};

/// A place where H' changes sign.
struct Cut {
    Isolated where;
    bool is_minimum;  ///< of H
};

/// Roots of functions of which the pieces between some points are known to be monotone.
class Pieces {
public:
    explicit Pieces(const QuarticGap& gap) : gap_(gap) {}

    /// Where F turns, in order of time.
    std::vector<Turn> turns()
    {
        std::vector<Turn> out;
        const std::vector<Cut> cuts = turns_of_h();
        Isolated left{};  // t = 0
        int sign_left = sign_after_start(gap_.h);
        for (std::size_t i = 0; i <= cuts.size(); ++i) {
            const bool last = i == cuts.size();
            const Isolated right = last ? point(end_of(gap_.h)) : cuts[i].where;
            const int sign_right = last ? gap_.h.sign(right.low) : sign_at_cut(cuts[i]);
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

    /// Beyond the roots, or all but the end of the times that are looked at; not a root.
    static Point end_of(const ExactPolynomial& g)
    {
        Point end{root_bound(g), {}};
        while (g.sign(end) == 0) end.value = std::nextafter(end.value, 0.0);
        return end;
    }

    /// Of a polynomial just after t = 0.
    static int sign_after_start(const ExactPolynomial& g)
    {
        for (const Dyadic& c : g.coefficients())
            if (c.sign() != 0) return c.sign();
        return 0;
    }

private:
    static Isolated point(const Point& t) { return {t, t}; }

    const ExactPolynomial& rate_of(const ExactPolynomial& g) const { return &g == &gap_.f ? gap_.h : gap_.h_rate; }

    /// A maximum of H that is 0 does not lift F out of its fall, a minimum that is 0 does not let it fall.
    int sign_at_cut(const Cut& cut) const
    {
        const int sign = sign_at_root(gap_.h_rate, gap_.h, cut.where);
        return sign != 0 ? sign : cut.is_minimum ? 1 : -1;
    }

    /// The roots of H' before the end at which it changes sign; the second one, or an only one from H' < 0, is a
    /// minimum of H.
    std::vector<Cut> turns_of_h() const
    {
        const auto& c = gap_.h_rate.coefficients();  // c[2] > 0
        const Point start{}, end = end_of(gap_.h_rate);
        const bool rises_at_end = gap_.h_rate.sign(end) > 0;
        if (c[0].sign() < 0) {
            if (!rises_at_end) return {};
            return {{isolate(start, end), true}};
        }
        if (c[1].sign() >= 0) return {};
        if ((c[1] * c[1] - Dyadic(4.0) * c[0] * c[2]).sign() <= 0) return {};
        // Between the two roots H' < 0: at its vertex, or as near it as need be, or at the end.
        Point below = end;
        if (rises_at_end) {
            const ExactPolynomial slope = gap_.h_rate.derivative();
            if (slope.sign(end) <= 0) return {};  // both roots lie beyond
            Isolated vertex{start, end};
            vertex = neighbours(slope, vertex, -c[1].rounded().high / (2 * c[2].rounded().high));
            while (gap_.h_rate.sign(vertex.low) >= 0 && gap_.h_rate.sign(vertex.high) >= 0) halve(slope, vertex);
            below = gap_.h_rate.sign(vertex.low) < 0 ? vertex.low : vertex.high;
        }
        std::vector<Cut> out;
        if (c[0].sign() > 0) out.push_back({isolate(start, below), false});
        if (rises_at_end) out.push_back({isolate(below, end), true});
        return out;
    }
    Isolated isolate(const Point& low, const Point& high) const { return narrow(gap_.h_rate, {low, high}); }

    /// To neighbouring doubles, or closer if the ends lie between doubles.
    static Isolated narrow(const ExactPolynomial& g, const Isolated& where)
    {
        const Point first{rounded_up(where.low), {}}, last{rounded_down(where.high), {}};
        if (first.value > last.value) return where;  // no double lies between them
        const int sign_low = g.sign(where.low), sign_first = g.sign(first), sign_last = g.sign(last);
        if (sign_first == 0) return {first, first};
        if (sign_first != sign_low) return {where.low, first};
        if (sign_last == 0) return {last, last};
        if (sign_last == sign_low) return {last, where.high};
        return neighbours(g, {first, last}, root_guess(g, {first, last}));
    }

    const QuarticGap& gap_;
};

Enclosure<double> answer(const QuarticGap& gap, const Isolated& when, bool is_crossing)
{
    const double low = rounded_down(when.low), high = rounded_up(when.high);
    const bool is_low = !is_crossing || std::abs(gap.f.value(low).high) <= std::abs(gap.f.value(high).high);
    const double t = is_low ? low : high;
    Enclosure<double> out{Decision::impact, std::ldexp(t, gap.time), scaled_down(low, gap.time),
                          scaled_up(high, gap.time), 2};
    if (out.t_hi > std::numeric_limits<double>::max()) return {Decision::none, 0, 0, 0, 2};
    return out;
}

Enclosure<double> enclose(const QuarticGap& gap)
{
    const Point start{};
    const int f_start = gap.f.sign(start), h_start = gap.h.sign(start);
    Enclosure<double> out{Decision::none, 0, 0, 0, 2};
    if (f_start <= 0 && Pieces::sign_after_start(gap.h) < 0) {
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

}  // namespace

Enclosure<double> enclose_accelerated(const ExactMotion& motion)
{
    const int time = natural_time(motion);
    const QuarticGap gap = quartic_gap(motion, time);
    if (root_bound(gap.f) < horizon) {
        const Enclosure<double> out = enclose(gap);
        if (out.decided != Decision::impact || out.t_hi == 0 || std::ldexp(out.t_lo, -time) > too_early) return out;
    }
    // In seconds every double is an answer; signs take longer. Turns beyond the horizon hide no contact before it:
    // where they are so late, falls are so steep that contact and turn are one.
    return enclose(quartic_gap(motion, 0));
}

}  // namespace carom
