#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "image/exr.hpp"
#include "image/png.hpp"
#include "image/read_image.hpp"
#include "job/renders.hpp"
#include "lippmann/image/metrics.hpp"
#include "lippmann/optics/crosstalk.hpp"
#include "replay/orthoscopic.hpp"
#include "replay/replay.hpp"

namespace lippmann::test {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const Settings kCameraGrid{
    {"optics", "multiview"}, {"camera-grid", "true"}, {"views", "3x3"}, {"size", "48x36"}, {"frames", "3"}};

class ReplayedRenders : public Renders {
 protected:
  void render_teapot() { render(teapot("out", "3-4")); }

  Replayed seen(ReplayParams params, const std::string& in, const std::string& folder) {
    warnings_.clear();
    params.in = dir_ / in, params.folder = dir_ / folder;
    return replay(params, context_);
  }

  std::string refused(const ReplayParams& params) {
    return error_message([&] { seen(params, "out", "never"); });
  }

  std::string eye_view_of(const std::string& in, ReplayParams params = {}) {
    fs::remove_all(dir_ / "eye");
    return file_bytes(seen(params, in, "eye").written.at(0));
  }
};

TEST_F(ReplayedRenders, folder_gives_one_eye_view_per_frame) {
  render_teapot();
  const Replayed result = replay({.in = dir_ / "out"}, context_);
  EXPECT_EQ(result.out_of_zone, 0.0);
  EXPECT_TRUE(result.eye_mm);
  EXPECT_EQ(files_in(dir_ / "out/replay", ".png").size(), 2u);
  const Image8 picture = read_image8(dir_ / "out/replay/eye_0003.png"), panel = read_image8(dir_ / "out/frame_0003.png");
  EXPECT_EQ(picture.width, panel.width);
  EXPECT_EQ(picture.height, panel.height);
  EXPECT_NE(picture.rgb, panel.rgb);
}

TEST_F(ReplayedRenders, eyes_outside_the_zone_give_warnings) {
  render_teapot();
  EXPECT_EQ(replay({.in = dir_ / "out", .folder = dir_ / "near", .ipd_mm = 1.0}, context_).out_of_zone, 0.0);
  EXPECT_EQ(replay({.in = dir_ / "out", .folder = dir_ / "far", .ipd_mm = 1e5}, context_).out_of_zone, 1.0);
}

TEST_F(ReplayedRenders, two_eyes_give_three_pictures) {
  render_teapot();
  seen({.ipd_mm = 10.0}, "out/frame_0003.png", "eyes");
  EXPECT_EQ(files_in(dir_ / "eyes", ".png").size(), 3u);
  EXPECT_NE(bytes("eyes/left_0003.png"), bytes("eyes/right_0003.png"));
  const Image8 left = read_image8(dir_ / "eyes/left_0003.png"), pair = read_image8(dir_ / "eyes/pair_0003.png");
  ASSERT_EQ(pair.width, 2 * left.width);
  for (int x = 0; x < 3 * left.width; ++x)
    ASSERT_EQ(pair.rgb[static_cast<std::size_t>(x)], left.rgb[static_cast<std::size_t>(x)]);
}

TEST_F(ReplayedRenders, sweep_is_numbered_pictures_and_a_video) {
  render_teapot();
  seen({.sweep = 5, .video = dir_ / "sweep.mkv"}, "out", "sweep");
  const Files files = files_in(dir_ / "sweep", ".png");
  EXPECT_EQ(files.size(), 5u);
  EXPECT_NE(files.at("sweep_0000.png"), files.at("sweep_0004.png"));
  EXPECT_TRUE(exists("sweep.mkv"));
}

TEST_F(ReplayedRenders, refocusing_makes_no_eye_view) {
  render_teapot();
  const FocalStack stack{-10.0, 10.0, 3};
  const Replayed result = seen({.refocus = FocusPlane{-5.0}, .focal_stack = stack, .epi_row = 7}, "out/frame_0003.png", "a");
  EXPECT_FALSE(result.eye_mm) << "no picture shows what an eye sees";
  const Files files = files_in(dir_ / "a", ".png");
  EXPECT_EQ(files.size(), 5u);
  for (const char* name : {"refocus_0003.png", "stack_0003_00.png", "stack_0003_02.png", "epi_row_0003.png"})
    EXPECT_TRUE(files.contains(name)) << name;
  seen({.focal_stack = stack, .all_in_focus = true}, "out/frame_0003.png", "b");
  EXPECT_EQ(channel_names(dir_ / "b/depth_0003.exr"), std::vector<std::string>{"Z"});
  EXPECT_TRUE(exists("b/all_in_focus_0003.png"));
}

TEST_F(ReplayedRenders, impossible_parameters_are_refused) {
  render_teapot();
  for (const Vec3d eye : {Vec3d(0, 0, 0), Vec3d(0, 0, -10), Vec3d(0, 0, std::nan("")), Vec3d(INFINITY, 0, 100)})
    EXPECT_THAT(refused({.eye_mm = eye}), HasSubstr("eye"));
  EXPECT_THAT(refused({.view = {.size = {60000, 60000}}}), HasSubstr("size"));
  EXPECT_THAT(refused({.view = {.pupil_mm = std::nan("")}}), HasSubstr("pupil"));
  EXPECT_THAT(refused({.refocus = FocusPlane{1e6}}), HasSubstr("refocus"));
  EXPECT_THAT(refused({.refocus = FocusPlane{std::nan("")}}), HasSubstr("refocus"));
  EXPECT_THAT(refused({.focal_stack = FocalStack{std::nan(""), 2.0, 5}}), HasSubstr("focal-stack"));
  EXPECT_THAT(refused({.all_in_focus = true}), HasSubstr("all-in-focus"));
  EXPECT_THAT(refused({.epi_row = 100000}), HasSubstr("epi"));
  EXPECT_THAT(refused({.epi_column = 3}), HasSubstr("epi-column"));
  EXPECT_THAT(refused({.refocus = FocusPlane{1.0}, .video = dir_ / "a.mkv"}), HasSubstr("video"));
  EXPECT_THAT(refused({.field = {.view_angle_deg = 20.0}}), HasSubstr("view-angle"));
  EXPECT_FALSE(exists("never"));
}

TEST_F(ReplayedRenders, missing_report_or_foreign_pictures_are_refused) {
  render_teapot();
  fs::remove_all(dir_ / "out/.lippmann");  // the journal would report the changed pictures
  EXPECT_THAT(error_message([&] { seen({}, "none", "never"); }), HasSubstr("none"));
  write_png(dir_ / "out/frame_0004.png", Image8{8, 8, std::vector<unsigned char>(192)});
  EXPECT_THAT(error_message([&] { seen({}, "out/frame_0004.png", "never"); }), HasSubstr("has 8x8 pixels"));
  for (const char* text : {"", "[", "[1, 2]", "{}", "{\"optics\": 3}", "{\"optics\": {\"kind\": \"lens\"}}"}) {
    std::ofstream(dir_ / "out/report.json") << text;
    EXPECT_THAT(refused({}), HasSubstr("report.json"));
  }
  fs::remove(dir_ / "out/report.json");
  EXPECT_THAT(refused({}), HasSubstr("report.json"));
  EXPECT_THAT(error_message([&] { seen({}, ".", "never"); }), HasSubstr("no frames"));
}

TEST_F(ReplayedRenders, rotated_elemental_images_survive_a_round_trip) {
  render_teapot();
  convert_to_orthoscopic({dir_ / "out", dir_ / "turned"}, context_);
  convert_to_orthoscopic({dir_ / "turned", dir_ / "back"}, context_);
  EXPECT_EQ(read_image8(dir_ / "back/frame_0003.png").rgb, read_image8(dir_ / "out/frame_0003.png").rgb);
  EXPECT_NE(read_image8(dir_ / "turned/frame_0003.png").rgb, read_image8(dir_ / "out/frame_0003.png").rgb);
  EXPECT_EQ(seen({}, "turned", "eye").written.size(), 2u);
  EXPECT_THAT(error_message([&] {
                convert_to_orthoscopic({dir_ / "out", dir_ / "out"}, context_);
              }),
              HasSubstr("another folder"));
}

TEST_F(ReplayedRenders, spoc_makes_pictures_for_other_lenses) {
  render_teapot();
  OrthoscopicParams smart{dir_ / "out", dir_ / "smart", SpocParams{8.0, 8.0}};
  smart.lens_pixels = 12, smart.gap_mm = 3.0;
  convert_to_orthoscopic(smart, context_);
  const nlohmann::json optics = nlohmann::json::parse(bytes("smart/report.json"))["optics"];
  EXPECT_EQ(optics["gap_mm"], 3.0);
  EXPECT_EQ(read_image8(dir_ / "smart/frame_0003.png").width, optics["width"]);
  EXPECT_EQ(seen({.eye_mm = Vec3d(0.0, 0.0, 4000.0)}, "smart", "eye").written.size(), 2u);
  const auto refusal_of = [&](SpocParams spoc, std::optional<double> gap_mm) {
    return error_message([&] { convert_to_orthoscopic({dir_ / "out", dir_ / "a", spoc, {}, gap_mm}, context_); });
  };
  EXPECT_THAT(refusal_of({8.0, 8.0}, -1.0), HasSubstr("spoc"));
  EXPECT_THAT(refusal_of({std::nan(""), std::nan("")}, {}), HasSubstr("spoc"));
  EXPECT_THAT(refusal_of({8.0, -1.0}, {}), HasSubstr("reference-plane"));
}

TEST_F(ReplayedRenders, eye_outside_the_zone_gives_a_warning) {
  render_teapot();
  seen({.eye_mm = Vec3d(1000.0, 0.0, 300.0)}, "out", "eye");
  EXPECT_THAT(warnings_, HasSubstr("For 100 % of the display, the eye"));
  render(job("teapot", "grid", kCameraGrid));
  seen({.eye_mm = Vec3d(5000.0, 0.0, 300.0)}, "grid", "eye");
  EXPECT_THAT(warnings_, HasSubstr("the outermost cameras' pictures"));
  EXPECT_THAT(warnings_, Not(HasSubstr("lens")));
}

TEST_F(ReplayedRenders, all_layouts_look_the_same) {
  const std::vector<Settings> kinds{{{"optics", "lenticular"}, {"lenses", "8"}},
                                    {{"optics", "microlens"}, {"lenses", "16x12"}},
                                    {{"optics", "multiview"}, {"views", "4x2"}}};
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    const Settings settings = kinds[i] + Settings{{"frames", "3"}, {"size", "64x48"}};
    const std::string shown = std::to_string(i);
    render(job("teapot", shown, settings));
    const std::string eye = eye_view_of(shown);
    for (const std::string layout : {"integral", "views", "quilt"}) {
      render(job("teapot", shown + layout, settings + Settings{{"layout", layout}}));
      EXPECT_TRUE(eye_view_of(shown + layout) == eye) << i << layout;
    }
  }
}

