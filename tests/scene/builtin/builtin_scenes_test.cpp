#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <ostream>
#include <set>
#include <string>

#include "lippmann/core/error.hpp"
#include "lippmann/scene/builtin.hpp"
#include "lippmann/scene/load.hpp"
#include "lippmann/scene/timeline.hpp"
#include "mesh_checks.hpp"

namespace lippmann {

static void PrintTo(const BuiltinScene& scene, std::ostream* out) { *out << scene.name; }

namespace {

const Scene& built(const BuiltinScene& builtin) {
  static std::map<std::string_view, Scene> scenes;
  const auto [it, is_new] = scenes.try_emplace(builtin.name);
  if (is_new) it->second = builtin.build();
  return it->second;
}

class EachScene : public testing::TestWithParam<BuiltinScene> {
 protected:
  const Scene& scene() const { return built(GetParam()); }
};

INSTANTIATE_TEST_SUITE_P(BuiltinScenes, EachScene, testing::ValuesIn(builtin_scenes()), [](const auto& scene) {
  std::string name(scene.param.name);
  for (char& c : name)
    if (c == '-') c = '_';
  return name;
});

/// Returns the largest displacement of the node's origin and of its unit vectors.
float motion(const Affine3f& a, const Affine3f& b) {
  float most = glm::length(a.translation - b.translation);
  for (int axis = 0; axis < 3; ++axis) most = std::max(most, glm::length(a.linear[axis] - b.linear[axis]));
  return most;
}

TEST_P(EachScene, is_valid) { EXPECT_NO_THROW(validate(scene(), scene().name)); }

TEST_P(EachScene, is_called_what_the_table_says) { EXPECT_EQ(scene().name, GetParam().name); }

TEST_P(EachScene, lasts_at_least_400_frames) { EXPECT_GE(scene().timeline.frame_count, 400); }

TEST_P(EachScene, loop_closes) {
  const Timeline& timeline = scene().timeline;
  const ResolvedScene first = evaluate(scene(), 0.0), after_last = evaluate(scene(), timeline.time(timeline.frame_count));
  for (std::size_t i = 0; i < scene().nodes.size(); ++i)
    EXPECT_LT(motion(first.world_from_node[i], after_last.world_from_node[i]), 1e-4f) << scene().nodes[i].name;
}

TEST_P(EachScene, motion_never_jumps) {
  // From frame to frame, also from the last to the first, a node's speed changes by at most half of its top speed.
  const Timeline& timeline = scene().timeline;
  const std::size_t nodes = scene().nodes.size();
  const int frames = timeline.frame_count;
  std::vector<ResolvedScene> at_frame;
  for (int frame = 0; frame < frames; ++frame) at_frame.push_back(evaluate(scene(), timeline.time(frame)));
  for (std::size_t node = 0; node < nodes; ++node) {
    std::vector<float> speed;
    for (int frame = 0; frame < frames; ++frame)
      speed.push_back(motion(at_frame[frame].world_from_node[node], at_frame[(frame + 1) % frames].world_from_node[node]));
    const float top = *std::max_element(speed.begin(), speed.end());
    for (int frame = 0; frame < frames; ++frame)
      EXPECT_LE(std::abs(speed[(frame + 1) % frames] - speed[frame]), 0.5f * top + 1e-5f)
          << scene().nodes[node].name << ", frame " << frame;
  }
}

TEST_P(EachScene, things_move_and_not_the_viewer_alone) {
  const std::vector<bool> moves = moving_nodes(scene());
  std::set<int> moving;
  for (const Instance& instance : scene().instances)
    if (instance.node >= 0 && instance.node != scene().display->node && moves[static_cast<std::size_t>(instance.node)])
      moving.insert(instance.node);
  EXPECT_GE(moving.size(), 3u);
}

TEST_P(EachScene, straddles_its_array) {
  ASSERT_TRUE(scene().display.has_value());
  const ResolvedScene resolved = evaluate(scene(), 0.0);
  const Affine3f world_from_display = resolved.of(scene().display->node);
  float nearest = -kInfinity, farthest = kInfinity;
  for (const Instance& instance : scene().instances) {
    Scene alone;
    alone.nodes = scene().nodes;
    alone.shapes = {scene().shapes[static_cast<std::size_t>(instance.shape)]};
    alone.instances = {{"", 0, -1, instance.node}};
    ResolvedScene in_display = resolved;
    for (Affine3f& a : in_display.world_from_node) a = inverse(world_from_display) * a;
    if (instance.node < 0) alone.nodes.push_back({}), in_display.world_from_node.push_back(inverse(world_from_display));
    if (instance.node < 0) alone.instances[0].node = static_cast<int>(alone.nodes.size()) - 1;
    const Bounds3f bounds = finite_bounds(alone, in_display);
    nearest = std::max(nearest, bounds.upper.z);
    farthest = std::min(farthest, bounds.lower.z);
  }
  const float height = scene().display->plane_height;
  EXPECT_GT(nearest, 0.1f * height);
  EXPECT_LT(farthest, -0.1f * height);
}

TEST_P(EachScene, has_no_infinite_planes) {
  for (const Shape& shape : scene().shapes) EXPECT_FALSE(std::holds_alternative<Planes>(shape));
}

TEST_P(EachScene, camera_is_at_the_design_viewer) {
  const Scene& s = scene();
  ASSERT_FALSE(s.cameras.empty());
  EXPECT_NEAR(std::tan(0.5f * s.cameras[0].vertical_fov), 0.5f * s.display->plane_height / s.display->viewing_distance, 1e-5f);
}

TEST_P(EachScene, meshes_are_sane) {
  for (std::size_t i = 0; i < scene().shapes.size(); ++i)
    if (const Mesh* mesh = std::get_if<Mesh>(&scene().shapes[i])) {
      EXPECT_EQ(test::count_degenerate(*mesh), 0) << "shape " << i;
      EXPECT_EQ(test::count_normals_not_unit(*mesh), 0) << "shape " << i;
      EXPECT_EQ(test::count_facing_wrong(*mesh), 0) << "shape " << i;
    }
}

TEST_P(EachScene, builds_the_same_twice) {
  const Scene again = GetParam().build();
  EXPECT_EQ(again.nodes.size(), scene().nodes.size());
  ASSERT_EQ(again.shapes.size(), scene().shapes.size());
  for (std::size_t i = 0; i < again.shapes.size(); ++i)
    if (const Mesh* mesh = std::get_if<Mesh>(&again.shapes[i])) {
      EXPECT_EQ(mesh->positions, std::get<Mesh>(scene().shapes[i]).positions);
    }
  for (std::size_t i = 0; i < again.textures.size(); ++i) EXPECT_EQ(again.textures[i].rgba, scene().textures[i].rgba);
}

TEST(LoadScene, loads_a_built_in_scene_by_name) {
  const Scene scene = load_scene("teapot", {}, Context{});
  EXPECT_EQ(scene.name, "teapot");
  EXPECT_EQ(scene.timeline.frame_count, 480);
}

TEST(LoadScene, frame_rate_keeps_the_duration) {
  LoadOptions options;
  options.frames_per_second = 60.0;
  const Scene scene = load_scene("teapot", options, Context{});
  EXPECT_EQ(scene.timeline.frame_count, 960);
  EXPECT_EQ(scene.timeline.time(960), 16.0);
}

TEST(LoadScene, rejects_camera_paths_for_built_ins) {
  LoadOptions options;
  options.camera_path = "a.cam";
  EXPECT_THROW(load_scene("teapot", options, Context{}), Error);
}

}  // namespace
}  // namespace lippmann
