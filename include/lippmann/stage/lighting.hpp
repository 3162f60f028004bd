// Adds light to scenes without lights.
#pragma once

#include <string>

#include "lippmann/scene/scene.hpp"
#include "lippmann/trace/integrator.hpp"

namespace lippmann {

/// Adds light to a scene that is too dark for the integrator, as `lippmann render` does.
/// - Path tracing: the built-in studio if nothing emits light, or a lamp at the viewer if walls around the viewer block the
/// studio; a dim studio if there are lamps but no surroundings.
/// - Whitted shading: a key light and a dim background if there are no lamps.
/// Existing lights are kept, and a scene with light and surroundings does not change. The light is oriented by the first
/// camera. Returns one sentence that states which light was added, and why. Throws Error if the scene does not pass validate().
std::string add_missing_light(Scene& scene, Integrator integrator);

/// Surrounds the scene with the built-in studio instead of its own surroundings. The studio faces the scene's first camera.
/// `strength` multiplies the studio's light; `rotation_deg` rotates it about the vertical.
void surround_with_studio(Scene& scene, float strength = 1.0f, float rotation_deg = 0.0f);

}  // namespace lippmann
