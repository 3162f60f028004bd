// `lippmann info SCENE`: what is in a scene and how the array was fitted to it.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "apps/lippmann/commands.hpp"
#include "apps/lippmann/param_flags.hpp"
#include "render/scene_info.hpp"

namespace lippmann::app {
namespace {

struct Options {
  ParamFlags flags;
  bool json = false;
};

int run(const Options& options, const Context& context) {
  const SceneInfo info = describe_scene(options.flags.read(), context);
  if (options.json)
    fmt::print("{}\n", to_json(info).dump(2));
  else
    fmt::print("{}", to_text(info));
  return 0;
}

}  // namespace

void add_info_command(CLI::App& root, Action& chosen) {
  auto options = std::make_shared<Options>();
  CLI::App& command = *root.add_subcommand("info", "Say what is in a scene and how the array is fitted to it");
  add_param_flags(command, options->flags, {"camera-path", "animation", "fps", "Optics"});
  command.add_flag("--json", options->json, "Print JSON on stdout");
  command.callback([options, &chosen] { chosen = [options](Context& context) { return run(*options, context); }; });
}

}  // namespace lippmann::app
