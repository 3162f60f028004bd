#include "lippmann/stage/fit_array.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "lippmann/core/error.hpp"
#include "lippmann/stage/choose_camera.hpp"

namespace lippmann {
namespace {

using testing::HasSubstr;

// Tolerance for rounding of lengths up to 100.
constexpr float kRounding = 2e-5f;

void expect_near(Vec3f a, Vec3f b) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(a[c], b[c], kRounding) << "component " << c;
}

int add_node(Scene& scene, const Transform& local, int parent = -1) {
  Node node;
  node.local = local;
  node.parent = parent;
  scene.nodes.push_back(node);
  return static_cast<int>(scene.nodes.size()) - 1;
}

void add_box(Scene& scene, Vec3f lower, Vec3f upper) {
  Instance instance;
  instance.shape = static_cast<int>(scene.shapes.size());
  scene.shapes.push_back(Boxes{{lower, upper}});
  scene.instances.push_back(instance);
}

Camera& add_camera(Scene& scene, const Transform& local, int parent = -1) {
  Camera camera;
  camera.name = "shot";
  camera.vertical_fov = radians(60.0f);
  camera.node = add_node(scene, local, parent);
  scene.cameras.push_back(camera);
  return scene.cameras.back();
}

Affine3f plane_in_world(const Scene& scene, const FittedArray& array) {
  return world_from_display(array, 1.0f, evaluate(scene, 0.0));
}

Transform at(Vec3f position) { return {position, Quatf(1, 0, 0, 0), Vec3f(1.0f)}; }

TEST(FitArray, a_placed_display_is_used_unchanged) {
  Scene scene;
  add_box(scene, Vec3f(-1), Vec3f(1));
  add_camera(scene, at({0, 0, 9})).focus_distance = 2.0f;
  scene.display = DisplayPlacement{add_node(scene, {{0, 1, 0.5f}, glm::angleAxis(radians(90.0f), Vec3f(0, 1, 0)), Vec3f(1.0f)}),
                                   3.0f, 7.0f};
  const FittedArray array = fit_array(scene);
  EXPECT_EQ(array.origin, FittedArray::Origin::kPlaced);
  EXPECT_EQ(array.node, 1);
  EXPECT_EQ(array.plane_height, 3.0f);
  EXPECT_EQ(array.viewing_distance, 7.0f);
  // The display's +z axis is the world's +x axis, along which the box extends from -1 to 1.
  expect_near(transform_vector(plane_in_world(scene, array), {0, 0, 1}), {1, 0, 0});
  EXPECT_NEAR(array.depth_front, 1.0f, kRounding);
  EXPECT_NEAR(array.depth_back, -1.0f, kRounding);
  EXPECT_THAT(array.how, HasSubstr("scene places"));
}

TEST(FitArray, focus_distance_places_the_plane_there) {
  Scene scene;
  add_box(scene, Vec3f(-1), Vec3f(1));
  add_camera(scene, at({0, 0, 10})).focus_distance = 4.0f;
  const FittedArray array = fit_array(scene);
  EXPECT_EQ(array.origin, FittedArray::Origin::kFocus);
  expect_near(plane_in_world(scene, array).translation, {0, 0, 6});
  EXPECT_NEAR(array.plane_height, 8.0f * std::tan(radians(30.0f)), kRounding);
  EXPECT_EQ(array.viewing_distance, 4.0f);
  EXPECT_NEAR(array.depth_front, -5.0f, kRounding);
  EXPECT_NEAR(array.depth_back, -7.0f, kRounding);
  EXPECT_THAT(array.how, HasSubstr("'shot'"));
}

TEST(FitArray, default_plane_goes_through_the_centre) {
  Scene scene;
  add_box(scene, {-1, -1, -3}, {1, 1, 1});
  // The camera looks along +x, beside the box. Only the distance along its view direction counts.
  add_camera(scene, {{-10, 0.5f, 0}, glm::angleAxis(radians(-90.0f), Vec3f(0, 1, 0)), Vec3f(1.0f)});
  const FittedArray array = fit_array(scene);
  EXPECT_EQ(array.origin, FittedArray::Origin::kSceneCenter);
  expect_near(plane_in_world(scene, array).translation, {0, 0.5f, 0});
  EXPECT_NEAR(array.viewing_distance, 10.0f, kRounding);
  EXPECT_NEAR(array.plane_height, 20.0f * std::tan(radians(30.0f)), kRounding);
  EXPECT_NEAR(array.depth_front, 1.0f, kRounding);
  EXPECT_NEAR(array.depth_back, -1.0f, kRounding);
}

TEST(FitArray, central_view_equals_the_cameras_view) {
  Scene scene;
  add_box(scene, {-1, -1, -3}, {1, 1, 1});
  add_camera(scene, at({0.5f, 0, 8}));
  const FittedArray array = fit_array(scene);
  const Panel panel{100, 100, 0.5f};
  const float units_per_mm = scene_units_per_mm(array, 50.0f);
  const Optics optics{.panel = panel, .model = SingleView{array.viewing_distance / units_per_mm}};
  const Affine3f world = world_from_display(array, units_per_mm, evaluate(scene, 0));
  const Ray centre = ray_of_pixel(optics, {50, 50}), top = ray_of_pixel(optics, {50, 0});
  expect_near(transform_point(world, centre.origin), {0.5f, 0, 8});
  expect_near(glm::normalize(transform_vector(world, centre.direction)), {0, 0, -1});
  EXPECT_NEAR(std::acos(glm::dot(centre.direction, top.direction)), radians(30.0f), kRounding);
}

Camera& add_orthographic(Scene& scene, Vec3f position, float height) {
  Camera& camera = add_camera(scene, at(position));
  camera.orthographic_height = height;
  camera.aspect = 1.0f;
  return camera;
}

TEST(FitArray, orthographic_cameras_frame_their_volume) {
  Scene scene;
  add_box(scene, Vec3f(-1), Vec3f(1));
  // This box is outside the orthographic view, but inside a perspective view that is equally high at the first box.
  add_box(scene, {4, -1, -90}, {5, 1, -30});
  add_orthographic(scene, {0.5f, 0, 20}, 3.0f);
  const FittedArray array = fit_array(scene);
  EXPECT_EQ(array.origin, FittedArray::Origin::kSceneCenter);
  expect_near(plane_in_world(scene, array).translation, {0.5f, 0, 0});
  EXPECT_NEAR(array.plane_height, 3.0f, kRounding);
  EXPECT_NEAR(array.viewing_distance, 20.0f, kRounding);
}

TEST(FitArray, orthographic_height_ignores_position_and_focus) {
  for (const float away : {2.0f, 20.0f, 200.0f}) {
    Scene scene;
    add_box(scene, Vec3f(-1), Vec3f(1));
    add_orthographic(scene, {0, 0, away}, 3.0f);
    EXPECT_NEAR(fit_array(scene).plane_height, 3.0f, kRounding) << away;
    ViewWish wish;
    wish.focus = "0,0,1";
    const FittedArray focused = fit_array(scene, 1.0f, wish);
    expect_near(plane_in_world(scene, focused).translation, {0, 0, 1});
    EXPECT_NEAR(focused.plane_height, 3.0f, kRounding) << away;
    scene.cameras[0].focus_distance = 1.5f;
    EXPECT_NEAR(fit_array(scene).plane_height, 3.0f, kRounding) << away;
    // The viewer moves away from the camera until the picture is at most 45 degrees high.
    EXPECT_NEAR(fit_array(scene).viewing_distance, 1.5f / std::tan(radians(22.5f)), kRounding) << away;
  }
}

// The subject is 2 units wide, the camera's volume 6 wide and 3 high. With a margin of a twentieth, the picture is 2.1
// units wide. With an aspect of 0.5, it is 4.2 units high.
TEST(FitArray, narrow_orthographic_pictures_keep_the_subject) {
  Scene scene;
  add_box(scene, Vec3f(-1), Vec3f(1));
  add_orthographic(scene, {0, 0, 20}, 3.0f).aspect = 2.0f;
  const FittedArray array = fit_array(scene, 0.5f);
  EXPECT_NEAR(array.plane_height, 4.2f, kRounding);
  EXPECT_THAT(array.how, HasSubstr("4.2 units high instead of 3"));
}

TEST(FitArray, inside_cameras_focus_half_way) {
  Scene scene;
  add_box(scene, {-5, -5, -8}, {5, 5, 6});
  add_camera(scene, at({0, 0, 4}));
  const FittedArray array = fit_array(scene);
  // The far wall is 12 units away. The side walls come into view at 5 / tan(30 degrees).
  const float nearest = 5.0f / std::tan(radians(30.0f)), distance = 0.5f * (nearest + 12.0f);
  EXPECT_NEAR(array.viewing_distance, distance, kRounding);
  expect_near(plane_in_world(scene, array).translation, {0, 0, 4.0f - distance});
  EXPECT_NEAR(array.depth_front, distance - nearest, kRounding);
  EXPECT_NEAR(array.depth_back, distance - 12.0f, kRounding);
}

TEST(FitArray, scenes_behind_cameras_get_a_default) {
  Scene scene;
  add_box(scene, {-1, -2, 4}, {1, 2, 8});
  add_camera(scene, at({0, 0, 0}));
  const FittedArray array = fit_array(scene);
  EXPECT_NEAR(array.viewing_distance, 0.3f, kRounding);
  EXPECT_LE(array.depth_front, array.viewing_distance);
}

Vec2f seen_extent(const Scene& scene, const FittedArray& array, float aspect, Vec3f lower, Vec3f upper) {
  const Affine3f plane_from_world = inverse(plane_in_world(scene, array));
  Vec2f extent(0.0f);
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3f world(corner & 1 ? upper.x : lower.x, corner & 2 ? upper.y : lower.y, corner & 4 ? upper.z : lower.z);
    const Vec3f p = transform_point(plane_from_world, world);
    const float shrink = array.viewing_distance / (array.viewing_distance - p.z);
    extent = glm::max(extent, glm::abs(Vec2f(p.x / aspect, p.y)) * shrink / (0.5f * array.plane_height));
  }
  return extent;
}

