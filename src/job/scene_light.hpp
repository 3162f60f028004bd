// Selects the light of a scene: its own, the built-in studio, one colour, or a panorama.
#pragma once

#include <string>
#include <string_view>

#include "job/params.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// Returns whether the value of --environment is the name of a file: not empty, and not "none", "studio" or a colour.
bool environment_is_file(std::string_view value);

/// Returns `value` unchanged, after a check. Throws a usage Error at `where` for an invalid colour.
std::string read_environment_choice(std::string_view value, const std::string& where);

/// Lights `scene` according to the parameters. Without --environment, path-traced scenes of physical formats get the studio
/// (scene/studio_light.hpp) if they have no light, or a dim studio in addition to their own lamps; Whitted shading gets the
/// default light (scene/default_light.hpp). Returns one sentence on the light used, and why.
std::string light_scene(Scene& scene, const SceneParams& params, Integrator integrator, const Context& context);

}  // namespace lippmann
