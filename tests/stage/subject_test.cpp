#include "stage/subject.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "lippmann/core/error.hpp"
#include "lippmann/scene/timeline.hpp"
#include "lippmann/stage/fit_array.hpp"
#include "stage/read_view_wish.hpp"

namespace lippmann {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr float kSubjectRounding = 1e-4f;

int add_node(Scene& scene, const std::string& name, Vec3f at = Vec3f(0.0f), int parent = -1) {
  Node node;
  node.name = name;
  node.parent = parent;
  node.local.translation = at;
  scene.nodes.push_back(node);
  return static_cast<int>(scene.nodes.size()) - 1;
}

std::size_t add_shape(Scene& scene, const std::string& name, Shape shape) {
  Instance instance;
  instance.name = name;
  instance.node = add_node(scene, name);
  instance.shape = static_cast<int>(scene.shapes.size());
  scene.shapes.push_back(std::move(shape));
  scene.instances.push_back(instance);
  return scene.instances.size() - 1;
}

std::size_t add_box(Scene& scene, const std::string& name, Vec3f lower, Vec3f upper) {
  return add_shape(scene, name, Boxes{{lower, upper}});
}

std::size_t add_sheet(Scene& scene, const std::string& name, Vec3f corner, Vec3f u, Vec3f v) {
  Mesh mesh;
  mesh.positions = {corner, corner + u, corner + u + v, corner + v};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return add_shape(scene, name, std::move(mesh));
}

void add_ground(Scene& scene, float side) {
  add_sheet(scene, "Plane", {-0.5f * side, 0, -0.5f * side}, {0, 0, side}, {side, 0, 0});
}

void add_desk(Scene& scene) {
  add_box(scene, "Top", {-0.8f, 0.7f, -0.4f}, {0.8f, 0.75f, 0.4f});
  for (const float x : {-0.75f, 0.7f})
    for (const float z : {-0.35f, 0.3f}) add_box(scene, "Leg", {x, 0, z}, {x + 0.05f, 0.7f, z + 0.05f});
}

void add_room(Scene& scene, bool with_ceiling) {
  add_sheet(scene, "Floor", {-3, 0, -3}, {0, 0, 6}, {6, 0, 0});
  add_sheet(scene, "Back", {-3, 0, -3}, {6, 0, 0}, {0, 3, 0});
  add_sheet(scene, "Left", {-3, 0, -3}, {0, 0, 6}, {0, 3, 0});
  if (with_ceiling) add_sheet(scene, "Ceiling", {-3, 3, -3}, {0, 0, 6}, {6, 0, 0});
}

std::vector<std::string> subject_of(const Scene& scene) {
  const Subject subject = find_subject(scene);
  std::vector<std::string> names;
  for (std::size_t i = 0; i < scene.instances.size(); ++i)
    if (subject.contains(i)) names.push_back(scene.instances[i].name);
  return names;
}

Camera& add_camera(Scene& scene, Vec3f at, float vertical_fov_deg = 45.0f) {
  Camera camera;
  camera.node = add_node(scene, "Camera", at);
  camera.vertical_fov = radians(vertical_fov_deg);
  scene.cameras.push_back(camera);
  return scene.cameras.back();
}

void add_travel(Scene& scene, std::size_t instance, Vec3f from, Vec3f to) {
  NodeAnimation move;
  move.node = scene.instances[instance].node;
  move.translation = {{0.0, 1.0}, {from, to}, Interpolation::kLinear};
  scene.timeline.animations.push_back(move);
  scene.timeline.frame_count = 26;
}

/// Bounding rectangle of instances in the picture over all frames, from -1 to 1 on both axes.
struct Seen {
  Vec2f lower{kInfinity}, upper{-kInfinity};
  float filled() const { return 0.5f * std::max(upper.x - lower.x, upper.y - lower.y); }
  bool is_inside() const { return std::min(lower.x, lower.y) >= -1.0f && std::max(upper.x, upper.y) <= 1.0f; }
};

void add_seen(Seen& seen, const Scene& scene, const Instance& instance, const FittedArray& array, float aspect,
              const ResolvedScene& resolved) {
  const Affine3f plane_from_world = inverse(world_from_display(array, 1.0f, resolved));
  const Bounds3f box = finite_bounds(scene, instance, resolved);
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3f world(corner & 1 ? box.upper.x : box.lower.x, corner & 2 ? box.upper.y : box.lower.y,
                      corner & 4 ? box.upper.z : box.lower.z);
    const Vec3f p = transform_point(plane_from_world, world);
    const float scale = array.viewing_distance / (array.viewing_distance - p.z) / (0.5f * array.plane_height);
    const Vec2f at = scale * Vec2f(p.x / aspect, p.y);
    seen.lower = glm::min(seen.lower, at), seen.upper = glm::max(seen.upper, at);
  }
}

