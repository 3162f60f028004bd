#include "job/job_scene.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "job/params_table.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/scene/timeline.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

class JobScene : public testing::Test {
 protected:
  RenderParams params_of(const std::string& name, const std::string& contents) const {
    std::ofstream(dir_ / name, std::ios::binary) << contents;
    RenderParams params;
    params.scene.name = (dir_ / name).string();
    return params;
  }

  test::TempDir dir_;
};

TEST_F(JobScene, light_scale_multiplies_lamps) {
  RenderParams params = params_of("a.nff", "l 1 2 3 0.5 0.25 1\ns 0 0 0 1\n");
  params.scene.light_scale = 4.0f;
  EXPECT_EQ(load_scene_of(ResolvedJob(params), {}).scene.lights.at(0).color, Vec3f(2.0f, 1.0f, 4.0f));
}

constexpr const char* kTwoCameras = R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0,1,2]}],
 "nodes":[{"camera":0,"translation":[0,0,5]},{"camera":1,"translation":[0,0,9]},{"mesh":0}],
 "cameras":[{"name":"Front","type":"perspective","perspective":{"yfov":0.5,"znear":0.1}},
            {"name":"Side","type":"perspective","perspective":{"yfov":0.7,"znear":0.1}}],
 "meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
 "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}],
 "bufferViews":[{"buffer":0,"byteLength":36}],
 "buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})";

TEST_F(JobScene, camera_is_chosen_by_name_or_index) {
  RenderParams params = params_of("a.gltf", kTwoCameras);
  EXPECT_EQ(load_scene_of(ResolvedJob(params), {}).scene.cameras.at(0).name, "Front");
  for (const char* camera : {"Side", "1"}) {
    params.scene.camera = camera;
    EXPECT_EQ(load_scene_of(ResolvedJob(params), {}).scene.cameras.at(0).name, "Side") << camera;
  }
}

TEST_F(JobScene, unknown_camera_lists_the_known_ones) {
  RenderParams params = params_of("a.gltf", kTwoCameras);
  params.scene.camera = "Sied";
  try {
    load_scene_of(ResolvedJob(params), {});
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::AllOf(testing::HasSubstr("did you mean 'Side'?"),
                                             testing::HasSubstr("accepted: Front (0), Side (1)")));
    EXPECT_EQ(error.exit_code(), 2);
  }
}

TEST_F(JobScene, camera_names_are_in_the_files_order) {
  RenderParams params = params_of("a.gltf", kTwoCameras);
  params.scene.camera = "Side";
  EXPECT_THAT(load_scene_of(ResolvedJob(params), {}).notes.camera_names, testing::ElementsAre("Front", "Side"));
}

TEST_F(JobScene, up_axis_of_the_file_becomes_y) {
  const std::pair<UpAxis, const char*> axes[] = {{UpAxis::kX, "3 0 0"},       {UpAxis::kY, "0 3 0"},
                                                 {UpAxis::kZ, "0 0 3"},       {UpAxis::kMinusX, "-3 0 0"},
                                                 {UpAxis::kMinusY, "0 -3 0"}, {UpAxis::kMinusZ, "0 0 -3"}};
  for (const auto& [up, center] : axes) {
    RenderParams params = params_of("a.nff", std::string("s ") + center + " 1\n");
    params.scene.up = up;
    const Scene scene = load_scene_of(ResolvedJob(params), {}).scene;
    const Vec3f at = finite_bounds(scene, evaluate(scene, 0.0)).center();
    EXPECT_LT(glm::length(at - Vec3f(0, 3, 0)), 1e-5f) << center;
  }
}

TEST_F(JobScene, rotated_scene_keeps_its_camera) {
  const std::string text = "v from 0 -8 0 at 0 0 0 up 0 0 1 angle 30\nl 0 -9 9\ns 0 0 0 1\n";
  RenderParams params = params_of("a.nff", text);
  params.scene.up = UpAxis::kZ;
  const Scene scene = load_scene_of(ResolvedJob(params), {}).scene;
  const Affine3f world_from_camera = evaluate(scene, 0.0).of(scene.cameras.at(0).node);
  EXPECT_LT(glm::length(world_from_camera.translation - Vec3f(0, 0, 8)), 1e-5f);
  EXPECT_LT(glm::length(world_from_camera.linear[1] - Vec3f(0, 1, 0)), 1e-5f);
}

ResolvedJob with_defaults(const std::string& scene, const Sampling& sampling = {}, ReuseChoice reuse = ReuseChoice::kAuto) {
  RenderParams params;
  params.scene.name = scene;
  params.sampling = sampling;
  params.reuse.choice = reuse;
  return ResolvedJob(params);
}

TEST(ResolvedJob, is_completed_once) {
  for (const char* to : {"", "rgbd", "hci"}) {
    RenderParams asked;
    asked.scene.name = "plain.obj", asked.output.pictures.to = to;
    const ResolvedJob job(asked), again(job.params());
    for (const ParamInfo& info : params_table())
      EXPECT_EQ(info.get(job.params()), info.get(again.params())) << info.name << ", to " << to;
  }
}

TEST(ResolvedJob, physical_files_are_path_traced_by_default) {
  EXPECT_EQ(with_defaults("plain.obj").sampling().integrator, Integrator::kPath);
  EXPECT_EQ(samples_per_pixel(with_defaults("plain.obj").sampling()), 16);
  EXPECT_EQ(samples_per_pixel(with_defaults("plain.obj", {.integrator = Integrator::kPath}).sampling()), 16);
  EXPECT_EQ(samples_per_pixel(with_defaults("plain.obj", {.spp = 2}).sampling()), 2);
  EXPECT_EQ(with_defaults("plain.obj", {.integrator = Integrator::kWhitted}).sampling().integrator, Integrator::kWhitted);
  EXPECT_EQ(with_defaults("plain.obj", {}, ReuseChoice::kInterpolate).sampling().integrator, Integrator::kWhitted);
  EXPECT_EQ(with_defaults("teapot").sampling().integrator, Integrator::kWhitted);
}

}  // namespace
}  // namespace lippmann
