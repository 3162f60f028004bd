// Functions that build the scenes that are hard to denoise (hostile_scenes.hpp).
#pragma once

#include "lippmann/scene/scene.hpp"

namespace lippmann::bench {

// Scenes with moving shadows (hostile_shadows.cpp) and moving lights (hostile_lamps.cpp).
Scene bar_below_sun();
Scene bar_below_lamp();
Scene fast_lamp();
Scene fast_point_light();
Scene tiny_lamp();
Scene flashing_lamps();

// Scenes with surfaces that show other surfaces (hostile_surfaces.cpp), and with detail finer than pixels (hostile_detail.cpp).
Scene mirror_walls();
Scene glass_things();
Scene glossy_things();
Scene thin_things();
Scene textured_room();

// Interiors and moving groups of objects (hostile_spaces.cpp).
Scene flight_through_room();
Scene walker();
Scene turntable();
Scene furnished_room();

}  // namespace lippmann::bench
