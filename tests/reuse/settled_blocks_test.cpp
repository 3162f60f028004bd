#include "reuse/settled_blocks.hpp"

#include <gtest/gtest.h>

#include <random>

#include "trace/small_scene.hpp"

namespace lippmann {
namespace {

using test::SmallScene;
constexpr int kLast = 1000;

SettledBlocks planner(std::optional<int> every = {}) {
  static const Scene nothing;
  return {nothing, -1, every};
}

/// Returns blocks of one ray each. Horizon h covers the frames 0 to 2^(h+1) - 1. A moving object first meets block i in
/// horizon h = lowest_horizon[i], so block i is settled in the frames before 2^h and must be traced from frame 2^h on.
TouchedBlocks blocks_with(const std::vector<std::uint8_t>& lowest_horizon) {
  return {{}, lowest_horizon, std::vector<std::uint32_t>(lowest_horizon.size(), 1)};
}

TEST(SettledBlocks, touched_blocks_are_traced_from_their_horizon) {
  const TouchedBlocks blocks = blocks_with({0, 1, 2, TouchedBlocks::kNever});
  const SettledBlocks settled = planner();
  EXPECT_EQ(settled.unsettled(blocks, 1), (std::vector<std::uint8_t>{1, 0, 0, 0}));
  EXPECT_EQ(settled.unsettled(blocks, 2), (std::vector<std::uint8_t>{1, 1, 0, 0}));
  EXPECT_EQ(settled.unsettled(blocks, 3), (std::vector<std::uint8_t>{1, 1, 0, 0}));
  EXPECT_EQ(settled.unsettled(blocks, 4), (std::vector<std::uint8_t>{1, 1, 1, 0}));
  EXPECT_EQ(settled.unsettled(blocks, 63), (std::vector<std::uint8_t>{1, 1, 1, 0}));
}

TEST(SettledBlocks, span_follows_the_motion) {
  EXPECT_EQ(planner().choose_span(blocks_with({255, 255}), 0, kLast), 64);
  EXPECT_EQ(planner().choose_span(blocks_with({255, 255}), 0, 9), 10);
  EXPECT_EQ(planner().choose_span(blocks_with({0, 0}), 0, kLast), 1);
}

TEST(SettledBlocks, span_ends_when_most_blocks_move) {
  EXPECT_EQ(planner().choose_span(blocks_with({3, 3, 3, 3, 3, 3, 3, 255}), 0, kLast), 8);
}

TEST(SettledBlocks, blocks_count_by_their_rays) {
  TouchedBlocks blocks = blocks_with({3, 255});
  blocks.rays = {90, 10};
  EXPECT_EQ(planner().choose_span(blocks, 0, kLast), 8);
  blocks.rays = {10, 90};
  EXPECT_EQ(planner().choose_span(blocks, 0, kLast), 64);
}

TEST(SettledBlocks, given_interval_is_kept) {
  EXPECT_EQ(planner(5).choose_span(blocks_with({0, 0}), 0, kLast), 5);
  EXPECT_EQ(planner(100).choose_span(blocks_with({0, 0}), 0, kLast), 100);
  EXPECT_EQ(planner(5).choose_span(blocks_with({0, 0}), 0, 2), 3);
}

/// Adds two deforming squares. A skin moves two corners of the first square with a joint, which moves towards `to`. A
/// morph target moves one corner of the second square in the same direction.
void add_deforming(SmallScene& s, Vec3f to, int material) {
  Mesh skinned = test::square(0.5f, 0), morphing = test::square(0.4f, 1);
  skinned.skin = {1, {0, 0, 1, 1}, {1, 1, 1, 1}};
  const int still = s.node({Mat3f(1.0f), {0, 1, 0}}), moving = s.moving_node({0, -1, 0}, to);
  s.scene.instances[static_cast<std::size_t>(s.add(skinned, material, still))].skin = static_cast<int>(s.scene.skins.size());
  s.scene.skins.push_back({"", {still, moving}, {Affine3f{}, Affine3f{}}});
  morphing.targets = {{{{0, 0, 0}, 0.2f * to, {0, 0, 0}, {0, 0, 0}}, {}, {}}};
  const int node = s.moving_node({1, 0, 0}, {1, 0, 0});
  s.scene.nodes[static_cast<std::size_t>(node)].morph_weights = {0.0f};
  s.scene.timeline.animations.back().morph_weights = {{0.0, 1.0}, {0.0f, 1.0f}, Interpolation::kLinear};
  s.add(morphing, material, node);
}

SmallScene random_scene(std::uint32_t seed) {
  std::mt19937 random(seed);
  const auto number = [&](float from, float to) { return std::uniform_real_distribution<float>(from, to)(random); };
  const auto place = [&] { return Vec3f(number(-2, 2), number(-2, 2), number(-3, 3)); };
  SmallScene s;
  s.scene.max_depth = 3;
  s.scene.timeline.frames_per_second = 10.0;
  s.scene.timeline.frame_count = 6;
  PhongSurface glass = test::matte(Vec3f(0.8f));
  glass.opacity = 0.4f;
  const int materials[] = {s.material(test::matte({0.9f, 0.3f, 0.2f})), s.material(test::mirror(0.7f)), s.material(glass)};
  for (int i = 0; i < 9; ++i) {
    const int node = i % 3 == 0 ? s.moving_node(place(), place()) : s.node({Mat3f(1.0f), place()});
    const int material = materials[random() % 3];
    const float size = number(0.1f, 0.5f);
    switch (random() % 4) {
      case 0:
        s.add(Spheres{{Vec3f(0.0f), size}}, material, node);
        break;
      case 1:
        s.add(Boxes{{Vec3f(-size), Vec3f(size)}}, material, node);
        break;
      case 2:
        s.add(Cylinders{{{0, -size, 0}, {0, size, 0}, size}}, material, node);
        break;
      default:
        s.add(test::square(size, 0), material, node);
    }
  }
  if (seed % 2 == 0) add_deforming(s, place(), materials[random() % 3]);
  s.add(test::square(20, -4), materials[0]);
  s.point_light({number(-5, 5), 6, 8});
  s.point_light({number(-5, 5), -3, 6}, Vec3f(0.4f));
  return s;
}

Optics lenticular_sheet() {
  return {.panel = {96, 96, 4.0f / 96}, .model = LenticularSheet{6.0f * 4.0f / 96, 0.5f, 0.0f, 0.0f, 10.0f, 0.0f}};
}

Optics slanted_panel() {
  return {.panel = {48, 48, 4.0f / 48}, .model = SlantedPanel{.periods = 11.3, .view_cone = 0.5f, .distance_mm = 10.0f}};
}

void expect_settled_blocks_as_traced(const Optics& optics) {
  const ThreadPool pool(2);
  const Context context;
  std::size_t settled_blocks = 0;
  for (std::uint32_t seed = 0; seed < 12; ++seed) {
    const SmallScene s = random_scene(seed);
    const SettledBlocks settled(s.scene, -1, 6);
    DeviceScene device(s.scene, pool);
    TraceParams params;
    params.max_depth = s.scene.max_depth;
    TouchedBlocks blocks;
    blocks.boxes = settled.boxes(0, 5);
    Image key;
    device.update(evaluate(s.scene, 0.0), pool);
    trace_frame({device, optics, {}}, params, {pool, context}, {key, nullptr, nullptr, &blocks});
    for (int frame = 1; frame < 6; ++frame) {
      device.update(evaluate(s.scene, s.scene.timeline.time(frame)), pool);
      Image traced, made = key;
      trace_frame({device, optics, {}}, params, {pool, context}, {traced});
      const std::vector<std::uint8_t> wanted = settled.unsettled(blocks, frame);
      trace_blocks({device, optics, {}}, params, wanted, {pool, context}, made);
      settled_blocks += static_cast<std::size_t>(std::count(wanted.begin(), wanted.end(), 0));
      ASSERT_EQ(made.data, traced.data) << "scene " << seed << ", frame " << frame;
    }
  }
  // The number of settled blocks differs between compilers, because the evaluation order of arguments changes random
  // scenes.
  EXPECT_GT(settled_blocks, 0u);
}

TEST(SettledBlocks, settled_blocks_equal_traced_blocks) { expect_settled_blocks_as_traced(lenticular_sheet()); }

TEST(SettledBlocks, settled_blocks_of_slanted_panels_equal_traced) { expect_settled_blocks_as_traced(slanted_panel()); }

}  // namespace
}  // namespace lippmann
