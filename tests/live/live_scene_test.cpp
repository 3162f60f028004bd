#include "live/live_scene.hpp"

#include <gmock/gmock.h>

#include <chrono>
#include <fstream>

#include "job/job_file.hpp"
#include "live/live_support.hpp"
#include "support/error_message.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

using Json = nlohmann::ordered_json;
using test::TempDir;
using testing::HasSubstr;

/// A slow render: 1024 x 256 pixels with 1024 samples are 270 million paths. A change can interrupt it between two
/// tiles.
RenderParams slow_room() {
  RenderParams params = test::small_room();
  params.optics.size = {1024, 256};
  params.sampling.integrator = Integrator::kPath;
  params.sampling.spp = 1024;
  return params;
}

/// Expects that the final live picture after the changes equals a render of the saved job.
void expect_render(const RenderParams& params, const Json& changes) {
  const TempDir dir;
  const auto scene = test::live_scene(params, dir.path() / "job.toml");
  scene->change(changes);
  const Json state = test::wait_for_rest(*scene);
  EXPECT_EQ(state["error"], "");
  const std::filesystem::path job = scene->save();
  RenderParams saved;
  read_job(job, saved);
  const Image8 rendered = test::views_of_render(saved, dir.path() / "render", changes.value("frame", 0));
  const Image8 shown = test::shown_picture(*scene, "views");
  ASSERT_FALSE(shown.rgb.empty());
  EXPECT_EQ(shown.width, rendered.width);
  EXPECT_EQ(shown.rgb, rendered.rgb);
}

TEST(LiveScene, views_at_rest_equal_the_saved_jobs_render) {
  expect_render(test::small_room(), {{"settings", {{"orbit", "20,10"}, {"zoom", "1.3"}, {"exposure", "0.7"}}}, {"frame", 7}});
}

TEST(LiveScene, denoised_paths_equal_the_render) {
  RenderParams params = test::small_room();
  params.sampling.integrator = Integrator::kPath;
  params.sampling.spp = 24;
  expect_render(params, {{"settings", {{"focus", "8.5"}, {"tone", "neutral"}}}, {"frame", 3}});
}

TEST(LiveScene, lenses_and_cones_equal_the_render) {
  RenderParams params = test::small_room();
  params.optics = {};
  params.optics.kind = OpticsKind::kLenticular;
  params.optics.lenses = {12, 0};
  params.optics.lens_pixels = {4, 0};
  expect_render(params, {{"settings", {{"view-angle", "35"}}}});
}

std::string calibrated_panel(const TempDir& dir) {
  const std::filesystem::path file = dir.path() / "visual.json";
  std::ofstream(file) << R"({"pitch":52.3,"slope":-7.2,"center":0.37,"DPI":324,"screenW":60,"screenH":45,"viewCone":40})";
  return file.string();
}

TEST(LiveScene, native_frames_equal_the_render) {
  const TempDir dir;
  RenderParams params = test::small_room();
  params.optics = {};
  params.optics.display = calibrated_panel(dir);
  params.output.pictures.layout = PictureLayout::kNative;
  expect_render(params, {{"settings", {{"orbit", "10"}}}});
  const auto scene = test::live_scene(params);
  test::wait_for_rest(*scene);
  EXPECT_EQ(test::shown_picture(*scene, "panel").width, 60);
}

TEST(LiveScene, reports_its_panel) {
  const TempDir dir;
  RenderParams params = test::small_room();
  params.optics = {};
  params.optics.display = calibrated_panel(dir);
  params.optics.views = {4, 1};
  params.optics.size = {64, 16};
  LiveScene scene(params, dir.path() / "job.toml", [](std::string_view) {}, {ViewFilter::kGaussian, 0.8});
  scene.require_playable();
  EXPECT_EQ(scene.display()["pixels"], (Json{60, 45}));
  EXPECT_EQ(scene.display()["filter"], "gaussian");
  scene.change({{"settings", {{"display", ""}, {"optics", "multiview"}}}});
  test::wait_for(scene, [](const Json& state) { return state["display"].is_null(); });
  const auto of_no_display = test::live_scene(test::small_room());
  EXPECT_TRUE(of_no_display->display().is_null());
}

TEST(LiveScene, several_rows_have_no_panel) {
  RenderParams params = test::small_room();
  params.optics.views = {2, 2};
  params.optics.camera_grid = true;
  params.optics.size = {64, 64};
  const auto scene = test::live_scene(params);
  EXPECT_THAT(test::error_message([&] { scene->require_playable(); }), HasSubstr("2x2 views"));
}

TEST(LiveScene, hexagonal_lenses_equal_the_render) {
  RenderParams params = test::small_room();
  params.optics = {};
  params.optics.kind = OpticsKind::kMicrolens;
  params.optics.packing = LensPacking::kHexagonal;
  params.optics.size = {48, 48};
  params.optics.lens_pixels = {6, 0};
  expect_render(params, {{"settings", {{"orbit", "-15"}}}});
}