TEST(FitArray, scenes_without_cameras_are_framed) {
  const Vec3f lower(-1, 2, -3), upper(3, 5, 7);
  Scene scene;
  add_box(scene, lower, upper);
  for (const float aspect : {1.0f, 2.0f}) {
    const FittedArray array = fit_array(scene, aspect);
    EXPECT_EQ(array.origin, FittedArray::Origin::kBounds);
    EXPECT_EQ(array.node, -1);
    const Affine3f plane = plane_in_world(scene, array);
    EXPECT_NEAR(transform_point(inverse(plane), {1, 3.5f, 2}).z, 0.0f, kRounding) << "through its middle";
    const Vec3f towards_viewer = transform_vector(plane, {0, 0, 1});
    EXPECT_GT(towards_viewer.z, 0.8f);
    EXPECT_GT(towards_viewer.y, 0.1f);
    EXPECT_GT(towards_viewer.x, 0.1f);
    EXPECT_NEAR(transform_vector(plane, {1, 0, 0}).y, 0.0f, kRounding) << "upright";
    EXPECT_NEAR(2.0f * std::atan(0.5f * array.plane_height / array.viewing_distance), radians(45.0f), kRounding);
    const Vec2f extent = seen_extent(scene, array, aspect, lower, upper);
    EXPECT_LE(std::max(extent.x, extent.y), 1.0f);
    EXPECT_GE(std::max(extent.x, extent.y), 0.85f) << "and fills the picture";
  }
}

