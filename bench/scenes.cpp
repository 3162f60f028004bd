#include "bench/scenes.hpp"

#include "scene/builtin.hpp"
#include "scene/timeline.hpp"

namespace lippmann::bench {

std::vector<BenchScene> bench_scenes(const Context&) {
  std::vector<BenchScene> result;
  for (const BuiltinScene& builtin : builtin_scenes()) {
    BenchScene b;
    b.name = builtin.name;
    b.scene = builtin.build();
    b.time = b.scene.timeline.time(b.scene.timeline.frame_count / 3);
    const float scale = b.scene.display->plane_height / 64.0f;
    LenticularSheet sheet;
    sheet.gap_mm = 0.5f / std::tan(radians(14.0f));
    sheet.viewing_distance_mm = b.scene.display->viewing_distance / scale;
    b.optics.model = sheet;
    b.world_from_display = evaluate(b.scene, b.time).of(b.scene.display->node) * Affine3f{Mat3f(scale), Vec3f(0.0f)};
    result.push_back(std::move(b));
  }
  return result;
}

}  // namespace lippmann::bench
