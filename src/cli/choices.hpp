/// \file
/// Options from the command line, else from the scene's defaults for the command, else built in.
#pragma once

#include "cli/arguments.hpp"

#include <carom/method.hpp>
#include <carom/scene.hpp>
#include <carom/study.hpp>

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace carom::cli {

/// Looks an option up and reads its value. What the user typed wrongly throws UsageError, what the scene says wrongly
/// InputError with the place.
class Choices {
public:
    /// `place` is the scene's file and the pointer of `defaults`, for messages: "ball.json: /compare".
    Choices(const GivenOptions& given, const CommandDefaults& defaults, std::string place);

    double number(const std::string& name, double otherwise) const;                                       ///< > 0
    long long integer(const std::string& name, long long otherwise) const;                                ///< >= 1
    std::vector<double> numbers(const std::string& name, std::vector<double> otherwise) const;            ///< each > 0
    std::vector<int> integers(const std::string& name, std::vector<int> otherwise) const;                 ///< each >= 1
    std::vector<double> numbers_from_zero(const std::string& name, std::vector<double> otherwise) const;  ///< each >= 0
    std::vector<std::string> methods(const std::string& name,
                                     std::vector<std::string> otherwise) const;  ///< known ones
    /// Words of a list, each among `known`. \param what one of them is, for messages
    std::vector<std::string> words(const std::string& name, std::vector<std::string> otherwise,
                                   const std::vector<std::string>& known, const std::string& what) const;
    StepOptions step(std::uint64_t seed) const;  ///< order, integrator, literal; dt, substeps, passes as built in
    std::string word(const std::string& name, const std::vector<std::string>& known) const;  ///< \pre has(name)
    std::string text(const std::string& name) const;  ///< as given, empty if it is not
    bool flag(const std::string& name) const;
    bool has(const std::string& name) const;

    template <typename T>
    std::vector<T> named_list(const std::string& name, std::vector<T> otherwise, T (*value_of)(std::string_view)) const;

    /// \throws InputError if the defaults name an option that is not among `known`.
    void expect_known(const std::vector<std::string>& known) const;

private:
    template <typename T>
    T named(const std::string& name, T otherwise, T (*value_of)(std::string_view)) const;
    template <typename T, typename Parse>
    T read(const std::string& name, T otherwise, Parse parse) const;

    const GivenOptions& given_;
    GivenOptions defaults_;
    std::string place_;
};

struct RunSettings {
    Method method;
    RunOptions run;
    std::optional<double> frames;                                  ///< > 0, in a unit of time [1/time]
    bool always_final = false;                                     ///< final states of many spheres, too
    double max_seconds = std::numeric_limits<double>::infinity();  ///< for the whole command [s]
};
RunSettings run_settings(const RunArguments& args, const GlobalArguments& global, const Scene& scene,
                         const std::string& file);

struct CompareSettings {
    CompareOptions compare;
    std::vector<std::string> absent;  ///< engines asked for that are not there, and how to get them
    double max_seconds = std::numeric_limits<double>::infinity();  ///< for the whole command [s]
};
CompareSettings compare_settings(const CompareArguments& args, const GlobalArguments& global, const Scene& scene,
                                 const std::string& file);

}  // namespace carom::cli
