#include "scene/builtin.hpp"
#include "scene/builtin/scenes.hpp"

namespace lippmann {

const std::vector<BuiltinScene>& builtin_scenes() {
  static const std::vector<BuiltinScene> scenes{
      {"teapot", "the Utah teapot turns among circling tea cups on marble", builtin::build_teapot},
  };
  return scenes;
}

}  // namespace lippmann
