// The page follows the scene's file. Each picture shows one state of the file: its views and its depth belong together.
#include <gmock/gmock.h>

#include <array>
#include <chrono>
#include <fstream>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "live/live_passes.hpp"
#include "live/live_stage.hpp"
#include "live/live_support.hpp"
#include "support/error_message.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using test::TempDir;
using testing::HasSubstr;

/// A square board that faces the viewer, and a small one at another depth.
std::string boards(double depth) {
  const auto square = [](double z, double side) {
    std::string text;
    for (const auto& [x, y] : {std::pair{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}})
      text += "v " + std::to_string(side * x) + " " + std::to_string(side * y) + " " + std::to_string(z) + "\n";
    return text;
  };
  return square(0.0, 1.0) + square(depth, 0.3) + "f 1 2 3 4\nf 5 6 7 8\n";
}

/// Replaces a file in one step, as careful exporters do.
void replace(const fs::path& file, const std::string& text) {
  const fs::path part = fs::path(file).replace_extension(".part");
  std::ofstream(part) << text;
  fs::rename(part, file);
}

RenderParams params_of(const fs::path& file) {
  RenderParams params = test::small_room();
  params.scene.name = file.string();
  params.sampling.integrator = Integrator::kWhitted;
  return params;
}

using Pictures = std::pair<std::string, std::string>;  // views and depth

/// Returns the picture of a state; nullopt if a newer one has replaced it.
std::optional<Pictures> shown(const LiveScene& scene, const Json& state) {
  const std::uint64_t id = state["picture"]["id"].get<std::uint64_t>();
  const Bytes views = scene.picture("views", id), depth = scene.picture("depth", id);
  if (!views || !depth) return std::nullopt;
  return Pictures{*views, *depth};
}

std::uint64_t version_of(const LiveScene& scene) {
  return scene.state_after(0, std::chrono::milliseconds(0))["version"].get<std::uint64_t>();
}

/// Returns all final pictures until the scene is at rest with a version of at least `version`, the last one last.
std::vector<Pictures> finals_until_rest(const LiveScene& scene, std::uint64_t version = 1) {
  std::vector<Pictures> all;
  test::wait_for(scene, [&](const Json& state) {
    const Json& picture = state["picture"];
    if (picture.is_null() || picture["pass"] != "final") return false;
    if (const auto now = shown(scene, state)) all.push_back(*now);
    return picture["version"] == state["version"] && state["version"] >= version;
  });
  return all;
}

Pictures at_rest(const LiveScene& scene) { return finals_until_rest(scene).back(); }

TEST(LiveFile, an_edited_file_is_rendered_again) {
  const TempDir dir;
  const fs::path file = dir.path() / "boards.obj";
  replace(file, boards(0.8));
  const auto scene = test::live_scene(params_of(file));
  const Pictures before = at_rest(*scene);
  replace(file, boards(-0.25));
  const Pictures after = finals_until_rest(*scene, version_of(*scene) + 1).back();
  EXPECT_NE(after, before);
  EXPECT_EQ(after, at_rest(*test::live_scene(params_of(file))));
}

TEST(LiveFile, pictures_never_mix_two_states) {
  const TempDir dir;
  const fs::path file = dir.path() / "boards.obj";
  const std::array<double, 2> depths{0.8, -0.25};
  const std::array<std::string, 2> lights{"none", "#ffffff"};
  RenderParams params = params_of(file);
  std::set<Pictures> known;
  for (const double depth : depths)
    for (const std::string& light : lights) {
      replace(file, boards(depth));
      params.scene.environment = light;
      known.insert(at_rest(*test::live_scene(params)));
    }
  ASSERT_EQ(known.size(), 4u);
  const auto scene = test::live_scene(params);
  for (int i = 0; i < 8; ++i) {
    replace(file, boards(depths[i % 2]));
    scene->change({{"settings", {{"environment", lights[i / 2 % 2]}}}});
    for (const Pictures& picture : finals_until_rest(*scene, version_of(*scene))) EXPECT_TRUE(known.contains(picture)) << i;
  }
}

TEST(LiveFile, a_damaged_file_leaves_the_picture) {
  const TempDir dir;
  const fs::path file = dir.path() / "boards.obj";
  replace(file, boards(0.8));
  const auto scene = test::live_scene(params_of(file));
  const Pictures before = at_rest(*scene);
  replace(file, "v 1 2\nf 1 2 3\n");
  const Json broken = test::wait_for(*scene, [](const Json& state) { return state["error"] != ""; });
  EXPECT_THAT(broken["error"].get<std::string>(), HasSubstr("boards.obj"));
  EXPECT_EQ(shown(*scene, broken), before);
  scene->change({{"settings", {{"zoom", "1.5"}}}});
  const Json changed = test::wait_for(*scene, [](const Json& state) { return state["error"] != ""; });
  EXPECT_EQ(shown(*scene, changed), before);
  replace(file, boards(-0.25));
  scene->change({{"settings", {{"zoom", nullptr}}}});
  test::wait_for_rest(*scene);
  EXPECT_EQ(at_rest(*scene), at_rest(*test::live_scene(params_of(file))));
}

TEST(LiveFile, a_file_that_changes_while_read_is_read_again) {
  const TempDir dir;
  const fs::path file = dir.path() / "boards.obj";
  replace(file, boards(0.8) + "l 1 2\n");
  const ResolvedJob job(params_of(file));
  Context changes, idle;
  // The loader warns about the line after it has read the file.
  bool is_edited = false;
  changes.warn = [&](std::string_view) {
    if (!std::exchange(is_edited, true)) replace(file, boards(-0.25));
  };
  LiveStage live(job, changes), fresh(job, idle);
  const Vec2i size{16, 16};
  EXPECT_EQ(depth_picture(live, live.facts(), size, 0).rgb, depth_picture(fresh, fresh.facts(), size, 0).rgb);
  replace(file, boards(0.8) + "l 1 2\n");
  std::string edits;  // the file grows, because times of files may be equal within some milliseconds
  changes.warn = [&](std::string_view) { replace(file, boards(0.8) + "l 1 2\n" + (edits += "#")); };
  EXPECT_THAT(test::error_message([&] { live.set(job); }), HasSubstr("boards.obj: changes while it is read"));
}

}  // namespace
}  // namespace lippmann
