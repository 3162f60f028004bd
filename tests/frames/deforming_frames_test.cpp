#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "frames/made_frames.hpp"
#include "job/job_scene.hpp"
#include "job/scene_info.hpp"
#include "lippmann/core/error.hpp"
#include "scene/gltf/gltf_builder.hpp"
#include "support/temp_dir.hpp"

namespace lippmann::test {
namespace {

using testing::HasSubstr;

/// Two strips of 8 squares: a skin bends the first, a morph target deforms the second. The animation "Rest" is empty.
GltfBuilder strips() {
  GltfBuilder b;
  std::vector<Vec3f> corners, lifted;
  std::vector<Vec4f> weights;
  std::vector<std::uint8_t> joints;
  for (int row = 0; row <= 8; ++row)
    for (const float x : {-0.5f, 0.5f}) {
      const float height = static_cast<float>(row) / 8.0f;
      corners.push_back({x, 2.0f * height - 1.0f, 0});
      lifted.push_back({0, 0, height * height});
      weights.push_back({1.0f - height, height, 0, 0});
      joints.insert(joints.end(), {0, 1, 0, 0});
    }
  const int positions = b.add_accessor(corners), influences = b.add_accessor(weights), lift = b.add_accessor(lifted);
  const int hinges = b.add_accessor(joints, kUnsignedByte, "VEC4", corners.size());
  const int skinned =
      b.add_mesh({{"attributes", {{"POSITION", positions}, {"JOINTS_0", hinges}, {"WEIGHTS_0", influences}}}, {"mode", 5}});
  const int morphing =
      b.add_mesh({{"attributes", {{"POSITION", positions}}}, {"targets", {{{"POSITION", lift}}}}, {"mode", 5}});
  b.add("skins", {{"joints", {2, 3}}});
  b.add_node({{"name", "skinned strip"}, {"mesh", skinned}, {"skin", 0}});
  b.add_node({{"mesh", morphing}, {"translation", {1.5, 0, 0}}});
  b.add_node({{"translation", {-1, 0, 0}}});
  b.add_node({{"translation", {-1, 0, 0}}});
  const int times = b.add_accessor(std::vector<float>{0, 2}), grown = b.add_accessor(std::vector<float>{0, 1});
  const int bent = b.add_accessor(std::vector<Vec3f>{{-1, 0, 0}, {0, 0.5f, 1}});
  const Json samplers = {{{"input", times}, {"output", bent}}, {{"input", times}, {"output", grown}}};
  b.add("animations", {{"name", "Bend"},
                       {"channels",
                        {{{"sampler", 0}, {"target", {{"node", 3}, {"path", "translation"}}}},
                         {{"sampler", 1}, {"target", {{"node", 1}, {"path", "weights"}}}}}},
                       {"samplers", samplers}});
  b.add("animations", {{"name", "Rest"}, {"channels", Json::array()}, {"samplers", Json::array()}});
  return b;
}

class DeformingFrames : public testing::Test {
 protected:
  DeformingFrames() {
    const Contents glb = strips().glb();
    std::ofstream file(dir_ / "strips.glb", std::ios::binary);
    file.write(reinterpret_cast<const char*>(glb.data()), static_cast<std::streamsize>(glb.size()));
  }

  RenderParams params(ReuseChoice reuse, std::optional<int> keyframes = {}, std::optional<Integrator> integrator = {}) const {
    RenderParams params = small_scene();
    params.scene.name = (dir_ / "strips.glb").string();
    params.scene.fps = 4.0;
    params.sampling.integrator = integrator;
    params.reuse.choice = reuse;
    params.reuse.keyframes = keyframes;
    return params;
  }

  TempDir dir_;
};

void expect_the_films(const MadeFrames& made, const MadeFrames& traced) {
  EXPECT_NE(traced.film(0), traced.film(7));
  EXPECT_EQ(made.films(), traced.films());
}

TEST_F(DeformingFrames, of_paths_equal_traced_frames) {
  expect_the_films(make_frames(params(ReuseChoice::kAuto, 8), frames_from(0, 7), 3),
                   make_frames(params(ReuseChoice::kNone), frames_from(0, 7), 1));
}

TEST_F(DeformingFrames, with_copied_pixels_equal_traced_frames) {
  expect_the_films(make_frames(params(ReuseChoice::kCopy, 8, Integrator::kWhitted), frames_from(0, 7), 3),
                   make_frames(params(ReuseChoice::kNone, {}, Integrator::kWhitted), frames_from(0, 7), 1));
}

TEST_F(DeformingFrames, of_a_part_equal_the_whole) {
  const MadeFrames whole = make_frames(params(ReuseChoice::kAuto), frames_from(0, 7));
  for (const auto& [number, film] : make_frames(params(ReuseChoice::kAuto), frames_from(5, 7)).films())
    EXPECT_EQ(film, whole.film(number)) << number;
}

TEST_F(DeformingFrames, are_not_interpolated) {
  try {
    make_frames(params(ReuseChoice::kInterpolate), {0});
    FAIL() << "interpolated";
  } catch (const Error& error) {
    EXPECT_EQ(error.where(), "reuse");
    EXPECT_THAT(error.what(), HasSubstr("interpolated frames need rigid objects, and 'skinned strip' changes its shape"));
  }
}

TEST_F(DeformingFrames, follow_the_chosen_animation) {
  RenderParams rest = params(ReuseChoice::kNone);
  EXPECT_EQ(load_scene_of(ResolvedJob(rest), {}).scene.timeline.frame_count, 8);
  for (const char* animation : {"Rest", "1"}) {
    rest.scene.animation = animation;
    EXPECT_EQ(load_scene_of(ResolvedJob(rest), {}).scene.timeline.frame_count, 1) << animation;
  }
  EXPECT_THAT(to_text(describe_scene(ResolvedJob(rest), {})), HasSubstr("shown: Rest (1); others: Bend (0)"));
}

TEST_F(DeformingFrames, of_unknown_animations_are_refused) {
  RenderParams jump = params(ReuseChoice::kNone);
  jump.scene.animation = "Jump";
  try {
    load_scene_of(ResolvedJob(jump), {});
    FAIL() << "found";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("'Jump' is not in the file; accepted: Bend (0), Rest (1)"));
  }
}

}  // namespace
}  // namespace lippmann::test
