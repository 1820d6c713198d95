/// \file
/// A case as data: what it is, what is measured, which rule holds, and why methods fail it.
#pragma once

#include "core/patience.hpp"
#include "study/stress/stress.hpp"

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace carom::stress {

/// What a run showed.
struct Evidence {
    double figure = 0;
    std::string worst;          ///< where the figure comes from
    std::string stopped;        ///< why a run did not end well, else empty
    bool same_run = true;       ///< false: another event hash than the same scene has elsewhere
    std::int64_t expected = 0;  ///< impacts, summed over the runs of the case; 0: unknown
    std::int64_t missed = 0, invented = 0;
    double penetration = 0;  ///< deepest, in radii of the smallest sphere
    double energy = 0;       ///< largest change relative to the kinetic energy, of runs that keep it
};

struct Case {
    std::string name, title, about, figure;
    double limit = 0;                    ///< of the figure, inclusive
    double exact_limit = 0;              ///< for `event`, which claims to be exact
    std::string step;                    ///< of discrete methods: how it was chosen
    std::map<Symptom, std::string> why;  ///< causes; `explain` adds the numbers
    /// Without patience: of no use, whatever it is.
    std::function<Evidence(std::string_view method, Patience& patience)> measure;
};

// One function a group of cases, one file each.
std::vector<Case> ratio_cases();      ///< mass, radius
std::vector<Case> magnitude_cases();  ///< speed, gravity
std::vector<Case> place_cases();      ///< origin, start time
std::vector<Case> contact_cases();    ///< a gap of one ulp, grazing
std::vector<Case> series_cases();     ///< counting pi, Zeno
std::vector<Case> long_cases();       ///< time reversal, drift

/// What the evidence shows of a method that is held to `limit`.
Symptom diagnose(const Evidence& evidence, double limit);
/// Why, in a sentence with numbers.
std::string explain(const Case& which, const Evidence& evidence, Symptom symptom);

}  // namespace carom::stress
