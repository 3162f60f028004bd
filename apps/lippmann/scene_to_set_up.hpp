// A scene that is set up in the browser, where a command takes scenes beside light fields: which arguments are scenes, and the
// flags that say how it is rendered.
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

/// Declares all parameters of renders but `unwanted`, which the command declares itself, and the job that the page writes.
void add_scene_to_set_up_flags(const Command& command, SceneToSetUpFlags& flags,
                               std::initializer_list<std::string_view> unwanted);

/// What exists as a folder is a light field, whatever a built-in scene is called.
bool is_scene_to_set_up(const std::string& in);

/// Throws a usage Error naming a flag that says how a scene is rendered, and so says nothing of the light field `in`.
void refuse_scene_flags(const std::string& in, const SceneToSetUpFlags& flags);

/// The render of the scene `in`. `field` has those of its flags that light fields have, too; others of them are refused.
/// threads: 0 is as the job has it. Throws Error.
RenderParams scene_params(const std::string& in, const SceneToSetUpFlags& flags, const LightFieldFlags& field, int threads);

/// The settings that a page begins with. Where nothing says what shows the scene, that is a row of views, which look good on a
/// screen at once; a job is shown as it is.
LiveSettings first_settings(const RenderParams& params, const std::string& in);

/// What Save on the page writes: SCENE.toml in the working folder, unless a flag says otherwise.
std::filesystem::path job_file_for(const SceneToSetUpFlags& flags, const RenderParams& params);

}  // namespace lippmann::app