Vec4f margins(const Scene& scene, const FittedArray& array, float aspect, Vec3f lower, Vec3f upper) {
  const Affine3f plane_from_world = inverse(plane_in_world(scene, array));
  Vec2f least(kInfinity), most(-kInfinity);
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3f world(corner & 1 ? upper.x : lower.x, corner & 2 ? upper.y : lower.y, corner & 4 ? upper.z : lower.z);
    const Vec3f p = transform_point(plane_from_world, world);
    const float shrink = array.viewing_distance / (array.viewing_distance - p.z);
    const Vec2f seen = Vec2f(p.x / aspect, p.y) * (shrink / (0.5f * array.plane_height));
    least = glm::min(least, seen), most = glm::max(most, seen);
  }
  return {1.0f + least.x, 1.0f - most.x, 1.0f + least.y, 1.0f - most.y};
}

// Seen from above, the near edge of a flat plate appears larger. The plate must still be in the middle.
TEST(FitArray, scenes_without_cameras_are_centred) {
  const Vec3f lower(-4, 0, -4), upper(4, 0.5f, 4);
  Scene scene;
  add_box(scene, lower, upper);
  for (const float aspect : {0.5f, 1.0f, 3.0f}) {
    const Vec4f room = margins(scene, fit_array(scene, aspect), aspect, lower, upper);
    EXPECT_NEAR(room.x, room.y, 0.03f) << aspect;
    EXPECT_NEAR(room.z, room.w, 0.03f) << aspect;
    EXPECT_GT(std::min({room.x, room.y, room.z, room.w}), 0.0f) << aspect;
  }
}

