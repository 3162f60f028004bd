// Adds light to scenes without lights.
#pragma once

#include <string>

#include "lippmann/scene/scene.hpp"
#include "lippmann/trace/integrator.hpp"

namespace lippmann {

/// Adds light to a scene that is too dark for the integrator, as `lippmann render` does.
/// - Path tracing without any emitter: the built-in studio, or a lamp at the viewer if walls block the studio.
/// - Path tracing with lamps but without surroundings: a dim studio.
/// - Whitted shading without lamps: a key light and a dim background.
///
/// The first camera orients the light. Returns a sentence on the added light, and why. Throws Error if the scene does not pass
/// validate().
std::string add_missing_light(Scene& scene, Integrator integrator);

/// Replaces the surroundings by the built-in studio, which faces the first camera. `strength` multiplies its light.
/// `rotation_deg` rotates it about the vertical.
void surround_with_studio(Scene& scene, float strength = 1.0f, float rotation_deg = 0.0f);

}  // namespace lippmann
