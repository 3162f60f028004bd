// glTF scenes whose meshes change their shape, and whose file holds several animations, through the command line.
#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "cli/tool.hpp"
#include "scene/gltf/gltf_builder.hpp"

namespace lippmann::test {
namespace {

using testing::HasSubstr;

/// A strip of 8 squares whose upper end hangs on a joint, beside one that morphs; two seconds of "Bend", and "Rest".
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

class DeformingScene : public testing::Test {
 protected:
  DeformingScene() {
    const Contents glb = strips().glb();
    std::ofstream file(dir / "strips.glb", std::ios::binary);
    file.write(reinterpret_cast<const char*>(glb.data()), static_cast<std::streamsize>(glb.size()));
  }

  Words job(const std::string& folder, const Words& more = {}) {
    return Words{"render", "strips.glb", "--lenses", "16", "--fps", "4", "--output", folder} + more;
  }

  TempDir dir;
};

TEST_F(DeformingScene, exact_reuse_gives_the_bytes_of_tracing_every_frame) {
  const Files traced = rendered(dir, job("traced", {"--reuse", "none", "--threads", "1"}), "traced");
  ASSERT_EQ(traced.size(), 8u);
  EXPECT_NE(traced.at("frame_0000.png"), traced.at("frame_0007.png"));
  EXPECT_EQ(rendered(dir, job("exact", {"--reuse", "exact", "--keyframes", "8", "--threads", "3"}), "exact"), traced);
}

TEST_F(DeformingScene, copied_pixels_have_the_bytes_of_tracing_every_frame) {
  const Words whitted{"--integrator", "whitted"};
  const Files traced = rendered(dir, job("traced", whitted + Words{"--reuse", "none", "--threads", "1"}), "traced");
  ASSERT_EQ(traced.size(), 8u);
  EXPECT_NE(traced.at("frame_0000.png"), traced.at("frame_0007.png"));
  EXPECT_EQ(rendered(dir, job("copy", whitted + Words{"--reuse", "copy", "--keyframes", "8", "--threads", "3"}), "copy"),
            traced);
}

TEST_F(DeformingScene, frames_of_a_part_have_the_bytes_of_the_whole) {
  const Files whole = rendered(dir, job("whole"), "whole");
  for (const auto& [name, bytes] : rendered(dir, job("part", {"--frames", "5-7"}), "part"))
    EXPECT_EQ(bytes, whole.at(name)) << name;
}

TEST_F(DeformingScene, animation_is_chosen_by_name_or_index) {
  EXPECT_EQ(rendered(dir, job("name", {"--animation", "Rest"}), "name").size(), 1u);
  EXPECT_EQ(rendered(dir, job("index", {"--animation", "1"}), "index").size(), 1u);
}

TEST_F(DeformingScene, unknown_animation_is_an_error_that_lists_them) {
  const RunResult result = run_tool(dir, job("none", {"--animation", "Jump"}));
  EXPECT_NE(result.exit_code, 0);
  EXPECT_THAT(result.err, HasSubstr("--animation: 'Jump' is not in the file; accepted: Bend (0), Rest (1)"));
}

TEST_F(DeformingScene, info_lists_the_animations) {
  const RunResult result = run_tool(dir, {"info", "strips.glb", "--animation", "Rest"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("shown: Rest (1); others: Bend (0)"));
}

TEST_F(DeformingScene, interpolated_frames_are_refused) {
  const RunResult result = run_tool(dir, job("forward", {"--reuse", "forward"}));
  EXPECT_NE(result.exit_code, 0);
  EXPECT_THAT(result.err,
              HasSubstr("--reuse: interpolated frames need things to keep their shape, and 'skinned strip' changes it"));
}

}  // namespace
}  // namespace lippmann::test
