#include "frames/picture_check.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <string>

#include "lippmann/frames/renderer.hpp"
#include "lippmann/scene/load.hpp"
#include "scene/splats.hpp"

namespace lippmann {
namespace {

using testing::HasSubstr;

class PictureCheck : public testing::Test {
 protected:
  PictureCheck() {
    scene.materials.push_back({"red", {}});
    scene.materials.back().surface = MetallicRoughness{.base_color = {0.8f, 0.2f, 0.1f, 1.0f}, .metallic = 0.0f};
    scene.background.horizon = scene.background.zenith = Vec3f(0.5f);
    scene.timeline.frame_count = 1;
  }

  MetallicRoughness& surface() { return std::get<MetallicRoughness>(scene.materials.front().surface); }

  int add_node(Vec3f at) {
    Node node;
    node.local.translation = at;
    scene.nodes.push_back(node);
    return static_cast<int>(scene.nodes.size()) - 1;
  }

  void add(const char* name, Shape shape) {
    Instance instance;
    instance.name = name;
    instance.node = add_node(Vec3f(0.0f));
    instance.material = 0;
    instance.shape = static_cast<int>(scene.shapes.size());
    scene.shapes.push_back(std::move(shape));
    scene.instances.push_back(instance);
  }

  void add_box(const char* name, Vec3f lower, Vec3f upper) {
    Mesh mesh;
    for (int i = 0; i < 8; ++i)
      mesh.positions.push_back({i & 1 ? upper.x : lower.x, i & 2 ? upper.y : lower.y, i & 4 ? upper.z : lower.z});
    for (const auto& [a, b, c, d] : {std::array{0u, 1u, 3u, 2u}, std::array{4u, 5u, 7u, 6u}, std::array{0u, 1u, 5u, 4u},
                                     std::array{2u, 3u, 7u, 6u}, std::array{0u, 2u, 6u, 4u}, std::array{1u, 3u, 7u, 5u}}) {
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
    }
    surface().double_sided = true;
    add(name, std::move(mesh));
  }

  void add_camera(Vec3f at) {
    Camera camera;
    camera.node = add_node(at);
    scene.cameras.push_back(camera);
  }

  std::string warnings(Integrator integrator = Integrator::kPath) const {
    std::string all;
    Context context;
    context.warn = [&](std::string_view text) { all += std::string(text) + '\n'; };
    FrameParams params;
    params.sampling.integrator = integrator;
    const Optics view{.panel = {32, 32, 2.0f}, .model = SingleView{.distance_mm = 150.0f}};
    Renderer renderer(scene, place(scene, view), params, context);
    for (int times = 0; times < 2; ++times) EXPECT_TRUE(renderer.frame(0).has_value());
    return all;
  }

