/// \file
/// The row of a cell while its throws are counted.
#pragma once

#include "study/largest.hpp"
#include "tunnel/judge.hpp"
#include "tunnel/study.hpp"

namespace carom::tunnel {

class Tally {
public:
    Tally(const Contestant& who, const Cell& cell)
    {
        row.method = who.method;
        row.variant = who.variant;
        row.integrator = who.integrator;
        row.cell = cell;
    }

    void add(const Aim& aim, const Judgement& judgement)
    {
        ++row.trials;
        row.tunnelled += judgement.fate == Fate::tunnelled;
        row.wrong += judgement.fate == Fate::wrong;
        if (row.trials == 1 || judgement.fate > shown_) {
            row.example = aim;
            shown_ = judgement.fate;
        }
        if (judgement.fate == Fate::tunnelled) return;
        double worst = row.worst_error.value_or(0);
        study::keep_largest(worst, judgement.error);
        row.worst_error = worst;
    }

    Row row;

private:
    Fate shown_ = Fate::hit;  ///< of the example
};

}  // namespace carom::tunnel