TEST(FitArray, cameras_that_see_nothing_warn) {
  Scene scene;
  add_box(scene, {-1, -1, 4}, {1, 1, 8});
  add_camera(scene, at({0, 0, 0}));
  EXPECT_THAT(fit_array(scene).how, HasSubstr("Nothing of the scene is seen from"));
}

TEST(FitArray, invalid_zooms_and_orbits_are_refused) {
  Scene scene;
  add_box(scene, Vec3f(-1), Vec3f(1));
  const auto field = [&](const ViewWish& wish) {
    try {
      fit_array(scene, 1.0f, wish);
    } catch (const Error& error) {
      return error.where();
    }
    return std::string();
  };
  for (const float zoom : {0.0f, -1.0f, std::nanf(""), kInfinity}) EXPECT_EQ(field({.zoom = zoom}), "zoom") << zoom;
  EXPECT_EQ(field({.orbit = {0.0f, 200.0f}}), "orbit");
  EXPECT_EQ(field({.orbit = {std::nanf(""), 0.0f}}), "orbit");
  EXPECT_EQ(field({.zoom = 2.0f, .orbit = {-30.0f, 90.0f}}), "");
}

TEST(FitArray, scenes_without_cameras_frame_all_times) {
  Scene scene;
  add_box(scene, {0, 0, 0}, {1, 1, 1});
  scene.timeline.frame_count = 26;
  NodeAnimation rise;
  rise.node = scene.instances[0].node = add_node(scene, {});
  rise.translation = {{0.0, 1.0}, {Vec3f(0.0f), Vec3f(0.0f, 4.0f, 0.0f)}, Interpolation::kLinear};
  scene.timeline.animations.push_back(rise);
  const FittedArray array = fit_array(scene);
  const Vec2f extent = seen_extent(scene, array, 1.0f, {0, 0, 0}, {1, 5, 1});
  EXPECT_LE(std::max(extent.x, extent.y), 1.0f);
}

TEST(FitArray, infinite_scenes_get_an_array) {
  Scene scene;
  FittedArray array = fit_array(scene);
  EXPECT_GT(array.plane_height, 0.0f);
  EXPECT_TRUE(std::isfinite(array.viewing_distance));
  add_camera(scene, at({0, 0, 5}));
  array = fit_array(scene);
  EXPECT_EQ(array.viewing_distance, 1.0f);
  EXPECT_EQ(array.depth_front, 0.0f);
  EXPECT_EQ(array.depth_back, 0.0f);
}

TEST(FitArray, array_moves_rigidly_with_its_camera) {
  Scene scene;
  add_box(scene, Vec3f(-1), Vec3f(1));
  add_camera(scene, at({0, 0, 10}));
  NodeAnimation move;
  move.node = 0;
  move.translation = {{0, 1}, {{0, 0, 10}, {3, 0, 20}}};
  scene.timeline.animations.push_back(move);
  const FittedArray array = fit_array(scene);
  expect_near(world_from_display(array, 1.0f, evaluate(scene, 0)).translation, {0, 0, 0});
  expect_near(world_from_display(array, 1.0f, evaluate(scene, 1)).translation, {3, 0, 10});
}

