// Commands whose input may be a light field or a scene use this file. A scene is set up in the browser, before it is rendered.
// The functions distinguish scenes from light fields, and read the render flags of scenes.
#pragma once

#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>

#include "apps/lippmann/light_field_flags.hpp"
#include "apps/lippmann/param_flags.hpp"
#include "live/live_settings.hpp"

namespace lippmann::app {

class Command;  // declared in command_line.hpp

struct SceneToSetUpFlags {
  ParamFlags params;
  std::string job_file;
};

/// Declares --save-job and all parameters of renders except `unwanted`. The command declares the parameters in `unwanted`
/// itself.
void add_scene_to_set_up_flags(const Command& command, SceneToSetUpFlags& flags,
                               std::initializer_list<std::string_view> unwanted);

/// Returns whether `in` is a scene. An existing folder is a light field even if a built-in scene has its name.
bool is_scene_to_set_up(const std::string& in);

/// Throws a usage Error naming a flag that is only for scenes, since `in` is a light field.
void refuse_scene_flags(const std::string& in, const SceneToSetUpFlags& flags);

/// Returns the parameters for rendering the scene `in`. field: flags of the command that describe light fields. Some of them
/// also apply to scenes; throws Error if another one is given. threads: number of threads; 0: the number in the job.
RenderParams scene_params(const std::string& in, const SceneToSetUpFlags& flags, const LightFieldFlags& field, int threads);

/// Returns the initial settings of the page. If neither flags nor a job define a display, optics or a layout, the settings are
/// a row of views, because views can be looked at on a plain screen.
LiveSettings first_settings(const RenderParams& params, const std::string& in);

/// Returns the job file that Save on the page writes: the value of --save-job, or SCENE.toml in the working folder.
std::filesystem::path job_file_for(const SceneToSetUpFlags& flags, const RenderParams& params);

}  // namespace lippmann::app
