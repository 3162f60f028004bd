// `lippmann info SCENE`: what is in a scene and how the array was fitted to it.
#include <fmt/core.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "apps/lippmann/command_line.hpp"
#include "apps/lippmann/commands.hpp"
#include "apps/lippmann/param_flags.hpp"
#include "apps/lippmann/print_json.hpp"
#include "job/scene_info.hpp"

namespace lippmann::app {
namespace {

struct InfoOptions {
  ParamFlags flags;
  bool json = false;
};

int run(const InfoOptions& options, const Context& context) {
  const SceneInfo info = describe_scene(with_scene_defaults(options.flags.read()), context);
  if (options.json)
    print_json(to_json(info));
  else
    fmt::print("{}", to_text(info));
  return 0;
}

}  // namespace

void add_info_command(const Command& root, Action& chosen) {
  auto options = std::make_shared<InfoOptions>();
  const Command command = root.add_command("info", "Describe a scene and how the lens array is fitted to it");
  add_param_flags(command, options->flags,
                  {"camera-path", "animation", "variant", "asset-root", "texture-memory", "camera", "up", "focus", "fit-to",
                   "zoom", "orbit", "fps", "integrator", "environment", "layout", "Optics"});
  command.add_flag("--json", options->json, "Print JSON on stdout");
  command.when_named([options, &chosen] { chosen = [options](Context& context) { return run(*options, context); }; });
}

}  // namespace lippmann::app
