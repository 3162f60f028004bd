// Selects the light of a scene: its own light, the built-in studio, one colour, or a panorama.
#pragma once

#include <string>
#include <string_view>

#include "job/params.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// Returns whether the value of --environment names a file: not "none", "studio", a colour or an empty value.
bool environment_is_file(std::string_view value);

/// Returns `value` unchanged. Throws a usage Error at `where` for an invalid colour.
std::string read_environment_choice(std::string_view value, const std::string& where);

/// Adds the requested environment to `scene`. Without one, adds missing light like add_missing_light()
/// (lippmann/stage/lighting.hpp), except that path tracing keeps the light of scenes made for Whitted shading. Returns
/// one sentence on the light, and the reason for it.
std::string light_scene(Scene& scene, const SceneParams& params, Integrator integrator, const Context& context);

}  // namespace lippmann
