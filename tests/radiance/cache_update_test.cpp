// What feeding the cache tells of light that may have changed.
#include "radiance/cache_update.hpp"

#include <gtest/gtest.h>

#include "radiance/update_frame.hpp"
#include "trace/small_scene.hpp"

namespace lippmann {
namespace {

using namespace test;

constexpr float kLampDistance = 50.0f, kLampHalf = 0.5f, kLampLight = 1000.0f;
constexpr float kTurn = 0.2f;  // radians, about the y axis, from 0 to 0.5 s

/// A square that turns from facing the viewer towards a small lamp, which is far away on the right at 45 degrees.
SmallScene turning_square() {
  SmallScene s;
  s.scene.max_depth = 2;
  s.scene.nodes.push_back({"", -1, {}, {}});
  NodeAnimation turn;
  turn.node = 0;
  turn.rotation.times = {0.0, 0.5, 1.0};
  const Quatf turned = glm::angleAxis(kTurn, Vec3f(0.0f, 1.0f, 0.0f));
  turn.rotation.values = {Quatf(1.0f, 0.0f, 0.0f, 0.0f), turned, turned};
  s.scene.timeline.animations.push_back(turn);
  s.add(square(1.0f, 0.0f), s.material(matte(Vec3f(0.5f))), 0);
  PhongSurface lamp = matte(Vec3f(0.0f));
  lamp.emission = Vec3f(kLampLight);
  const float across = std::sqrt(0.5f);
  const Mat3f facing(Vec3f(across, 0.0f, -across), Vec3f(0.0f, 1.0f, 0.0f), Vec3f(-across, 0.0f, -across));
  const Vec3f at = kLampDistance * Vec3f(across, 0.0f, across);
  s.add(square(kLampHalf, 0.0f), s.material(lamp), s.node({facing, at}));
  return s;
}

/// Means over what is fed at a moment, where everything is watched that has moved since the one before.
struct MeanChange {
  double light = 0.0, share = 0.0;
};

MeanChange change_of(const SmallScene& small, double before, double now) {
  const Scene& scene = small.scene;
  const ThreadPool pool(1);
  const Context context;
  const Optics optics = single_view(64);
  DeviceScene device(scene, pool, Integrator::kPath);
  SurfacePlaces places(device.shaded());
  for (const double time : {before, now}) {
    const ResolvedScene resolved = evaluate(scene, time);
    device.update(resolved, pool);
    places.update(resolved);
  }
  const BeamFootprint beam(optics, {});
  const CacheCells cells{places, beam, 2.0f, LightGroup::kLamps};
  const std::vector<HorizonBox> around{{{Vec3f(-2.0f), Vec3f(2.0f)}, 0}};
  const TouchProbe moved(device.shaded(), around);
  RadianceCache cache(1u << 14);
  TraceParams params;
  params.max_depth = scene.max_depth;
  const CacheUpdater updater({device, optics, {}}, params);
  MeanChange mean;
  double count = 0.0;
  for (int round = 0; round < 8; ++round)
    for (const CacheRecords& strip : updater.update({cells, cache, pool, context, &moved}, round).strips)
      for (const RadianceRecord& record : strip.records) {
        mean.light += static_cast<double>(record.changed_light), mean.share += static_cast<double>(record.changed_share);
        count += 1.0;
      }
  return {mean.light / count, mean.share / count};
}

// A lamp of area A and radiance L, d away, sends L A cos / (pi d^2) to a white surface. The square's cosine was cos(45 degrees)
// and is cos(45 degrees - turn): so much light may have changed, though it has not left its place.
TEST(CacheUpdate, what_turns_towards_a_lamp_gets_as_much_more_light) {
  const MeanChange change = change_of(turning_square(), 0.0, 0.5);
  const double area = 4.0 * kLampHalf * kLampHalf, across = kLampDistance;
  const double per_cosine = kLampLight * area / (M_PI * across * across);
  const double more = per_cosine * (std::cos(M_PI / 4 - kTurn) - std::cos(M_PI / 4));
  EXPECT_NEAR(change.light, more, 0.02 * more);
}

// What comes from all around, by the mean change of the cosine it arrives at: about as much as it turns by.
TEST(CacheUpdate, what_turns_may_change_light_from_all_around) {
  const MeanChange change = change_of(turning_square(), 0.0, 0.5);
  EXPECT_GT(change.share, 0.6 * kTurn);
  EXPECT_LT(change.share, 1.4 * kTurn);
}

TEST(CacheUpdate, what_lies_still_is_sure_of_its_light) {
  const MeanChange change = change_of(turning_square(), 0.5, 1.0);
  EXPECT_NEAR(change.light, 0.0, 1e-6);
  EXPECT_NEAR(change.share, 0.0, 1e-6);
}

}  // namespace
}  // namespace lippmann
