#include "reuse/swept_boxes.hpp"

#include <gtest/gtest.h>

#include "trace/small_scene.hpp"

namespace lippmann {
namespace {

using test::SmallScene;

// Tests boxes around all moving objects until frame 2 and until frame 4, at one frame per second. Nodes of
// moving_node() move from frame 0 to frame 1 and then stay.
constexpr int kHorizons[] = {2, 4};

SmallScene one_frame_a_second() {
  SmallScene s;
  s.scene.timeline.frames_per_second = 1.0;
  s.scene.timeline.frame_count = 10;
  s.material(test::glowing(Vec3f(1.0f)));
  return s;
}

bool inside(const std::vector<HorizonBox>& boxes, Vec3f p, int horizon) {
  for (const HorizonBox& box : boxes)
    if (box.horizon <= horizon && glm::all(glm::lessThanEqual(box.bounds.lower, p)) &&
        glm::all(glm::lessThanEqual(p, box.bounds.upper)))
      return true;
  return false;
}

TEST(SweptBoxes, static_objects_have_no_boxes) {
  SmallScene s = one_frame_a_second();
  s.add(test::square(1, 0), 0);
  s.add(test::square(1, 0), 0, s.moving_node({0, 0, 0}, {5, 0, 0}));
  EXPECT_TRUE(SweptBoxes(s.scene, -1).around(1, kHorizons, 9).empty());
}

TEST(SweptBoxes, boxes_contain_start_and_end) {
  SmallScene s = one_frame_a_second();
  s.add(Spheres{{{0, 0, 0}, 1.0f}}, 0, s.moving_node({0, 0, 0}, {5, 0, 0}));
  const std::vector<HorizonBox> boxes = SweptBoxes(s.scene, -1).around(0, kHorizons, 9);
  ASSERT_EQ(boxes.size(), 1u) << "the later horizon adds no boxes";
  EXPECT_EQ(boxes[0].horizon, 0);
  EXPECT_EQ(boxes[0].bounds.lower, Vec3f(-1, -1, -1));
  EXPECT_EQ(boxes[0].bounds.upper, Vec3f(6, 1, 1));
}

TEST(SweptBoxes, later_motion_belongs_to_later_horizons) {
  SmallScene s = one_frame_a_second();
  const int node = s.moving_node({0, 0, 0}, {5, 0, 0});
  s.scene.timeline.animations[0].translation.times = {2.0, 3.0};
  s.add(Spheres{{{0, 0, 0}, 1.0f}}, 0, node);
  const std::vector<HorizonBox> boxes = SweptBoxes(s.scene, -1).around(0, kHorizons, 9);
  EXPECT_FALSE(inside(boxes, {0, 0, 0}, 0));
  EXPECT_TRUE(inside(boxes, {0, 0, 0}, 1));
  EXPECT_TRUE(inside(boxes, {5, 0, 0}, 1));
}

TEST(SweptBoxes, boxes_contain_only_changing_parts) {
  SmallScene s = one_frame_a_second();
  Mesh two = test::square(0.5f, 0);
  const Mesh other = test::square(0.5f, 0);
  for (const Vec3f& p : other.positions) two.positions.push_back(p + Vec3f(100, 0, 0));
  two.uvs.clear();
  two.triangles.push_back({4, 7, 6}), two.triangles.push_back({4, 6, 5});
  two.targets.resize(1);
  two.targets[0].positions.assign(8, Vec3f(0.0f));
  two.targets[0].positions[6] = {0, 0, 3};
  const int node = s.moving_node({0, 0, 0}, {0, 0, 0});
  s.scene.nodes[0].morph_weights = {0.0f};
  s.scene.timeline.animations[0].morph_weights = {{0.0, 1.0}, {0.0f, 1.0f}, Interpolation::kLinear};
  s.add(two, 0, node);
  const std::vector<HorizonBox> boxes = SweptBoxes(s.scene, -1).around(0, kHorizons, 9);
  ASSERT_EQ(boxes.size(), 1u);
  EXPECT_EQ(boxes[0].bounds.lower, Vec3f(99.5f, -0.5f, 0));
  EXPECT_EQ(boxes[0].bounds.upper, Vec3f(100.5f, 0.5f, 3));
}

TEST(SweptBoxes, changing_normals_count) {
  SmallScene s = one_frame_a_second();
  Mesh mesh = test::square(0.5f, 0);
  mesh.normals.assign(4, Vec3f(0, 0, 1));
  mesh.targets.resize(1);
  mesh.targets[0].normals.assign(4, Vec3f(1, 0, 0));
  const int node = s.moving_node({0, 0, 0}, {0, 0, 0});
  s.scene.nodes[0].morph_weights = {0.0f};
  s.scene.timeline.animations[0].morph_weights = {{0.0, 1.0}, {0.0f, 1.0f}, Interpolation::kLinear};
  s.add(mesh, 0, node);
  EXPECT_TRUE(inside(SweptBoxes(s.scene, -1).around(0, kHorizons, 9), {0.4f, 0.4f, 0}, 0));
}

TEST(SweptBoxes, frames_after_the_last_do_not_count) {
  SmallScene s = one_frame_a_second();
  const int node = s.moving_node({0, 0, 0}, {5, 0, 0});
  s.scene.timeline.animations[0].translation.times = {2.0, 3.0};
  s.add(Spheres{{{0, 0, 0}, 1.0f}}, 0, node);
  EXPECT_TRUE(SweptBoxes(s.scene, -1).around(0, kHorizons, 2).empty());
}

TEST(SweptBoxes, boxes_contain_turning_rings_but_not_holes) {
  SmallScene s = one_frame_a_second();
  Mesh ring;
  for (int i = 0; i < 600; ++i) {
    const float a = 2.0f * kPi * static_cast<float>(i) / 600.0f;
    for (const Vec3f offset : {Vec3f(0, 0, 0), Vec3f(0.1f, 0, 0), Vec3f(0, 0.1f, 0.1f)})
      ring.positions.push_back(Vec3f(10.0f * std::cos(a), 10.0f * std::sin(a), 0) + offset);
    const auto first = static_cast<std::uint32_t>(3 * i);
    ring.triangles.push_back({first, first + 1, first + 2});
  }
  const int node = s.moving_node({0, 0, 0}, {0, 0, 0});
  NodeAnimation& animation = s.scene.timeline.animations[0];
  animation.translation = {};
  animation.rotation.times = {0.0, 4.0};
  animation.rotation.values = {Quatf(1, 0, 0, 0), glm::angleAxis(radians(40.0f), Vec3f(0, 0, 1))};
  s.add(ring, 0, node);
  const std::vector<HorizonBox> boxes = SweptBoxes(s.scene, -1).around(0, kHorizons, 9);
  for (int frame = 0; frame < 4; ++frame) {
    const Affine3f place = evaluate(s.scene, frame).of(node);
    for (const Vec3f& p : ring.positions) ASSERT_TRUE(inside(boxes, transform_point(place, p), frame < 2 ? 0 : 1));
  }
  EXPECT_FALSE(inside(boxes, {0, 0, 0}, 1));
}

TEST(SweptBoxes, moving_displays_lights_and_planes_cover_everything) {
  enum class What { kDisplay, kLight, kPlane };
  for (const What what : {What::kDisplay, What::kLight, What::kPlane}) {
    SmallScene s = one_frame_a_second();
    const int node = s.moving_node({0, 0, 0}, {5, 0, 0});
    s.scene.timeline.animations[0].translation.times = {2.0, 3.0};
    if (what == What::kLight) s.point_light({0, 0, 5}).node = node;
    if (what == What::kPlane) s.add(Planes{{}}, 0, node);
    const SweptBoxes swept(s.scene, what == What::kDisplay ? node : -1);
    const std::vector<HorizonBox> boxes = swept.around(0, kHorizons, 9);
    EXPECT_FALSE(inside(boxes, {1e6f, 0, 0}, 0));
    EXPECT_TRUE(inside(boxes, {1e6f, 0, 0}, 1));
    EXPECT_TRUE(inside(swept.around(2, kHorizons, 9), {1e6f, 0, 0}, 0));
  }
}

}  // namespace
}  // namespace lippmann
