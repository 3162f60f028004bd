#include "job/scene_light.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "image/exr.hpp"
#include "image/png.hpp"
#include "job/job_scene.hpp"
#include "lippmann/core/error.hpp"
#include "scene/studio_light.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

using testing::HasSubstr;

class SceneLight : public testing::Test {
 protected:
  RenderParams params_of(const std::string& name, const std::string& contents) const {
    std::ofstream(dir_ / name, std::ios::binary) << contents;
    RenderParams params;
    params.scene.name = (dir_ / name).string();
    params.sampling.integrator = Integrator::kPath;
    return params;
  }

  RenderParams plain_file() const { return params_of("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"); }

  test::TempDir dir_;
};

std::string gltf_of(const std::string& nodes, const std::string& extensions) {
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0)" + std::string(nodes.empty() ? "" : ",1") +
         R"(]}],"nodes":[{"mesh":0})" + nodes + "]" + extensions +
         R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
 "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}],
 "bufferViews":[{"buffer":0,"byteLength":36}],
 "buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})";
}

const char* const kLampNode = R"(,{"extensions":{"KHR_lights_punctual":{"light":0}}})";
const char* const kLamp = R"(,"extensionsUsed":["KHR_lights_punctual"],
 "extensions":{"KHR_lights_punctual":{"lights":[{"type":"directional"}]}})";

TEST_F(SceneLight, studio_lights_files_without_light) {
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
      "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  for (const RenderParams& params : {plain_file(), params_of("a.gltf", gltf_of("", "")), params_of("a.ply", ply)}) {
    const auto [scene, notes] = load_scene_of(ResolvedJob(params), {});
    ASSERT_TRUE(scene.background.map) << params.scene.name;
    EXPECT_EQ(scene.background.map->strength, 1.0f);
    EXPECT_TRUE(scene.lights.empty());
    EXPECT_EQ(notes.light, "The built-in studio lights the scene, because the file has no lamps and no surroundings.");
  }
}

TEST_F(SceneLight, dim_studio_surrounds_lamps) {
  const auto [scene, notes] = load_scene_of(ResolvedJob(params_of("a.gltf", gltf_of(kLampNode, kLamp))), {});
  ASSERT_EQ(scene.lights.size(), 1u);
  ASSERT_TRUE(scene.background.map);
  EXPECT_EQ(scene.background.map->strength, kDimStudio);
  EXPECT_THAT(notes.light, HasSubstr("at 8 % of its brightness, because the file has no surroundings"));
}

TEST_F(SceneLight, studio_is_scaled_and_rotated) {
  RenderParams params = plain_file();
  const float rotation = load_scene_of(ResolvedJob(params), {}).scene.background.map->rotation;
  params.scene.environment_strength = 3.0f;
  params.scene.environment_rotation_deg = 90.0f;
  const Scene scene = load_scene_of(ResolvedJob(params), {}).scene;
  EXPECT_EQ(scene.background.map->strength, 3.0f);
  EXPECT_FLOAT_EQ(scene.background.map->rotation, rotation + 0.5f * kPi);
}

TEST_F(SceneLight, other_formats_keep_their_light) {
  RenderParams whitted = plain_file();
  whitted.sampling.integrator = Integrator::kWhitted;
  const Scene scene = load_scene_of(ResolvedJob(whitted), {}).scene;
  EXPECT_FALSE(scene.background.map);
  EXPECT_EQ(scene.lights.size(), 1u) << "the default light";
  EXPECT_FALSE(load_scene_of(ResolvedJob(params_of("a.nff", "l 3 4 5\ns 0 0 0 1\n")), {}).scene.background.map);
  RenderParams teapot;
  teapot.scene.name = "teapot";
  teapot.sampling.integrator = Integrator::kPath;
  EXPECT_FALSE(load_scene_of(ResolvedJob(teapot), {}).scene.background.map);
}

