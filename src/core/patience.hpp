/// \file
/// Patience with long work. Loops that can take long ask it and leave as soon as it has ended; their results are then
/// incomplete, and their caller must look whether they are.
#pragma once

#include "core/limits.hpp"

#include <carom/progress.hpp>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

namespace carom {

class Patience {
public:
    Patience() = default;  ///< without end
    explicit Patience(OnProgress ask) : ask_(std::move(ask)) {}

    /// Begins a stage of work, of `total` >= 0 `unit`s.
    void begin(const std::string& stage, double total, const std::string& unit = "")
    {
        now_ = {stage, stage, 0, 0, unit};
        total_ = total;
    }
    /// Names what goes on in the stage from here on.
    void name(const std::string& what) { now_.what = what; }

    /// Notes how much of the stage is done, without a question.
    void reach(double done)
    {
        now_.amount = done;
        now_.fraction = total_ > 0 ? std::clamp(done / total_, 0.0, 1.0) : 1;
    }

    /// Asks, some 50 ns: whether to go on. Once the answer was no it stays so.
    bool lasts()
    {
        if (!ended_ && ask_ && !ask_(now_)) ended_ = true;
        return !ended_;
    }
    bool lasts(double done)
    {
        reach(done);
        return lasts();
    }

    /// The same for units of work of less than a microsecond each (a pair test, a try, a value read): asks once a few
    /// hundred of them.
    bool lasts_for(std::size_t units)
    {
        spent_ += units;
        if (spent_ < units_between_questions) return !ended_;
        spent_ = 0;
        return lasts();
    }

    bool ended() const { return ended_; }

private:
    OnProgress ask_;
    Progress now_;
    double total_ = 1;
    std::size_t spent_ = 0;  ///< units since the last question
    bool ended_ = false;
};

}  // namespace carom
