// Scenes that are set up in the browser. Commands whose input may be a light field or a scene use this to distinguish both, and
// to read the flags of the render.
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

/// Declares all parameters of renders except `unwanted`, which the command declares itself, and the flag that names the job
/// file to save.
void add_scene_to_set_up_flags(const Command& command, SceneToSetUpFlags& flags,
                               std::initializer_list<std::string_view> unwanted);

/// Returns whether `in` is a scene. An existing folder is a light field even if a built-in scene has its name.
bool is_scene_to_set_up(const std::string& in);

/// Throws a usage Error naming a flag that is only for scenes, since `in` is a light field.
void refuse_scene_flags(const std::string& in, const SceneToSetUpFlags& flags);

/// Returns the parameters for rendering the scene `in`. field: flags that scenes share with light fields; throws Error if one
/// is given that does not apply to scenes. threads: number of threads; 0: the job's number.
RenderParams scene_params(const std::string& in, const SceneToSetUpFlags& flags, const LightFieldFlags& field, int threads);

/// Returns the initial settings of the page. A scene without a display is shown as a row of views, which looks good on a screen
/// at once. A job is shown as its file defines it.
LiveSettings first_settings(const RenderParams& params, const std::string& in);

/// Returns the file that Save on the page writes: the one that a flag names, or else SCENE.toml in the working folder.
std::filesystem::path job_file_for(const SceneToSetUpFlags& flags, const RenderParams& params);

}  // namespace lippmann::app