TEST(LiveScene, a_coarse_picture_with_depth_comes_first) {
  const auto scene = test::live_scene(slow_room());
  const Json state = test::wait_for(*scene, [](const Json& now) { return !now["picture"].is_null(); });
  EXPECT_EQ(state["picture"]["depth"], true);
  EXPECT_FALSE(test::shown_picture(*scene, "depth").rgb.empty());
  EXPECT_EQ(scene->picture("views", 12345), nullptr);
}

TEST(LiveScene, changes_cancel_running_work) {
  const auto scene = test::live_scene(slow_room());
  test::wait_for(*scene, [](const Json& now) { return now["pass"] == "final"; });
  const auto start = std::chrono::steady_clock::now();
  scene->change({{"settings", {{"integrator", "whitted"}, {"spp", "1"}}}});
  test::wait_for_rest(*scene);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::minutes(2));
}

TEST(LiveScene, failing_settings_are_reported_and_not_saved) {
  const TempDir dir;
  const auto scene = test::live_scene(test::small_room(), dir.path() / "job.toml");
  test::wait_for_rest(*scene);
  scene->change({{"settings", {{"focus", "no such thing"}}}});
  const Json state = test::wait_for(*scene, [](const Json& now) { return now["error"] != ""; });
  EXPECT_THAT(state["error"].get<std::string>(), HasSubstr("focus"));
  EXPECT_THAT(test::error_message([&] { scene->save(); }), HasSubstr("focus"));
  EXPECT_THAT(test::error_message([&] { scene->render(true); }), HasSubstr("focus"));
  EXPECT_TRUE(std::filesystem::is_empty(dir.path()));
  scene->change({{"settings", {{"focus", nullptr}}}});
  EXPECT_EQ(test::wait_for_rest(*scene)["error"], "");
}

TEST(LiveScene, changes_are_atomic) {
  const auto scene = test::live_scene(test::small_room());
  for (const Json& bad : {Json(3), Json{{"settings", {{"zoom", "2"}, {"spp", "x"}}}}, Json{{"settings", {{"zoom", 2}}}},
                          Json{{"frame", 100000}}, Json{{"frame", "1"}}, Json{{"output", "x"}}, Json{{"plane_mm", 1e9}}})
    EXPECT_NE(test::error_message([&] { scene->change(bad); }), "(no Error)") << bad;
  EXPECT_EQ(scene->state_after(0, std::chrono::milliseconds(0))["settings"]["zoom"], "1");
}

TEST(LiveScene, the_plane_moves_to_a_depth) {
  const auto scene = test::live_scene(test::small_room());
  const Json before = test::wait_for_rest(*scene);
  const Json field = scene->field();
  const double distance = before["plane"]["distance"].get<double>();
  const double viewer_mm = 1.0 / field["vergence_per_mm"].get<double>();
  scene->change({{"plane_mm", 10.0}});
  const Json after = test::wait_for_rest(*scene);
  EXPECT_NEAR(after["plane"]["distance"].get<double>(), distance * (1.0 - 10.0 / viewer_mm), 1e-3 * distance);
}

TEST(LiveScene, renders_run_one_at_a_time) {
  const TempDir dir;
  RenderParams params = test::small_room();
  params.output.folder = (dir.path() / "out").string();
  const auto scene = test::live_scene(params);
  scene->change({{"frame", 5}});
  scene->render(false);
  const Json done =
      test::wait_for(*scene, [](const Json& now) { return !now["render"].is_null() && now["render"]["state"] != "running"; });
  EXPECT_EQ(done["render"]["state"], "finished");
  EXPECT_EQ(done["render"]["frames"], 1);
  EXPECT_TRUE(std::filesystem::exists(dir.path() / "out" / "frame_0005.png"));
  test::wait_for_rest(*scene);
}

TEST(LiveScene, cancelled_renders_equal_interrupted_ones) {
  const TempDir dir;
  RenderParams params = test::small_room();
  params.optics.size = {512, 128};
  params.output.folder = (dir.path() / "out").string();
  const auto scene = test::live_scene(params);
  scene->render(true);
  EXPECT_THAT(test::error_message([&] { scene->render(true); }), HasSubstr("another render is running"));
  test::wait_for(*scene, [](const Json& now) { return now["render"]["done"].get<int>() > 0; });
  scene->cancel_render();
  const Json done = test::wait_for(*scene, [](const Json& now) { return now["render"]["state"] != "running"; });
  EXPECT_EQ(done["render"]["state"], "stopped");
  EXPECT_LT(done["render"]["done"].get<int>(), done["render"]["frames"].get<int>());
  EXPECT_TRUE(std::filesystem::exists(dir.path() / "out" / "job.toml"));
  EXPECT_TRUE(std::filesystem::exists(dir.path() / "out" / "frame_0000.png"));
}

}  // namespace
}  // namespace lippmann