TEST(FitArray, scaled_parent_keeps_the_array_in_world_units) {
  // One camera is at (0, 0, 10), the other at (0, 0, 5) below a parent node that doubles all lengths.
  Scene plain, scaled;
  add_box(plain, Vec3f(-1), Vec3f(1));
  add_box(scaled, Vec3f(-1), Vec3f(1));
  add_camera(plain, at({0, 0, 10}));
  const int parent = add_node(scaled, {Vec3f(0), Quatf(1, 0, 0, 0), Vec3f(2.0f)});
  add_camera(scaled, at({0, 0, 5}), parent);
  const FittedArray a = fit_array(plain), b = fit_array(scaled);
  const Affine3f world_a = world_from_display(a, scene_units_per_mm(a, 64.0f), evaluate(plain, 0));
  const Affine3f world_b = world_from_display(b, scene_units_per_mm(b, 64.0f), evaluate(scaled, 0));
  expect_near(world_a.translation, world_b.translation);
  for (int c = 0; c < 3; ++c) expect_near(world_a.linear[c], world_b.linear[c]);
  EXPECT_NEAR(a.viewing_distance, b.viewing_distance, kRounding);
  EXPECT_NEAR(a.plane_height, b.plane_height, kRounding);
  EXPECT_NEAR(a.depth_front, b.depth_front, kRounding);
  EXPECT_NEAR(a.depth_back, b.depth_back, kRounding);
  EXPECT_EQ(a.how, b.how);
}

template <class F>
FittedArray fitted_below(float scale, const ViewWish& wish, const F& add) {
  Scene scene;
  add_box(scene, Vec3f(-1), Vec3f(1));
  add(scene, add_node(scene, {Vec3f(0), Quatf(1, 0, 0, 0), Vec3f(scale)}), 1.0f / scale);
  return fit_array(scene, 1.0f, wish);
}

TEST(FitArray, messages_use_world_units) {
  const auto focused = [](Scene& scene, int parent, float local) {
    add_camera(scene, at({0, 0, 10 * local}), parent).focus_distance = 4.0f * local;
  };
  const auto orthographic = [](Scene& scene, int parent, float local) {
    add_camera(scene, at({0, 0, 10 * local}), parent).orthographic_height = 3.0f * local;
  };
  const auto display = [](Scene& scene, int parent, float local) {
    scene.display = DisplayPlacement{add_node(scene, at(Vec3f(0)), parent), 3.0f * local, 7.0f * local};
  };
  const auto plain = [](Scene& scene, int parent, float local) { add_camera(scene, at({0, 0, 10 * local}), parent); };
  for (const float scale : {0.0254f, 100.0f})
    for (const ViewWish& wish : {ViewWish{}, ViewWish{.focus = "5"}, ViewWish{.focus = "0,0,0.5"}}) {
      const auto expect_same = [&](const auto& add, const char* what) {
        const FittedArray one = fitted_below(1.0f, wish, add), other = fitted_below(scale, wish, add);
        EXPECT_EQ(one.how, other.how) << what;
        EXPECT_NEAR(one.plane_height, other.plane_height, kRounding) << what;
        EXPECT_NEAR(one.viewing_distance, other.viewing_distance, kRounding) << what;
        EXPECT_NEAR(one.depth_back, other.depth_back, kRounding) << what;
      };
      expect_same(focused, "focus"), expect_same(orthographic, "orthographic"), expect_same(display, "display");
      expect_same(plain, "plain");
    }
}

TEST(FitArray, focus_distances_are_in_world_units) {
  const FittedArray array = fitted_below(0.0254f, {.focus = "5"}, [](Scene& scene, int parent, float local) {
    add_camera(scene, at({0, 0, 10 * local}), parent);
  });
  EXPECT_NEAR(array.viewing_distance, 5.0f, kRounding);
  EXPECT_THAT(array.how, HasSubstr("The focus on 5 puts the plane 5 units from the viewer."));
}

