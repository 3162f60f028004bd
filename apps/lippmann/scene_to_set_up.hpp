// For commands whose input may be a light field, or a scene to set up in the browser before it is rendered.
#pragma once

#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>

#include "apps/lippmann/light_field_flags.hpp"
#include "apps/lippmann/param_flags.hpp"
#include "live/live_settings.hpp"

namespace lippmann::app {

class Command;

struct SceneToSetUpFlags {
  ParamFlags params;
  std::string job_file;
};

/// Declares --save-job and all parameters of renders except `unwanted`.
void add_scene_to_set_up_flags(const Command& command, SceneToSetUpFlags& flags,
                               std::initializer_list<std::string_view> unwanted);

/// Returns whether `in` is a scene. An existing folder is a light field even if a built-in scene has its name.
bool is_scene_to_set_up(const std::string& in);

/// Throws a usage Error naming a flag that is only for scenes.
void refuse_scene_flags(const std::string& in, const SceneToSetUpFlags& flags);

/// Returns the parameters for rendering the scene `in`. Throws Error if `field` contains a flag that does not apply to scenes.
/// `threads` = 0 keeps the number in the job.
RenderParams scene_params(const std::string& in, const SceneToSetUpFlags& flags, const LightFieldFlags& field, int threads);

/// Returns the initial settings of the page. If `params` states no display, optics or layout, the settings select a row of
/// views, which a plain screen can show.
LiveSettings first_settings(const RenderParams& params, const std::string& in);

/// Returns the job file that the page saves: the value of --save-job, or SCENE.toml in the working folder.
std::filesystem::path job_file_for(const SceneToSetUpFlags& flags, const RenderParams& params);

}  // namespace lippmann::app
