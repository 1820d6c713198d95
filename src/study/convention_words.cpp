#include "study/convention_words.hpp"

#include "core/names.hpp"
#include "study/tolerances.hpp"
#include "study/words.hpp"

#include <algorithm>

namespace carom::study {

namespace {

std::string velocity_text(const Vec3& v)
{
    std::string text = "(";
    for (int k = 0; k < 3; ++k) text += (k > 0 ? ", " : "") + two_digits(v[k]);
    return text + ")";
}

/// "a, b, c", or the first few and how many there are.
std::string bodies_text(const Scene& scene, const std::vector<BodyId>& bodies)
{
    const std::size_t named = std::min(bodies.size(), most_bodies_in_words);
    std::string text;
    for (std::size_t k = 0; k < named; ++k) text += (k > 0 ? ", " : "") + scene.body_name(bodies[k]);
    return bodies.size() > named ? text + " and " + std::to_string(bodies.size() - named) + " more" : text;
}

/// "by reflections they leave at (0, 0, 1), (0, 0, -1)", as many as are named.
std::string answer_text(const Convention::Answer& answer)
{
    const std::size_t told = std::min(answer.velocities.size(), most_bodies_in_words);
    std::string text = std::string(name_of(answer.impact_operator, impact_operator_names)) + " ";
    for (std::size_t k = 0; k < told; ++k) text += (k > 0 ? ", " : "") + velocity_text(answer.velocities[k]);
    return text;
}

}  // namespace

std::string convention_sentence(const Scene& scene, const VerdictWords& words)
{
    const std::vector<Convention>& all = words.comparison().reference.conventions;
    const auto differs = [](const Convention& each) { return each.differ; };
    const auto first = std::find_if(all.begin(), all.end(), differs);
    if (first == all.end()) return "";
    const auto count = std::count_if(all.begin(), all.end(), differs);
    std::string text = "What happens at t = " + words.time(first->time) + " to " + bodies_text(scene, first->bodies) +
                       ", several contacts at once, is a convention; velocities after it: ";
    for (std::size_t k = 0; k < first->answers.size(); ++k)
        text += (k > 0 ? "; " : "") + answer_text(first->answers[k]);
    if (count > 1) text += " (and " + std::to_string(count - 1) + " more such instants)";
    return text + ". Errors are counted from " +
           std::string(name_of(scene.impact.impact_operator, impact_operator_names)) +
           ", the scene's: a method whose errors stop falling may follow another.";
}

}  // namespace carom::study
