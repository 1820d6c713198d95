/// \file
/// Reads every scene that is named and runs it to its end: the README's ```json blocks.
#include <carom/io.hpp>
#include <carom/simulate.hpp>

#include <cstdio>

int main(int count, char** files)
{
    for (int i = 1; i < count; ++i) try {
            const carom::Scene scene = carom::read_scene(files[i]);
            const carom::Outcome outcome = carom::simulate(scene, carom::EventDriven{});
            std::printf("%s: %s, %lld impacts %s\n", scene.name.c_str(), carom::name(outcome.status),
                        static_cast<long long>(outcome.counts.impacts), outcome.message.c_str());
            if (outcome.status != carom::Status::reached_end) return 1;
        } catch (const carom::InputError& error) {
            std::printf("%s\n", error.what());
            return 1;
        }
    return count > 1 ? 0 : 1;
}