TEST_F(ReplayedRenders, stereo_pair_shows_each_eye_its_view) {
  render(job("teapot", "sbs", {{"layout", "stereo"}, {"frames", "3"}, {"viewing-distance", "600"}, {"size", "128x36"}}));
  const Converted views = convert("sbs", "views", "views");
  EXPECT_EQ(views.views, (ViewGrid{2, 1}));
  EXPECT_EQ(views.view_size, Vec2i(64, 36));
  seen({.eye_mm = Vec3d(-31.5, 0.0, 600.0)}, "sbs", "seen");
  EXPECT_EQ(read_image8(dir_ / "seen/eye_0003.png").rgb, read_image8(dir_ / "views/frame_0003/view_000.png").rgb);
}

TEST_F(ReplayedRenders, stated_cameras_look_like_the_source) {
  render(job("teapot", "out", kCameraGrid));
  const std::string eye = eye_view_of("out", {.ipd_mm = 4.0});
  for (const std::string format : {"hci", "miv", "stanford"}) {
    convert("out/frame_0003.png", format, format);
    EXPECT_TRUE(eye_view_of(format, {.ipd_mm = 4.0}) == eye) << format;
  }
}

TEST_F(ReplayedRenders, unknown_cameras_are_assumed) {
  render(job("teapot", "out", kCameraGrid));
  const std::string format = "jpeg-pleno";
  convert("out/frame_0003.png", format, format);
  warnings_.clear();
  replay({.in = dir_ / format}, context_);
  EXPECT_THAT(warnings_, AllOf(HasSubstr("The cameras of"), HasSubstr("over 10 degrees; `view-angle` sets the angle")));
  EXPECT_TRUE(exists(format + "/replay/eye_" + format + ".png"));
  EXPECT_EQ(seen({.refocus = FocusPlane{-5.0}, .epi_row = 3, .epi_column = 3}, format, "products").written.size(), 3u);
  warnings_.clear();
  replay({.in = dir_ / format, .field = {.view_angle_deg = 20.0}}, context_);
  EXPECT_THAT(warnings_, AllOf(HasSubstr("Assumed: a display 100 mm high"), Not(HasSubstr("sets the angle"))));
}

