/// \file
/// The steps of which operators are made, in double-double, and many of them at once where they repeat. A light body
/// between two of M times its mass takes some 3 M^(1/2) of them, and its speed is the difference of two impulses that
/// are M times as large.
#pragma once

#include "math/double_double.hpp"
#include "projection/half_space.hpp"

#include <cstdint>
#include <span>

namespace carom {

/// Impulses of the contacts V of a step: -gain (G_VV)^-1 c_V, G the products of normals in the metric, c the rates.
/// Gain 1 closes them, 2 reflects them, 1 + e is the pair law of one alone.
struct Step {
    std::vector<int> contacts;  ///< V: they close, and each of them gets an impulse
    std::vector<int> open;      ///< did not close when the step was chosen; had they, it would have been another one
    double gain = 1;
    std::vector<int> idle{};  ///< close, and would not any more at gain 1: they get no impulse
    bool always = false;      ///< whether V need not close: contacts that stay closed, after each step
};

/// Whether masses differ so much (`stiff_mass_ratio`) that the rounding of impulses shows in speeds.
bool is_stiff(const ProjectionProblem& problem);

/// Whether steps that repeat are taken at once.
enum class Pace : std::uint8_t { one_by_one, at_once };

/// Rates and impulses of the contacts of a problem, from the start on.
class ExactSteps {
public:
    /// \param closing rate > 0 below whose negative contacts close [as the vectors]
    ExactSteps(const ProjectionProblem& problem, double closing, Pace pace = Pace::at_once);

    std::size_t contacts() const { return rates_.size(); }
    bool closes(int contact) const { return rate(contact) < -closing_; }
    double rate(int contact) const { return static_cast<double>(rates_[static_cast<std::size_t>(contact)]); }

    /// Whether a step is a projection, `gain` times as far: each impulse pushes (of contacts that depend on each other
    /// some may not) and what is idle does not close at gain 1.
    bool is_projection(const Step& step) const;
    /// Takes a step that is no part of a period.
    void take_once(const Step& step);
    /// Gives a contact an impulse that is no part of a period.
    void push(int contact, double impulse);
    /// Takes a step. Where the last ones repeat, as many of their periods follow as surely are the same.
    /// \returns whether it ever ends: not where periods repeat for ever and leave what they found
    bool take_and_repeat(const Step& step);

    std::vector<Vec3> vectors() const;
    std::vector<double> impulses() const;

private:
    using Numbers = std::vector<DoubleDouble>;
    struct Coupling {
        int contact;
        DoubleDouble product;
    };
    struct Period;
    struct Repeats {
        std::int64_t periods = 0;
        int jumps = 0;
    };

    void take(const Step& step);
    DoubleDouble product(int i, int j) const;
    Numbers products(const std::vector<int>& contacts) const;
    void spread(int contact, DoubleDouble impulse, Numbers& rates) const;
    Numbers impulses_of(const Step& step, const Numbers& rates) const;
    std::span<const Step> last_period() const;
    Numbers margins(const Period& period, Numbers& rates) const;
    std::vector<Numbers> margin_differences(const Period& period) const;
    std::vector<double> difference_bounds(const Period& period, const Numbers& before) const;
    Numbers after(const Period& period, const Numbers& impulses) const;
    Repeats repeat(std::span<const Step> steps);

    const ProjectionProblem& problem_;
    double closing_;
    Pace pace_;
    std::vector<std::vector<Coupling>> couplings_;  ///< by contact: with itself and those that share a body
    Numbers rates_, impulses_;
    std::vector<Step> history_;  ///< the last steps
    std::int64_t wait_ = 0;      ///< steps until a period is tried again
    std::int64_t next_wait_ = 1;
};

}  // namespace carom
