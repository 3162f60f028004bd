// dump_pose SCENE ANIMATION TIME ... prints the vertices of all meshes with skins or morph targets in world space, as
// lines "time object vertex x y z". ANIMATION is a name or an index; "" selects the first animation.
#include <fmt/core.h>

#include <cstdlib>
#include <exception>

#include "lippmann/scene/load.hpp"
#include "scene/deform.hpp"

namespace {

using namespace lippmann;

void dump(const Scene& scene, double time) {
  const ResolvedScene resolved = evaluate(scene, time);
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const Instance& instance = scene.instances[i];
    if (!is_posed(scene, instance)) continue;
    const MeshPose pose(scene, instance, resolved);
    const std::size_t vertices = std::get<Mesh>(scene.shapes[static_cast<std::size_t>(instance.shape)]).positions.size();
    for (std::size_t v = 0; v < vertices; ++v) {
      const Vec3f p = pose.position(v);
      fmt::print("{:.9g} {} {} {:.9g} {:.9g} {:.9g}\n", time, i, v, p.x, p.y, p.z);
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) {
    fmt::print(stderr, "usage: dump_pose SCENE ANIMATION TIME ...\n");
    return 2;
  }
  try {
    LoadOptions options;
    options.animation = argv[2];
    const Scene scene = load_scene(argv[1], options, Context{});
    for (int i = 3; i < argc; ++i) dump(scene, std::atof(argv[i]));
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
  return 0;
}
