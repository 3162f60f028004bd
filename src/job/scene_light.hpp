// Which light a scene is rendered in: its own, the built-in studio, one colour, or a panorama of the user's.
#pragma once

#include <string>
#include <string_view>

#include "job/params.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// Whether --environment's value is the name of a file, and not empty, none, studio or a colour.
bool environment_is_file(std::string_view value);

/// Throws a usage Error at `where` for what looks like a colour and is none. The value itself.
std::string read_environment_choice(std::string_view value, const std::string& where);

/// Lights `scene` as the parameters say. Where --environment says nothing, path-traced scenes of physical formats get the
/// studio (scene/studio_light.hpp) where they have no light of their own, a dim studio around lamps of their own; Whitted's
/// shading gets the default light (scene/default_light.hpp). Returns one sentence: which light was taken, and why.
std::string light_scene(Scene& scene, const SceneParams& params, Integrator integrator, const Context& context);

}  // namespace lippmann
