// Scenes that are set up in the browser, for commands that take scenes beside light fields: tells the two apart, and reads the
// flags of the render.
#pragma once

#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>

#include "apps/lippmann/light_field_flags.hpp"
#include "apps/lippmann/param_flags.hpp"
#include "live/live_settings.hpp"

namespace lippmann::app {

class Command;  // command_line.hpp

struct SceneToSetUpFlags {
  ParamFlags params;
  std::string job_file;
};

/// Declares all parameters of renders except `unwanted`, which the command declares itself, and the flag of the job that the
/// page writes.
void add_scene_to_set_up_flags(const Command& command, SceneToSetUpFlags& flags,
                               std::initializer_list<std::string_view> unwanted);

/// Returns whether `in` is a scene. An existing folder is a light field even if a built-in scene has its name.
bool is_scene_to_set_up(const std::string& in);

/// Throws a usage Error naming a flag of scenes, which has no effect on the light field `in`.
void refuse_scene_flags(const std::string& in, const SceneToSetUpFlags& flags);

/// Returns the render of the scene `in`. field: flags that scenes share with light fields; throws Error for those that scenes
/// lack. threads: 0 takes the job's number.
RenderParams scene_params(const std::string& in, const SceneToSetUpFlags& flags, const LightFieldFlags& field, int threads);

/// Returns the initial settings of the page. A scene without a display is shown as a row of views, which looks good on a screen
/// at once; a job is shown as it is.
LiveSettings first_settings(const RenderParams& params, const std::string& in);

/// Returns the file that Save on the page writes: SCENE.toml in the working folder unless a flag names another.
std::filesystem::path job_file_for(const SceneToSetUpFlags& flags, const RenderParams& params);

}  // namespace lippmann::app
