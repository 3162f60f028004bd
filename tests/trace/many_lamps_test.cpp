// With many lamps, a tree chooses among them. Pictures are compared with sums of pictures with one lamp each.
#include <gtest/gtest.h>

#include "shading/shaded_scene.hpp"
#include "trace/small_scene.hpp"

namespace lippmann {
namespace {

using namespace test;

/// The eye at (0, 0, 1) sees the square from -0.2 to 0.2 in x and y at z = 0.
const Affine3f kNearEye{Mat3f(0.1f), Vec3f(0.0f)};
constexpr int kCount = 40;

MetallicRoughness floor_of(float metallic, float roughness) {
  MetallicRoughness m;
  m.metallic = metallic, m.roughness = roughness, m.specular = metallic;
  return m;
}

enum class LampKind { kPoint, kSpot, kBall, kSquare };
constexpr LampKind kLampKinds[] = {LampKind::kPoint, LampKind::kSpot, LampKind::kBall, LampKind::kSquare};

/// Adds lamp l of a spiral above the eye. Square lamps are at one height, so that none occludes another. Every third
/// lamp is ten times as strong. Spots point in all directions.
void add_lamp(SmallScene& s, LampKind kind, int l) {
  const float angle = 2.4f * static_cast<float>(l), share = static_cast<float>(l) / kCount, strength = l % 3 == 0 ? 2.0f : 0.2f;
  const Vec3f at{1.8f * std::sqrt(share) * std::cos(angle), 1.8f * std::sqrt(share) * std::sin(angle), 1.3f + 1.9f * share};
  if (kind == LampKind::kSquare) {
    MetallicRoughness shines = floor_of(0.0f, 1.0f);
    shines.base_color = Vec4f(0, 0, 0, 1), shines.emissive = Vec3f(10.0f * strength);
    Mesh mesh = square(0.1f, 2.0f);
    for (Vec3f& p : mesh.positions) p.x += at.x, p.y += at.y;
    s.add(mesh, s.material(shines));
    return;
  }
  Light& light = s.point_light(at, Vec3f(strength));
  light.inverse_square = true;
  if (kind == LampKind::kBall) light.radius = 0.15f;
  if (kind != LampKind::kSpot) return;
  light.kind = LightKind::kSpot;
  light.inner_cone = 0.3f, light.outer_cone = 0.8f;
  s.scene.nodes[static_cast<std::size_t>(light.node)].matrix->linear =
      glm::mat3_cast(glm::angleAxis(0.05f * static_cast<float>(l), glm::normalize(Vec3f(at.y, -at.x, 0.1f))));
}

SmallScene below(LampKind kind, const MetallicRoughness& floor, int first, int end) {
  SmallScene s;
  s.add(square(2, 0), s.material(floor));
  for (int l = first; l < end; ++l) add_lamp(s, kind, l);
  return s;
}

double light_below(LampKind kind, const MetallicRoughness& floor, int first, int end, int spp) {
  return mean(trace_paths(below(kind, floor, first, end).scene, single_view(8), spp, {}, 1, kNearEye).film);
}

TEST(ManyLamps, light_is_the_sum_over_lamps) {
  for (const LampKind kind : kLampKinds)
    for (const MetallicRoughness& floor : {floor_of(0.0f, 1.0f), floor_of(1.0f, 0.4f)}) {
      double sum = 0.0;
      for (int l = 0; l < kCount; ++l) sum += light_below(kind, floor, l, l + 1, 64);
      EXPECT_GT(sum, 0.01);
      EXPECT_NEAR(light_below(kind, floor, 0, kCount, 2048), sum, 0.015 * sum)
          << static_cast<int>(kind) << ", metallic " << floor.metallic;
    }
}

// A mirror shows a lamp that has a size only if a reflected ray hits the lamp. Each ray searches the tree for such
// lamps.
TEST(ManyLamps, a_mirror_shows_each_ball_once) {
  const MetallicRoughness mirror = floor_of(1.0f, 0.0f);
  Image sum;
  for (int l = 0; l < kCount; ++l) {
    const Image one = trace_paths(below(LampKind::kBall, mirror, l, l + 1).scene, single_view(48), 1, {}, 1, kNearEye).film;
    if (sum.data.empty())
      sum = one;
    else
      for (std::size_t i = 0; i < sum.data.size(); ++i) sum.data[i] += one.data[i];
  }
  const Image all = trace_paths(below(LampKind::kBall, mirror, 0, kCount).scene, single_view(48), 1, {}, 1, kNearEye).film;
  EXPECT_GT(mean(sum), 0.1);
  for (std::size_t i = 0; i < sum.data.size(); ++i) ASSERT_NEAR(all.data[i], sum.data[i], 1e-4f * (1.0f + sum.data[i])) << i;
}

TEST(ManyLamps, pictures_do_not_depend_on_threads) {
  for (const LampKind kind : kLampKinds) {
    SmallScene s = busy_scene(3);
    for (int l = 0; l < kCount; ++l) add_lamp(s, kind, l);
    const Image one = trace_paths(s.scene, single_view(48), 4, {}, 1).film;
    EXPECT_EQ(trace_paths(s.scene, single_view(48), 4, {}, 3).film.data, one.data) << static_cast<int>(kind);
  }
}

TEST(ManyLamps, dark_and_distant_lamps_change_only_noise) {
  SmallScene s = below(LampKind::kPoint, floor_of(0.0f, 1.0f), 0, kCount);
  const double before = mean(trace_paths(s.scene, single_view(8), 1024, {}, 1, kNearEye).film);
  for (int l = 0; l < 200; ++l) s.point_light({1.0f, 1.0f, 1.5f}, Vec3f(0.0f)).inverse_square = true;
  s.point_light({1e30f, 0.0f, 1.0f}, Vec3f(1.0f)).inverse_square = true;
  EXPECT_NEAR(mean(trace_paths(s.scene, single_view(8), 4096, {}, 1, kNearEye).film), before, 0.03 * before);
}

template <class Ask>
auto ask(const Scene& scene, const Ask& question) {
  const ThreadPool pool(1);
  DeviceScene device(scene, pool, Integrator::kPath);
  return question(*device.shaded().path->lights);
}

// Up to four lamps are chosen by power alone, so the probability of a lamp is the same at both points. Five lamps are
// chosen by a tree, so the probability differs.
TEST(ManyLamps, few_lamps_are_drawn_by_power) {
  for (const int lamps : {4, 5}) {
    const SmallScene s = below(LampKind::kBall, floor_of(0.0f, 1.0f), 0, lamps);
    ask(s.scene, [&](const LightTable& table) {
      const float here = table.chance_of_round(0, {Vec3f(0.0f), {0, 0, 1}}),
                  there = table.chance_of_round(0, {Vec3f(0.0f, 0.0f, 1.0f), {0, 0, 1}});
      EXPECT_EQ(here == there, lamps == 4);
      EXPECT_EQ(table.has_many_rounds(), lamps == 5);
      return 0;
    });
  }
}

TEST(ManyLamps, probabilities_of_balls_and_sun_sum_to_1) {
  for (const int squares : {0, kCount}) {
    SmallScene s = below(LampKind::kBall, floor_of(0.0f, 1.0f), 0, kCount);
    for (int l = 0; l < squares; ++l) add_lamp(s, LampKind::kSquare, l);
    Light& sun = s.point_light(Vec3f(0.0f));
    sun.kind = LightKind::kDirectional, sun.angular_diameter = 0.1f;
    ask(s.scene, [&](const LightTable& table) {
      EXPECT_EQ(table.rounds(), static_cast<std::size_t>(kCount) + 1);
      double chances = 0.0;
      for (std::size_t k = 0; k < table.rounds(); ++k)
        chances += static_cast<double>(table.chance_of_round(k, {Vec3f(0.1f), {0, 0, 1}}));
      if (squares == 0)
        EXPECT_NEAR(chances, 1.0, 1e-4);
      else
        EXPECT_LT(chances, 0.99);
      return 0;
    });
  }
}

bool keeps_table(const Scene& scene, double time) {
  const ThreadPool pool(1);
  DeviceScene device(scene, pool, Integrator::kPath);
  const LightTable* const before = device.shaded().path->lights.get();
  device.update(evaluate(scene, time), pool);
  return device.shaded().path->lights.get() == before;
}

TEST(ManyLamps, table_is_rebuilt_only_for_moving_lights) {
  const auto scene_of = [](bool lamp_moves, bool square_moves, bool box_moves) {
    SmallScene s = below(LampKind::kPoint, floor_of(0.0f, 1.0f), 0, kCount);
    const auto node = [&](bool moves) { return s.moving_node(Vec3f(0.0f), Vec3f(moves ? 1.0f : 0.0f)); };
    s.scene.lights[0].node = node(lamp_moves);
    MetallicRoughness shines = floor_of(0.0f, 1.0f);
    shines.emissive = Vec3f(1.0f);
    s.add(square(0.1f, 2.0f), s.material(shines), node(square_moves));
    s.add(square(0.1f, 1.0f), s.material(floor_of(0.0f, 1.0f)), node(box_moves));
    return s.scene;
  };
  EXPECT_TRUE(keeps_table(scene_of(false, false, true), 0.5));
  EXPECT_FALSE(keeps_table(scene_of(true, false, false), 0.5));
  EXPECT_FALSE(keeps_table(scene_of(false, true, false), 0.5));
}

TEST(ManyLamps, pictures_do_not_depend_on_earlier_frames) {
  SmallScene s = busy_scene(3);
  for (int l = 0; l < kCount; ++l) add_lamp(s, LampKind::kSquare, l);
  add_lamp(s, LampKind::kPoint, 3);
  s.scene.lights.back().node = s.moving_node({0.0f, 0.0f, 2.0f}, {1.0f, 0.0f, 2.0f});
  const ThreadPool pool(1);
  const Context context;
  TraceParams params;
  params.spp = 4;
  const auto picture = [&](std::initializer_list<double> times) {
    DeviceScene device(s.scene, pool, Integrator::kPath);
    Image film;
    for (const double time : times) device.update(evaluate(s.scene, time), pool);
    trace_frame({device, single_view(24), {}}, params, {pool, context}, {film, nullptr});
    return film.data;
  };
  EXPECT_EQ(picture({0.0, 1.0, 0.5}), picture({0.5}));
  EXPECT_NE(picture({1.0}), picture({0.5}));
}

}  // namespace
}  // namespace lippmann
