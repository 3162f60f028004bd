#pragma once

#include "lippmann/scene/scene.hpp"

namespace lippmann::bench {

Scene bar_below_sun();
Scene bar_below_lamp();
Scene fast_lamp();
Scene fast_point_light();
Scene tiny_lamp();
Scene flashing_lamps();

Scene mirror_walls();
Scene glass_things();
Scene glossy_things();
Scene thin_things();
Scene textured_room();

Scene flight_through_room();
Scene walker();
Scene turntable();
Scene furnished_room();

}  // namespace lippmann::bench
