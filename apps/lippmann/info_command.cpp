// `lippmann info IN`: describes a picture, or a scene and how the lens array is fitted to it.
#include <fmt/core.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "apps/lippmann/command_line.hpp"
#include "apps/lippmann/commands.hpp"
#include "apps/lippmann/param_flags.hpp"
#include "apps/lippmann/print_json.hpp"
#include "formats/frame_names.hpp"
#include "formats/light_field_source.hpp"
#include "job/scene_info.hpp"
#include "lippmann/core/error.hpp"
#include "replay/picture_info.hpp"
#include "video/video_reader.hpp"

namespace lippmann::app {
namespace {

namespace fs = std::filesystem;

struct InfoOptions {
  ParamFlags flags;
  bool json = false;
};

/// The name of a built-in scene takes precedence over a folder with this name.
bool is_picture(const std::string& in) {
  std::error_code ignored;
  return !is_builtin_scene(in) &&
         (is_picture_name(in) || is_video_name(in) || is_light_field_file_name(in) || fs::is_directory(in, ignored));
}

void refuse_flags_of_scenes(const ParamFlags& flags) {
  if (!flags.job.empty()) throw usage_error("--job", "has no effect on pictures", "a scene in place of the pictures");
  if (flags.sheet.are_given())
    throw usage_error(flags.sheet.first_given(), "has no effect on pictures", "a scene in place of the pictures");
  for (const auto& [name, values] : flags.values)
    if (!values.empty())
      throw usage_error(fmt::format("--{}", name), "has no effect on pictures", "a scene in place of the pictures");
}

template <class Info>
void print(const Info& info, bool json) {
  if (json)
    print_json(to_json(info));
  else
    fmt::print("{}", to_text(info));
}

int run(const InfoOptions& options, const Context& context) {
  if (is_picture(options.flags.scene)) {
    refuse_flags_of_scenes(options.flags);
    PictureInfo info = describe_picture(options.flags.scene);
    info.problem = with_flags(info.problem);
    print(info, options.json);
    return 0;
  }
  print(describe_scene(options.flags.resolve(), context), options.json);
  return 0;
}

}  // namespace

void add_info_command(const Command& root, Action& chosen) {
  auto options = std::make_shared<InfoOptions>();
  const Command command =
      root.add_command("info", "Describe a scene and how the lens array is fitted to it, or a picture or a folder of pictures");
  add_param_flags(command, options->flags,
                  {"camera-path", "animation", "variant", "asset-root", "texture-memory", "points", "camera", "up", "focus",
                   "fit-to", "zoom", "orbit", "fps", "integrator", "environment", "layout", "Optics"});
  command.add_flag("--json", options->json, "Print JSON on stdout");
  command.footer(
      "SCENE may also be a picture, a video, or a folder of views or frames; info then prints format, size, views, cameras and "
      "depth.");
  command.when_named([options, &chosen] { chosen = [options](Context& context) { return run(*options, context); }; });
}

}  // namespace lippmann::app