TEST(FitArray, focus_points_are_in_file_coordinates) {
  Scene scene;
  add_box(scene, Vec3f(-1), Vec3f(1));
  add_camera(scene, at({0, 0, 10}));
  const FittedArray near = fit_array(scene, 1.0f, {.focus = "0,0,0.5"});
  scene.origin = {4512345.125, 320.5, -5400000.25};
  const FittedArray far = fit_array(scene, 1.0f, {.focus = "4512345.125,320.5,-5399999.75"});
  EXPECT_EQ(far.viewing_distance, near.viewing_distance);
}

TEST(FitArray, turning_upright_turns_the_origin) {
  const Vec3d origin(4512345.125, 320.5, -5400000.25);
  const std::pair<UpAxis, Vec3d> turned[] = {{UpAxis::kY, origin},
                                             {UpAxis::kZ, {origin.x, origin.z, -origin.y}},
                                             {UpAxis::kMinusY, {origin.x, -origin.y, -origin.z}},
                                             {UpAxis::kX, {-origin.y, origin.x, origin.z}}};
  for (const auto& [up, expected] : turned) {
    Scene scene;
    scene.origin = origin;
    turn_upright(scene, up);
    EXPECT_EQ(scene.origin, expected) << static_cast<int>(up);
  }
}

TEST(FitArray, animated_scale_scales_the_array) {
  Scene scene;
  add_box(scene, Vec3f(-1), Vec3f(1));
  const int parent = add_node(scene, {Vec3f(0), Quatf(1, 0, 0, 0), Vec3f(2.0f)});
  add_camera(scene, at({0, 0, 5}), parent);
  NodeAnimation grow;
  grow.node = parent;
  grow.scale = {{0, 1}, {Vec3f(2), Vec3f(4)}};
  scene.timeline.animations.push_back(grow);
  const FittedArray array = fit_array(scene);
  EXPECT_NEAR(uniform_scale(world_from_display(array, 1.0f, evaluate(scene, 0))), 1.0f, kRounding);
  EXPECT_NEAR(uniform_scale(world_from_display(array, 1.0f, evaluate(scene, 1))), 2.0f, kRounding);
}

TEST(FitArray, array_of_a_missing_node_is_an_error) {
  FittedArray array;
  array.node = 3;
  EXPECT_THROW(world_from_display(array, 1.0f, ResolvedScene{}), Error);
}

TEST(FitArray, uneven_scale_and_mirrors_become_similarities) {
  Scene scene;
  add_box(scene, Vec3f(-1), Vec3f(1));
  const int parent = add_node(scene, {Vec3f(0), Quatf(1, 0, 0, 0), Vec3f(-1.0f, 2.0f, 4.0f)});
  add_camera(scene, at({0, 0, 2}), parent);
  const FittedArray array = fit_array(scene);
  const Affine3f world = plane_in_world(scene, array);
  EXPECT_NEAR(glm::determinant(world.linear), 1.0f, 1e-4f);
  expect_near(world.linear[0], {1, 0, 0});
  expect_near(world.linear[1], {0, 1, 0});
  expect_near(world.linear[2], {0, 0, 1});
  EXPECT_NEAR(array.viewing_distance, 8.0f, kRounding);
}

TEST(FitArray, node_scaled_to_nothing_is_refused) {
  Scene scene;
  add_box(scene, Vec3f(-1), Vec3f(1));
  add_camera(scene, {{0, 0, 5}, Quatf(1, 0, 0, 0), Vec3f(0.0f)});
  EXPECT_THROW(fit_array(scene), Error);
}

TEST(FitArray, scenes_beyond_float_range_are_refused) {
  Scene wide, distant;
  add_box(wide, Vec3f(-1e30f), Vec3f(1e30f));
  add_box(distant, Vec3f(-1), Vec3f(1));
  add_camera(distant, at({0, 1e20f, 0})).focus_distance = 2.0f;
  Scene small = distant;
  small.nodes.back().local = {Vec3f(0.0f), Quatf(1, 0, 0, 0), Vec3f(1e-11f)};
  for (const Scene* scene : {&wide, &distant, &small}) {
    try {
      fit_array(*scene);
      FAIL() << "accepted";
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), HasSubstr("scene: the lens array"));
    }
  }
}

}  // namespace
}  // namespace lippmann
