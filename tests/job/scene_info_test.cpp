#include "job/scene_info.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

TEST(SceneInfo, small_scene_is_counted_and_measured) {
  const test::TempDir dir;
  RenderParams params;
  params.scene.name = (dir / "two.dat").string();
  std::ofstream(params.scene.name) << R"(BEGIN_SCENE
RESOLUTION 8 8
CAMERA
  ZOOM 1.0 ASPECTRATIO 1.0 ANTIALIASING 0 RAYDEPTH 2
  CENTER 0 0 -10 VIEWDIR 0 0 1 UPDIR 0 1 0
END_CAMERA
LIGHT CENTER 0 5 -5 RAD 0.1 COLOR 1 1 1
TEXDEF grey AMBIENT 0.1 DIFFUSE 0.9 SPECULAR 0 OPACITY 1 COLOR 0.5 0.5 0.5 TEXFUNC 0
SPHERE CENTER -1 0 0 RAD 1 grey
SPHERE CENTER 1 0 0 RAD 1 grey
END_SCENE
)";
  const SceneInfo info = describe_scene(ResolvedJob(params), Context{});
  EXPECT_EQ(info.spheres, 2u);
  EXPECT_EQ(info.triangles, 0u);
  EXPECT_EQ(info.lights, 1u);
  EXPECT_EQ(info.frames, 1);
  EXPECT_EQ(info.moving_instances, 0u);
  EXPECT_NEAR(info.bounds.size().x, 4.0f, 1e-5f);
  EXPECT_NEAR(info.array.viewing_distance, 10.0f, 1e-4f) << "the array goes through the middle of the spheres";
  EXPECT_THAT(to_text(info), testing::HasSubstr("2 spheres"));
  EXPECT_EQ(to_json(info)["spheres"], 2);
}

TEST(SceneInfo, several_cameras_are_listed) {
  SceneInfo info;
  info.cameras = 2;
  info.notes.camera_names = {"Front", "Side"};
  EXPECT_THAT(to_text(info), testing::HasSubstr("Front (0), Side (1); --camera chooses"));
}

TEST(SceneInfo, keys_on_frames_are_reported) {
  SceneInfo info;
  EXPECT_THAT(to_text(info), testing::HasSubstr("none: a still scene"));
  info.animations = {"Walk"}, info.animation = 0, info.frames_per_second = 24.0;
  EXPECT_THAT(to_text(info), testing::HasSubstr("at 24 fps, 0.0 s; all keys of the file lie on frames;"));
  info.keys_on_frames = false;
  EXPECT_THAT(to_text(info), testing::HasSubstr("some keys of the file lie between frames (see --fps)"));
}

TEST(SceneInfo, moving_instances_are_reported) {
  RenderParams params;
  params.scene.name = "gears";
  const SceneInfo info = describe_scene(ResolvedJob(params), Context{});
  EXPECT_GE(info.frames, 400);
  EXPECT_GT(info.moving_instances, 0u);
  EXPECT_FALSE(info.bounds.empty());
}

}  // namespace
}  // namespace lippmann