TEST_F(SceneLight, dark_scenes_of_other_formats_get_light) {
  RenderParams params = params_of("dark.nff", "s 0 0 0 1\n");
  EXPECT_TRUE(load_scene_of(ResolvedJob(params), {}).scene.background.map) << "the studio, for paths";
  params.sampling.integrator = Integrator::kWhitted;
  EXPECT_EQ(load_scene_of(ResolvedJob(params), {}).scene.lights.size(), 1u);
  const Scene blue = load_scene_of(ResolvedJob(params_of("blue.nff", "b 0.1 0.2 0.3\ns 0 0 0 1\n")), {}).scene;
  EXPECT_FALSE(blue.background.map) << "paths find its background";
  EXPECT_EQ(blue.background.zenith, Vec3f(0.1f, 0.2f, 0.3f));
}

TEST_F(SceneLight, environment_overrides_the_default) {
  RenderParams params = plain_file();
  params.scene.environment = "none";
  Scene scene = load_scene_of(ResolvedJob(params), {}).scene;
  EXPECT_FALSE(scene.background.map);
  EXPECT_EQ(scene.background.zenith, Vec3f(0.0f));
  params.sampling.integrator = Integrator::kWhitted;
  EXPECT_TRUE(load_scene_of(ResolvedJob(params), {}).scene.lights.empty());

  params.scene.environment = "studio";
  params.scene.name = "teapot";
  const JobScene in_studio = load_scene_of(ResolvedJob(params), {});
  EXPECT_TRUE(in_studio.scene.background.map);
  EXPECT_EQ(in_studio.notes.light, "The built-in studio lights the scene, as requested by --environment.");

  params.scene.environment_strength = 2.0f;
  params.scene.environment = "0.5,0.25,1";
  scene = load_scene_of(ResolvedJob(params), {}).scene;
  EXPECT_EQ(scene.background.horizon, Vec3f(1.0f, 0.5f, 2.0f));
  EXPECT_EQ(scene.background.zenith, scene.background.horizon);
  params.scene.environment = "#ff00bc";
  scene = load_scene_of(ResolvedJob(params), {}).scene;
  EXPECT_NEAR(scene.background.zenith.x, 2.0f, 1e-6f);
  EXPECT_EQ(scene.background.zenith.y, 0.0f);
  EXPECT_NEAR(scene.background.zenith.z, 2.0f * 0.50289f, 1e-4f) << "code 188 of sRGB";
}

TEST_F(SceneLight, panorama_is_scaled_by_its_factor) {
  Image panorama(8, 4, 3);
  std::fill(panorama.data.begin(), panorama.data.end(), 0.5f);
  write_exr(dir_ / "sky.exr", std::vector{film_layer(panorama)});
  RenderParams params = plain_file();
  params.scene.environment = (dir_ / "sky.exr").string();
  params.scene.environment_strength = 4.0f;
  const Scene scene = load_scene_of(ResolvedJob(params), {}).scene;
  ASSERT_TRUE(scene.background.map);
  EXPECT_EQ(scene.background.map->strength, 4.0f);
}

TEST_F(SceneLight, invalid_colours_and_files_are_refused) {
  write_png(dir_ / "codes.png", Image8{4, 2, std::vector<unsigned char>(24)});
  for (const char* file : {"codes.png", "missing.hdr"}) {
    RenderParams params = plain_file();
    params.scene.environment = (dir_ / file).string();
    try {
      load_scene_of(ResolvedJob(params), {});
      FAIL() << file;
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), HasSubstr(file));
      EXPECT_EQ(error.exit_code(), 1);
    }
  }
}

TEST(EnvironmentChoice, invalid_colour_is_refused) {
  for (const char* value : {"#12345", "#12345g", "1,2", "1,2,3,4", "1,2,-3", ",,"})
    EXPECT_THROW(read_environment_choice(value, "--environment"), Error) << value;
  for (const char* value : {"none", "studio", "#123456", "1,2,3e-1", "a,b.hdr", "sky.exr"})
    EXPECT_EQ(read_environment_choice(value, "--environment"), value);
}

TEST(EnvironmentChoice, other_text_is_a_file) {
  for (const char* value : {"", "none", "studio", "#123456", "1,2,3"}) EXPECT_FALSE(environment_is_file(value)) << value;
  for (const char* value : {"sky.hdr", "studio.exr", "a,b.hdr"}) EXPECT_TRUE(environment_is_file(value)) << value;
}

}  // namespace
}  // namespace lippmann