Seen seen_of(const Scene& scene, const FittedArray& array, float aspect, const std::vector<std::string>& names) {
  Seen seen;
  for (int frame = 0; frame < scene.timeline.frame_count; ++frame)
    for (const Instance& instance : scene.instances)
      if (std::find(names.begin(), names.end(), instance.name) != names.end())
        add_seen(seen, scene, instance, array, aspect, evaluate(scene, scene.timeline.time(frame)));
  return seen;
}

void expect_whole(const Scene& scene, const std::vector<std::string>& names, const ViewWish& wish = {}) {
  for (const float aspect : {0.5f, 1.0f, 1.78f}) {
    const Seen seen = seen_of(scene, fit_array(scene, aspect, wish), aspect, names);
    EXPECT_TRUE(seen.is_inside()) << aspect;
    EXPECT_GE(seen.filled(), 0.85f) << aspect;
  }
}

TEST(Subject, ground_below_a_desk_is_left_out) {
  Scene scene;
  add_ground(scene, 240.0f);
  add_desk(scene);
  EXPECT_THAT(subject_of(scene), Not(testing::Contains("Plane")));
  EXPECT_EQ(subject_of(scene).size(), 5u);
  EXPECT_EQ(list_surroundings(scene, find_subject(scene)), "'Plane'");
}

TEST(Subject, shapes_hidden_from_cameras_are_ignored) {
  Scene scene;
  add_box(scene, "cup", {-1, 0, -1}, {1, 1, 1});
  const std::size_t softbox = add_sheet(scene, "softbox", {-9, 5, -9}, {18, 0, 0}, {0, 0, 18});
  scene.instances[softbox].hidden_from_cameras = true;
  const Subject subject = find_subject(scene);
  EXPECT_TRUE(subject.contains(0));
  EXPECT_FALSE(subject.contains(softbox));
  EXPECT_FALSE(subject.has_surroundings());
  EXPECT_EQ(list_surroundings(scene, subject), "");
  ViewWish cup;
  cup.fit_to = "cup";
  EXPECT_FALSE(fit_array(scene, 1.0f, cup).leaves_out_surroundings);
}

TEST(Subject, walls_of_a_room_are_left_out) {
  for (const bool with_ceiling : {false, true}) {
    Scene scene;
    add_room(scene, with_ceiling);
    add_desk(scene);
    EXPECT_THAT(subject_of(scene), testing::Each(testing::AnyOf("Top", "Leg"))) << with_ceiling;
  }
}

TEST(Subject, wall_on_a_wide_ground_is_left_out) {
  Scene scene;
  add_ground(scene, 240.0f);
  add_sheet(scene, "Wall", {-3, 0, -1}, {6, 0, 0}, {0, 3, 0});
  add_desk(scene);
  EXPECT_THAT(subject_of(scene), testing::Each(testing::AnyOf("Top", "Leg")));
}

TEST(Subject, dome_around_a_ground_is_left_out) {
  Scene scene;
  add_shape(scene, "Sky", Boxes{{Vec3f(-200), Vec3f(200)}});
  add_ground(scene, 240.0f);
  add_desk(scene);
  EXPECT_THAT(subject_of(scene), testing::Each(testing::AnyOf("Top", "Leg")));
}

TEST(Subject, body_around_small_parts_stays) {
  Scene scene;
  add_box(scene, "Body", {-1, 0, -1}, {1, 2, 1});
  add_box(scene, "Eye", {-0.1f, 1.7f, 0.8f}, {0.1f, 1.8f, 0.95f});
  EXPECT_EQ(subject_of(scene).size(), 2u);
}