TEST_F(ReplayedRenders, quilt_is_recognised_by_its_name) {
  render_teapot();
  fs::create_directory(dir_ / "a");
  ConvertParams params;
  params.options.aspect = 0.75;
  convert("out/frame_0003.png", "a/picture.png", "quilt", params);
  const std::string quilt = "a/picture_qs4x2a0.75.png";
  ASSERT_TRUE(exists(quilt));
  eye_view_of(quilt);
  const Image8 picture = read_image8(dir_ / "eye/eye_picture.png");
  EXPECT_NEAR(static_cast<double>(picture.width) / picture.height, 0.75, 0.02);
  fs::rename(dir_ / quilt, dir_ / "a/plain.png");
  EXPECT_THAT(error_message([&] { seen({}, "a/plain.png", "never"); }), HasSubstr("plain.png is unknown"));
  EXPECT_FALSE(eye_view_of("a/plain.png", {.field = {.from = "quilt", .tiles = ViewGrid{4, 2}}}).empty());
}

TEST_F(ReplayedRenders, converted_cameras_keep_their_positions) {
  // Returns how far the second camera is to the right of the first. MIV's y axis points to the left.
  const auto camera_step = [&](const std::string& folder) {
    convert(folder + "/frame_0000.png", folder + "-miv", "miv");
    const auto cameras = nlohmann::json::parse(bytes(folder + "-miv/cameras.json"))["cameras"];
    return cameras[0]["Position"][1].get<double>() - cameras[1]["Position"][1].get<double>();
  };
  const RenderReport fitted = render(teapot("fitted", "0"));
  render(teapot("full", "0", {{"fit-depth", "false"}}));
  EXPECT_LT(fitted.depth_scale, 0.9f);
  EXPECT_GT(camera_step("full"), 0.0);
  EXPECT_NEAR(camera_step("fitted") / camera_step("full"), static_cast<double>(fitted.depth_scale), 1e-4);
}

}  // namespace
}  // namespace lippmann::test
