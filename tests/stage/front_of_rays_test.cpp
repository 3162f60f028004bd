// The scene's camera is at (0, 0, 4) and looks along -z. The display's viewer is farther away.
#include "stage/front_of_rays.hpp"

#include <gtest/gtest.h>

#include "lippmann/stage/placement.hpp"

namespace lippmann {
namespace {

constexpr float kFittedEye = 12.0f;

class FrontOfRays : public testing::Test {
 protected:
  FrontOfRays() {
    scene.materials.emplace_back();
    Camera camera;
    camera.node = add_node({0, 0, 4});
    camera.vertical_fov = radians(60.0f), camera.focus_distance = 4.0f;
    scene.cameras.push_back(camera);
    add_box({-0.5f, -0.5f, -0.5f}, {0.5f, 0.5f, 0.5f});
  }

  int add_node(Vec3f at) {
    Node node;
    node.local.translation = at;
    scene.nodes.push_back(node);
    return static_cast<int>(scene.nodes.size()) - 1;
  }

  Instance& add(Shape shape) {
    Instance instance;
    instance.node = add_node(Vec3f(0.0f)), instance.material = 0;
    instance.shape = static_cast<int>(scene.shapes.size());
    scene.shapes.push_back(std::move(shape));
    scene.instances.push_back(instance);
    return scene.instances.back();
  }

  Instance& add_box(Vec3f lower, Vec3f upper) { return add(Boxes{{lower, upper}}); }

  Instance& add_quad(Vec3f corner, Vec3f u, Vec3f v) {
    Mesh mesh;
    mesh.positions = {corner, corner + u, corner + u + v, corner + v};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    return add(std::move(mesh));
  }

  void add_floor(float near) { add_quad({-30, -1, near}, {60, 0, 0}, {0, 0, -60}); }
  void add_wall(float z, float width = 60.0f) { add_quad({-0.5f * width, -9, z}, {width, 0, 0}, {0, 18, 0}); }

  auto begin(float eye = kFittedEye) const { return front_of_rays(scene, fit_array(scene), 1.0f, eye); }
  float front() const { return begin().z; }

  Scene scene;
};

TEST_F(FrontOfRays, is_the_camera_with_nothing_behind_it) {
  EXPECT_EQ(front(), 4.0f);
  add_floor(3.0f);
  EXPECT_EQ(front(), 4.0f);
}

TEST_F(FrontOfRays, is_the_eye_above_a_floor) {
  add_floor(30.0f);
  EXPECT_EQ(front(), kFittedEye);
  EXPECT_EQ(begin(3.0f).z, 4.0f) << "the eye is in front of the camera";
}

TEST_F(FrontOfRays, is_the_eye_above_infinite_floors) {
  add(Planes{{{0, -1, 0}, {0, 1, 0}}});
  EXPECT_EQ(front(), kFittedEye);
}

TEST_F(FrontOfRays, is_in_front_of_walls_behind_cameras) {
  add_floor(30.0f);
  add_wall(5.0f);
  EXPECT_GT(front(), 4.9f);
  EXPECT_LT(front(), 5.0f);
}

TEST_F(FrontOfRays, is_in_front_of_a_slanted_wall) {
  add_quad({-9, -9, 5}, {18, 0, 3}, {0, 18, 0});
  EXPECT_GT(front(), 4.0f);
  EXPECT_LT(front(), 6.5f);
}

TEST_F(FrontOfRays, is_in_front_of_an_infinite_wall) {
  add(Planes{{{0, 0, 6}, {0, 0, -1}}});
  EXPECT_GT(front(), 5.9f);
  EXPECT_LT(front(), 6.0f);
}

TEST_F(FrontOfRays, is_within_a_closed_room) {
  add_box({-3, -1, -3}, {3, 3, 5});
  EXPECT_GT(front(), 4.0f);
  EXPECT_LT(front(), 5.0f);
}

TEST_F(FrontOfRays, is_the_eye_behind_a_chair) {
  add_floor(30.0f);
  add_box({0.3f, -1, 5}, {0.6f, 0, 5.3f});
  EXPECT_EQ(front(), kFittedEye);
  add_wall(6.0f);
  EXPECT_GT(front(), 5.9f) << "the chair is in front of the wall";
  EXPECT_LT(front(), 6.0f);
}

TEST_F(FrontOfRays, ignores_shapes_hidden_from_cameras) {
  add_wall(5.0f);
  scene.instances.back().hidden_from_cameras = true;
  EXPECT_EQ(front(), 4.0f);
}

TEST_F(FrontOfRays, lies_before_a_wall_within_the_near_clipping_plane) {
  add_wall(3.5f);
  EXPECT_EQ(begin(4.0f).z, 4.0f) << "the camera sees the wall";
  scene.cameras[0].near_distance = 1.0f;
  for (const float eye : {2.0f, 4.0f, kFittedEye}) {
    EXPECT_GT(begin(eye).z, 3.4f) << eye;
    EXPECT_LT(begin(eye).z, 3.5f) << eye;
  }
}

TEST_F(FrontOfRays, scales_the_near_clipping_plane_with_the_camera) {
  add_wall(3.5f);
  scene.nodes[static_cast<std::size_t>(scene.cameras[0].node)].local.scale = Vec3f(0.5f);
  scene.cameras[0].focus_distance = 8.0f, scene.cameras[0].near_distance = 0.75f;
  EXPECT_FLOAT_EQ(begin(4.0f).z, 4.0f) << "the camera sees the wall, 1 of its own units away";
  scene.cameras[0].near_distance = 1.25f;
  EXPECT_LT(begin(4.0f).z, 3.5f);
}

TEST_F(FrontOfRays, lies_before_a_wall_behind_an_orthographic_camera) {
  scene.cameras[0].orthographic_height = 8.0f;
  EXPECT_GT(begin().z, 9.0f) << "the viewer of a beam stands farther away";
  add_wall(5.0f);
  EXPECT_GT(begin().z, 4.9f);
  EXPECT_LT(begin().z, 5.0f);
}

TEST_F(FrontOfRays, names_the_walls_that_are_cut) {
  add_floor(30.0f);
  EXPECT_EQ(begin().cut, "");
  add_wall(5.0f);
  scene.nodes.back().name = "back";
  EXPECT_EQ(begin().cut,
            "Rays begin 4.999 units in front of the plane, because walls would hide the scene from the viewer: 'back'.");
}

TEST_F(FrontOfRays, is_where_placed_optics_rays_start) {
  Optics view{.panel = {100, 100, 1.0f}, .model = SingleView{.distance_mm = 400.0f}};
  const auto begins = [&] { return resolved_z_front_mm(place(scene, view).placed.optics); };
  const float of_camera = begins();
  EXPECT_LT(of_camera, 100.0f);
  add_floor(30.0f);
  EXPECT_EQ(begins(), 400.0f);
  add_wall(5.0f);
  EXPECT_GT(begins(), of_camera);
  EXPECT_LT(begins(), 1.3f * of_camera);
  EXPECT_NE(place(scene, view).array.how.find("Rays begin"), std::string::npos);
}

}  // namespace
}  // namespace lippmann