TEST(Subject, flat_parts_of_objects_stay) {
  Scene table, screen;
  for (Scene* scene : {&table, &screen}) add_ground(*scene, 50.0f);
  add_box(table, "Top", {-1, 1, -1}, {1, 1.05f, 1});
  add_box(table, "Pillar", {-0.05f, 0, -0.05f}, {0.05f, 1, 0.05f});
  add_box(screen, "Panel", {-0.4f, 0.1f, -0.03f}, {0.4f, 0.6f, 0});
  add_box(screen, "Stand", {-0.1f, 0, -0.1f}, {0.1f, 0.1f, 0.1f});
  EXPECT_THAT(subject_of(table), testing::ElementsAre("Top", "Pillar"));
  EXPECT_THAT(subject_of(screen), testing::ElementsAre("Panel", "Stand"));
}

TEST(Subject, flat_things_alone_are_the_subject) {
  Scene scene;
  add_ground(scene, 4.0f);
  EXPECT_THAT(subject_of(scene), testing::ElementsAre("Plane"));
  add_box(scene, "Coin", {0, 0, 0}, {0.1f, 0.005f, 0.1f});
  add_box(scene, "Coin", {0.2f, 0, 0}, {0.3f, 0.005f, 0.1f});
  EXPECT_THAT(subject_of(scene), testing::ElementsAre("Coin", "Coin"));
}

TEST(Subject, plate_slightly_wider_than_its_load_stays) {
  Scene scene;
  add_box(scene, "Plate", {-0.6f, 0, -0.6f}, {0.6f, 0.02f, 0.6f});
  add_box(scene, "Cake", {-0.5f, 0.02f, -0.5f}, {0.5f, 0.5f, 0.5f});
  EXPECT_EQ(subject_of(scene).size(), 2u);
}

TEST(FitToSubject, desk_on_a_wide_ground_fills_the_picture) {
  Scene scene;
  add_ground(scene, 240.0f);
  add_desk(scene);
  expect_whole(scene, {"Top", "Leg"});
  const FittedArray array = fit_array(scene);
  EXPECT_LT(array.viewing_distance, 5.0f);
  EXPECT_GT(array.depth_back, -2.0f) << "the far end of the ground does not count";
  EXPECT_THAT(array.how, HasSubstr("'Plane'"));
}

TEST(FitToSubject, tall_and_wide_subjects_fill_the_picture) {
  Scene figure, engine;
  add_box(figure, "Figure", {-0.25f, 0, -0.15f}, {0.25f, 1.8f, 0.15f});
  add_box(engine, "Engine", {-6, 0, -1}, {6, 3, 1});
  expect_whole(figure, {"Figure"});
  expect_whole(engine, {"Engine"});
}

TEST(FitToSubject, ball_just_fits) {
  Scene scene;
  add_shape(scene, "Ball", Spheres{{Vec3f(5, 0, 0), 2.0f}});
  const FittedArray array = fit_array(scene);
  // the display's plane goes through the centre of the ball
  const float sine = 2.0f / array.viewing_distance;
  EXPECT_NEAR(std::tan(std::asin(sine)) / (0.5f * array.plane_height / array.viewing_distance), 1.0f / 1.05f, kSubjectRounding);
}

TEST(FitToSubject, moving_objects_fit_in_every_frame) {
  Scene scene;
  add_ground(scene, 240.0f);
  const std::size_t cart = add_box(scene, "Cart", {-1, 0, -0.5f}, {1, 1, 0.5f});
  add_travel(scene, cart, {-5, 0, 0}, {5, 0, 3});
  expect_whole(scene, {"Cart"});
}

TEST(FitToSubject, wall_right_behind_counts_as_depth) {
  Scene near, far;
  for (Scene* scene : {&near, &far}) {
    add_ground(*scene, 240.0f);
    add_desk(*scene);
  }
  add_sheet(near, "Wall", {-3, 0, -1}, {6, 0, 0}, {0, 3, 0});
  add_sheet(far, "Wall", {-30, 0, -100}, {60, 0, 0}, {0, 30, 0});
  EXPECT_LT(fit_array(near).depth_back, fit_array(far).depth_back - 0.3f);
}

