#include "lippmann/scene/builtin.hpp"
#include "scene/builtin/scenes.hpp"

namespace lippmann {

const std::vector<BuiltinScene>& builtin_scenes() {
  static const std::vector<BuiltinScene> scenes{
      {"teapot", "the Utah teapot turns among circling tea cups on marble", builtin::build_teapot},
      {"room", "a room with a mirror, a clock, a globe, an orrery and a rolling ball, seen by a swaying display",
       builtin::build_room},
      {"small-balls", "a sphereflake of 7,381 exact spheres, every branch turning", builtin::build_small_balls},
      {"primitives", "exact spheres, cylinders, rings and a box, two meshes and a ball of glass on a merry-go-round",
       builtin::build_primitives},
      {"tree", "an autumn maple of 900,000 triangles swaying on an island in the sky", builtin::build_tree},
      {"gears", "a planetary gear train and the wheels that it drives, in mesh", builtin::build_gears},
  };
  return scenes;
}

}  // namespace lippmann
