// Builders of the hostile scenes (hostile_scenes.hpp).
#pragma once

#include "lippmann/scene/scene.hpp"

namespace lippmann::bench {

// Moving shadows and moving lights: hostile_shadows.cpp, hostile_lamps.cpp.
Scene bar_below_sun();
Scene bar_below_lamp();
Scene fast_lamp();
Scene fast_point_light();
Scene tiny_lamp();
Scene flashing_lamps();

// Surfaces that show other surfaces, or detail finer than pixels: hostile_surfaces.cpp, hostile_detail.cpp.
Scene mirror_walls();
Scene glass_things();
Scene glossy_things();
Scene thin_things();
Scene textured_room();

// Interiors and moving groups: hostile_spaces.cpp.
Scene flight_through_room();
Scene walker();
Scene turntable();
Scene furnished_room();

}  // namespace lippmann::bench