TEST(FitToSubject, cameras_keep_their_view) {
  Scene scene;
  add_ground(scene, 240.0f);
  add_desk(scene);
  add_camera(scene, {0, 0.7f, 3});
  const FittedArray array = fit_array(scene);
  EXPECT_EQ(array.origin, FittedArray::Origin::kSceneCenter);
  EXPECT_NEAR(array.viewing_distance, 3.0f, 0.05f);
  EXPECT_NEAR(0.5f * array.plane_height / array.viewing_distance, std::tan(radians(22.5f)), kSubjectRounding);
  EXPECT_GT(array.depth_back, -1.0f);
}

TEST(FitToSubject, only_visible_parts_of_the_subject_count) {
  Scene scene;
  add_box(scene, "Near", {-1, -1, -1}, {1, 1, 1});
  add_box(scene, "Beside", {100, -1, -60}, {101, 1, -59});
  add_camera(scene, {0, 0, 9});
  EXPECT_NEAR(fit_array(scene).viewing_distance, 9.0f, kSubjectRounding);
}

TEST(FitToSubject, narrow_pictures_keep_the_subject) {
  Scene scene;
  add_box(scene, "Engine", {-3, -0.5f, -0.5f}, {3, 0.5f, 0.5f});
  add_camera(scene, {0, 0, 8}, 30.0f).aspect = 1.78f;
  const FittedArray array = fit_array(scene, 1.0f);
  const Seen seen = seen_of(scene, array, 1.0f, {"Engine"});
  EXPECT_TRUE(seen.is_inside());
  EXPECT_GE(seen.filled(), 0.85f);
  EXPECT_THAT(array.how, HasSubstr("degrees high instead of 30"));
  EXPECT_NEAR(fit_array(scene, 1.78f).plane_height / fit_array(scene, 1.78f).viewing_distance, 2.0f * std::tan(radians(15.0f)),
              kSubjectRounding);
}

TEST(FitToSubject, cameras_with_a_resolution_keep_their_height) {
  Scene scene;
  scene.resolution = {178, 100};
  add_box(scene, "Engine", {-3, -0.5f, -0.5f}, {3, 0.5f, 0.5f});
  add_camera(scene, {0, 0, 8}, 30.0f).aspect = 1.78f;
  const FittedArray array = fit_array(scene, 1.0f);
  EXPECT_NEAR(array.plane_height / array.viewing_distance, 2.0f * std::tan(radians(15.0f)), kSubjectRounding);
}

ViewWish focus(const std::string& text) { return {text, {}, 1.0f, {}}; }
ViewWish fit_to(const std::string& name) { return {{}, name, 1.0f, {}}; }

Scene two_boxes_before_a_camera() {
  Scene scene;
  add_box(scene, "Head", {-1, -1, 1}, {1, 1, 3});
  add_box(scene, "Tree", {-1, -1, -9}, {1, 1, -7});
  add_camera(scene, {0, 0, 12});
  return scene;
}

TEST(ViewWish, focus_moves_only_the_plane) {
  const Scene scene = two_boxes_before_a_camera();
  const std::pair<const char*, float> cases[] = {{"Head", 10.0f}, {"Tree", 20.0f}, {"1,2,-3", 15.0f}, {"4.5", 4.5f}};
  for (const auto& [text, distance] : cases) {
    const FittedArray array = fit_array(scene, 1.0f, focus(text));
    EXPECT_NEAR(array.viewing_distance, distance, kSubjectRounding) << text;
    EXPECT_NEAR(0.5f * array.plane_height / array.viewing_distance, std::tan(radians(22.5f)), kSubjectRounding) << text;
    EXPECT_NEAR(array.depth_front, distance - 9.0f, kSubjectRounding) << text;
    EXPECT_THAT(array.how, HasSubstr("The focus on"));
  }
}

TEST(ViewWish, fit_to_frames_the_node) {
  Scene scene = two_boxes_before_a_camera();
  const int parent = add_node(scene, "Group");
  scene.instances[1].node = add_node(scene, "Inner", {40, 0, 0}, parent);
  for (const char* name : {"Tree", "Group"}) {
    expect_whole(scene, {"Tree"}, fit_to(name));
    const FittedArray array = fit_array(scene, 1.0f, fit_to(name));
    const Affine3f plane = world_from_display(array, 1.0f, evaluate(scene, 0.0));
    EXPECT_NEAR(plane.linear[2].z, 1.0f, kSubjectRounding);
    EXPECT_NEAR(plane.translation.x, 40.0f, kSubjectRounding);
  }
}

