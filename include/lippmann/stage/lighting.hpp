// Adds light to scenes without lights.
#pragma once

#include <string>

#include "lippmann/scene/scene.hpp"
#include "lippmann/trace/integrator.hpp"

namespace lippmann {

/// Adds light to a scene that is too dark for the integrator, as `lippmann render` does.
/// - Path tracing without any emitter: the built-in studio. If walls around the viewer block the studio: a lamp at the viewer.
/// - Path tracing with lamps but without surroundings: a dim studio.
/// - Whitted shading without lamps: a key light and a dim background.
/// Existing lights are kept. A scene with light and surroundings does not change. The light is oriented by the first camera.
/// Returns one sentence that states which light was added, and why. Throws Error if the scene does not pass validate().
std::string add_missing_light(Scene& scene, Integrator integrator);

/// Replaces the scene's surroundings by the built-in studio. The studio faces the scene's first camera. `strength` multiplies
/// the light of the studio. `rotation_deg` rotates the studio about the vertical.
void surround_with_studio(Scene& scene, float strength = 1.0f, float rotation_deg = 0.0f);

}  // namespace lippmann
