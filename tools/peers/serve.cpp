#include "serve.hpp"

#include "io/numbers.hpp"
#include "stepped_run.hpp"

#include <carom/io.hpp>

#include <exception>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>

namespace carom::peers {

namespace {

struct Request {
    double dt = 0;              ///< [time]
    std::vector<double> times;  ///< [time]
};

Request request_of(const std::string& line)
{
    std::istringstream words(line);
    std::string verb;
    Request request;
    if (!(words >> verb >> request.dt) || verb != "run" || !(request.dt > 0))
        throw std::invalid_argument("a request begins with: run DT T1 T2 ...");
    for (double time = 0; words >> time;) request.times.push_back(time);
    return request;
}

void append(std::string& text, const Vec3& v)
{
    for (int axis = 0; axis < 3; ++axis) text.append(",").append(io::number_text(v[axis]));
}

std::string answer(const Request& request, const std::string& scene_text, Settings settings)
{
    ReadOptions options;
    options.allow_overlap = true;  // the scene has been read before, and says itself what may overlap
    const Scene scene = parse_scene(scene_text, "scene", options);
    expect_no_drag(scene);
    settings.dt = request.dt;
    const std::unique_ptr<Engine> engine = make_engine(scene, settings);
    const SteppedRun run = stepped_run(scene, settings, *engine, request.times);
    std::string text = "# " + engine->words() + "\nt,id,x,y,z,vx,vy,vz\n";
    for (std::size_t k = 0; k < run.samples.size(); ++k) {
        const std::string time = io::number_text(request.times[k]);
        for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
            text.append(time).append(",").append(io::csv_field(scene.spheres[i].id));
            append(text, run.samples[k][i].position);
            append(text, run.samples[k][i].velocity);
            text += '\n';
        }
    }
    return text + "# steps " + std::to_string(run.steps) + " cpu_seconds " + io::number_text(run.cpu_seconds) + "\n";
}

/// Errors of a scene are several lines; an answer has one.
std::string on_one_line(std::string text)
{
    for (char& c : text)
        if (c == '\n') c = ' ';
    return text;
}

}  // namespace

void serve(Settings settings)
{
    std::string head, scene;
    while (std::getline(std::cin, head) && std::getline(std::cin, scene)) {
        try {
            std::cout << answer(request_of(head), scene, settings);
        } catch (const std::exception& error) {
            std::cout << "# error " << on_one_line(error.what()) << '\n';
        }
        std::cout << "# end" << std::endl;
    }
}

}  // namespace carom::peers
