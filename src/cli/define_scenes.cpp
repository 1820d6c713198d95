#include "cli/define.hpp"

#include <CLI/CLI.hpp>

namespace carom::cli {

void define_scenes(CLI::App& app, ScenesArguments& scenes)
{
    app.require_subcommand(0, 1);
    CLI::App* list = app.add_subcommand("list", "The catalogue, one scene a line");
    list->callback([&scenes] { scenes.action = ScenesAction::list; });
    list->footer("Examples:\n  carom scenes list\n  carom scenes list --json");
    CLI::App* show = app.add_subcommand("show", "What a scene contains");
    show->callback([&scenes] { scenes.action = ScenesAction::show; });
    show->add_option("scene", scenes.show, "Scene file, or a name of the catalogue")->required()->type_name("SCENE");
    show->footer("Examples:\n  carom scenes show bouncing_ball\n  carom scenes show bouncing_ball --json");
    CLI::App* validate = app.add_subcommand("validate", "Read scenes and say what is wrong with them");
    validate->callback([&scenes] { scenes.action = ScenesAction::validate; });
    validate->add_option("scenes", scenes.validate, "Scene files, or names of the catalogue [all of it]")
        ->type_name("SCENE...");
    validate->footer("Examples:\n  carom scenes validate\n  carom scenes validate my_scene.json --json");
    CLI::App* schema = app.add_subcommand("schema", "The JSON schema of scene files, for editors");
    schema->callback([&scenes] { scenes.action = ScenesAction::schema; });
    schema->footer("Examples:\n  carom scenes schema > scene.schema.json");
    app.footer(
        "Examples:\n  carom scenes\n  carom scenes show bouncing_ball\n"
        "Scenes are looked for in the folder that the environment names in CAROM_SCENES, by default the one of the "
        "build.\n"
        "Exit: 0 done, 2 usage, 3 no such scene or a scene that is not valid.");
}

}  // namespace carom::cli