TEST(ViewWish, fit_to_follows_the_camera) {
  Scene scene = two_boxes_before_a_camera();
  NodeAnimation move;
  move.node = scene.cameras[0].node;
  move.translation = {{0.0, 1.0}, {Vec3f(0, 0, 12), Vec3f(4, 1, 20)}, Interpolation::kLinear};
  scene.timeline.animations.push_back(move);
  scene.timeline.frame_count = 26;
  expect_whole(scene, {"Head"}, fit_to("Head"));
}

TEST(ViewWish, zoom_narrows_the_view) {
  const Scene scene = two_boxes_before_a_camera();
  const FittedArray plain = fit_array(scene), zoomed = fit_array(scene, 1.0f, {{}, {}, 2.0f, {}});
  EXPECT_NEAR(zoomed.plane_height, 0.5f * plain.plane_height, kSubjectRounding);
  EXPECT_EQ(zoomed.viewing_distance, plain.viewing_distance);
}

TEST(ViewWish, orbit_rotates_about_the_planes_centre) {
  const Scene scene = two_boxes_before_a_camera();
  const Affine3f before = world_from_display(fit_array(scene), 1.0f, evaluate(scene, 0.0));
  const auto turned = [&](float yaw, float pitch) {
    return world_from_display(fit_array(scene, 1.0f, {{}, {}, 1.0f, {yaw, pitch}}), 1.0f, evaluate(scene, 0.0));
  };
  EXPECT_LT(glm::length(turned(90, 0).translation - before.translation), kSubjectRounding);
  EXPECT_LT(glm::length(turned(90, 0).linear[2] - Vec3f(1, 0, 0)), kSubjectRounding) << "the viewer moves to the right";
  EXPECT_LT(glm::length(turned(0, 90).linear[2] - Vec3f(0, 1, 0)), kSubjectRounding) << "and up";
}

TEST(ViewWish, orbit_without_camera_keeps_the_subject) {
  Scene scene;
  add_ground(scene, 240.0f);
  add_desk(scene);
  for (const Orbit orbit : {Orbit{120, 0}, Orbit{-60, -10}, Orbit{0, 90}}) {
    expect_whole(scene, {"Top", "Leg"}, {{}, {}, 1.0f, orbit});
    const FittedArray array = fit_array(scene, 1.0f, {{}, {}, 1.0f, orbit});
    EXPECT_GE(array.node_from_plane.linear[1].y, -kSubjectRounding);
  }
}

void expect_refused(const Scene& scene, const ViewWish& wish, const char* words) {
  try {
    fit_array(scene, 1.0f, wish);
    FAIL() << "accepted: " << words;
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr(words));
    EXPECT_EQ(error.exit_code(), 2);
  }
}

TEST(ViewWish, invalid_wishes_are_refused) {
  Scene scene = two_boxes_before_a_camera();
  expect_refused(scene, fit_to("Haed"), "did you mean 'Head'?");
  expect_refused(scene, focus("Haed"), "did you mean 'Head'?");
  expect_refused(scene, fit_to("Camera"), "'Camera' and its children have no shapes");
  expect_refused(scene, focus("0,0,13"), "does not lie in front of the viewer");
  for (const char* text : {"0", "-1", "1,2", "1,2,3,4", "nan", "1,,2"}) expect_refused(scene, focus(text), "focus");
}

TEST(ViewWish, orbit_is_read_and_written) {
  EXPECT_EQ(read_orbit("-30", "--orbit"), (Orbit{-30, 0}));
  EXPECT_EQ(read_orbit(write_orbit({12.5f, -7}), "--orbit"), (Orbit{12.5f, -7}));
  for (const char* text : {"", "a", "1,2,3", "0,91", "nan", "1,"}) EXPECT_THROW(read_orbit(text, "--orbit"), Error) << text;
}

}  // namespace
}  // namespace lippmann
