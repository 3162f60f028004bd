#include "scene/builtin.hpp"
#include "scene/builtin/scenes.hpp"

namespace lippmann {

const std::vector<BuiltinScene>& builtin_scenes() {
  static const std::vector<BuiltinScene> scenes{
      {"teapot", "the Utah teapot turns among circling tea cups on marble", builtin::build_teapot},
      {"small-balls", "a sphereflake of 7,381 exact spheres, every branch turning", builtin::build_small_balls},
      {"gears", "a planetary gear train and the wheels that it drives, in mesh", builtin::build_gears},
  };
  return scenes;
}

}  // namespace lippmann
