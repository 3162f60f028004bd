#include "trace/path_wave.hpp"

#include <gtest/gtest.h>

#include <set>

#include "trace/small_scene.hpp"

namespace lippmann {
namespace {

using namespace test;

SmallScene two_squares() {
  SmallScene s;
  const int material = s.material(matte(Vec3f(0.5f)));
  s.add(square(0.5f, 0.0f), material, s.node({Mat3f(1.0f), {-0.5f, 0.0f, 0.0f}}));
  s.add(square(0.5f, 1.0f), material, s.node({Mat3f(1.0f), {0.5f, 0.0f, 0.0f}}));
  return s;
}

/// Returns ray `r`, which points down from z = 5. Successive rays hit the left square, the right square, nothing, and
/// so on.
PathRay ray_down(std::uint32_t r) {
  PathRay ray;
  ray.origin = {static_cast<float>(r % 3) - 0.5f, 0.1f, 5.0f};
  ray.direction = {0.0f, 0.0f, -1.0f};
  ray.t_near = 0.001f * static_cast<float>(r);
  ray.pixel = r;
  return ray;
}

TEST(PathWave, rays_return_once_with_their_hits) {
  const SmallScene s = two_squares();
  const ThreadPool pool(1);
  DeviceScene device(s.scene, pool, Integrator::kPath);
  device.update(evaluate(s.scene, 0.0), pool);
  std::vector<PathRay> rays;
  for (std::uint32_t r = 0; r < 100; ++r) rays.push_back(ray_down(r));
  std::set<std::uint32_t> seen;
  trace_wave(device.shaded(), rays, [&](const RayHitPacket& packet, const LaneMask& active, const PathRay* of) {
    for (int i = 0; i < kLanes; ++i) {
      if (!active.lane[i]) continue;
      EXPECT_TRUE(seen.insert(of[i].pixel).second) << of[i].pixel;
      EXPECT_EQ(packet.ray.org_x[i], of[i].origin.x);
      EXPECT_EQ(packet.ray.tnear[i], of[i].t_near);
      constexpr float kDistances[] = {5.0f, 4.0f, kInfinity};
      EXPECT_FLOAT_EQ(packet.ray.tfar[i], kDistances[of[i].pixel % 3]);
      EXPECT_EQ(packet.hit.geomID[i] == kNoId, of[i].pixel % 3 == 2);
    }
  });
  EXPECT_EQ(seen.size(), rays.size());
}

TEST(PathWave, packets_group_rays_with_equal_hits) {
  const SmallScene s = two_squares();
  const ThreadPool pool(1);
  DeviceScene device(s.scene, pool, Integrator::kPath);
  device.update(evaluate(s.scene, 0.0), pool);
  std::vector<PathRay> rays;
  for (std::uint32_t r = 0; r < 3 * kLanes; ++r) rays.push_back(ray_down(r));
  trace_wave(device.shaded(), rays, [&](const RayHitPacket&, const LaneMask&, const PathRay* of) {
    for (int i = 1; i < kLanes; ++i) EXPECT_EQ(of[i].pixel % 3, of[0].pixel % 3);
  });
}

}  // namespace
}  // namespace lippmann