  Scene scene;
};

TEST_F(PictureCheck, a_box_has_no_warning) {
  add_box("box", Vec3f(-1), Vec3f(1));
  EXPECT_EQ(warnings(), "");
  EXPECT_EQ(warnings(Integrator::kWhitted), "");
}

TEST_F(PictureCheck, a_stray_part_is_named_once) {
  add_box("box", Vec3f(-1), Vec3f(1));
  add_box("lost", {5000, 0, 0}, {5001, 1, 1});
  EXPECT_THAT(warnings(), HasSubstr("'lost'"));
  EXPECT_THAT(warnings(), testing::Not(HasSubstr("frame 0")));
}

TEST_F(PictureCheck, no_surfaces) { EXPECT_THAT(warnings(), HasSubstr("the scene has no surfaces")); }

TEST_F(PictureCheck, no_area) {
  Mesh mesh;
  mesh.positions = {Vec3f(0), Vec3f(1), Vec3f(2)};
  mesh.triangles = {{0, 1, 2}};
  add("line", mesh);
  EXPECT_THAT(warnings(), HasSubstr("all triangles of the scene have area 0"));
}

TEST_F(PictureCheck, alpha_of_0_in_both_modes) {
  add_box("box", Vec3f(-1), Vec3f(1));
  surface().base_color.w = 0.0f, surface().blend = true;
  EXPECT_THAT(warnings(), HasSubstr("transparent"));
  surface().blend = false, surface().alpha_cutoff = 0.5f, surface().base_color.w = 0.3f;
  EXPECT_THAT(warnings(), HasSubstr("transparent"));
  surface().blend = true, surface().alpha_cutoff = 0.0f;
  EXPECT_EQ(warnings(), "") << "a faint surface is visible";
}

TEST_F(PictureCheck, alphas_of_vertices_and_of_pictures_count) {
  add_box("box", Vec3f(-1), Vec3f(1));
  surface().blend = true;
  std::vector<float>& alphas = std::get<Mesh>(scene.shapes.front()).alphas;
  alphas.assign(8, 0.0f);
  EXPECT_THAT(warnings(), HasSubstr("transparent"));
  alphas.front() = 0.5f;
  EXPECT_EQ(warnings(), "");
  alphas.clear();
  std::get<Mesh>(scene.shapes.front()).uvs.assign(8, Vec2f(0.5f));
  scene.textures.push_back({.width = 1, .height = 1, .rgba = {255, 255, 255, 100}});
  surface().base_color_map.texture = 0;
  surface().blend = false, surface().alpha_cutoff = 0.5f;
  EXPECT_THAT(warnings(), HasSubstr("below the cutoff"));
}

TEST_F(PictureCheck, splats_that_are_all_transparent) {
  Splats splats;
  splats.centers = {{0, 0, 0}, {1, 1, 0}};
  splats.rotations.assign(2, {1, 0, 0, 0});
  splats.deviations.assign(2, Vec3f(0.3f));
  splats.opacities.assign(2, 0.0f);
  splats.harmonics.assign(2, Vec3f(1));
  add("splats", splats);
  scene.materials.front() = splat_material();
  EXPECT_THAT(warnings(), HasSubstr("everything in the scene is transparent"));
}

TEST_F(PictureCheck, light_that_is_too_bright_everywhere) {
  add_box("box", Vec3f(-1), Vec3f(1));
  scene.background.horizon = Vec3f(1e10f), scene.background.zenith = Vec3f(2e10f);
  EXPECT_THAT(warnings(), HasSubstr("frame 0 is overexposed"));
}

TEST_F(PictureCheck, a_camera_that_looks_away) {
  add_box("box", {-1, -1, 5}, {1, 1, 7});
  add_camera({0, 0, 3});
  EXPECT_THAT(warnings(), HasSubstr("behind the viewer"));
  add_box("beside", {50, 0, -5}, {51, 1, -4});
  EXPECT_THAT(warnings(), HasSubstr("nothing lies within the view"));
}

TEST_F(PictureCheck, a_camera_within_an_object) {
  surface().unlit = true;
  add_box("shell", Vec3f(-9), Vec3f(9));
  add_camera(Vec3f(0));
  EXPECT_THAT(warnings(), HasSubstr("'shell' fills the image"));
}

TEST_F(PictureCheck, no_light) {
  add_box("box", {-9, -9, -1}, {9, 9, 0});
  add_camera({0, 0, 5});
  scene.background.horizon = scene.background.zenith = Vec3f(0.0f);
  EXPECT_THAT(warnings(), HasSubstr("there is no light in the scene"));
  Light lamp;
  lamp.color = Vec3f(0.0f), lamp.node = 0;
  scene.lights.push_back(lamp);
  EXPECT_THAT(warnings(), HasSubstr("there is no light in the scene"));
}

TEST_F(PictureCheck, a_subject_of_a_few_pixels) {
  add_box("box", Vec3f(-0.05f), Vec3f(0.05f));
  add_camera({0, 0, 5});
  EXPECT_THAT(warnings(), HasSubstr("next to nothing of its subject"));
}

}  // namespace
}  // namespace lippmann
