#include <fmt/format.h>
#include <gmock/gmock.h>

#include <array>
#include <nlohmann/json.hpp>

#include "compare/compare.hpp"
#include "formats/rgbd_side_file.hpp"
#include "job/renders.hpp"
#include "job/report.hpp"
#include "lippmann/display/load_display.hpp"
#include "lippmann/image/picture_file.hpp"
#include "replay/depth_frames.hpp"
#include "replay/orthoscopic.hpp"
#include "replay/stereo_frames.hpp"
#include "video/video_reader.hpp"

namespace lippmann::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

Image8 codes_of(const fs::path& path) { return std::get<Image8>(read_picture(path)); }

class LayoutRenders : public Renders {
 protected:
  RenderParams array(const std::string& folder, const Settings& more = {}) const {
    return teapot(folder, "3-4", Settings{{"optics", "microlens"}, {"lenses", "8"}, {"lens-pixels", "4"}} + more);
  }

  RenderParams pair(const std::string& folder, const Settings& more) const {
    return job("teapot", folder, Settings{{"layout", "stereo"}, {"frames", "3"}, {"viewing-distance", "600"}} + more);
  }

  bool are_identical(const std::string& a, const std::string& b) const {
    return compare(dir_ / a, dir_ / b, context_).identical;
  }

  ConvertParams of_views(ViewGrid views, std::optional<ViewGrid> tiles = {}) const {
    ConvertParams params;
    params.from = "integral", params.options.views = views, params.options.tiles = tiles;
    return params;
  }
};

TEST_F(LayoutRenders, views_are_cut_from_the_integral_image) {
  render(array("whole"));
  render(array("cut", {{"layout", "views"}}));
  convert("whole", "views", "views", of_views({4, 4}));
  for (const char* frame : {"frame_0003", "frame_0004"}) {
    const Files cut = files_in(dir_ / "cut" / frame, ".png");
    EXPECT_EQ(cut.size(), 16u);
    EXPECT_EQ(cut, files_in(dir_ / "views" / frame, ".png"));
  }
}

TEST_F(LayoutRenders, quilt_equals_conversion_and_names_tiles) {
  render(array("whole"));
  const RenderReport report = render(array("quilts", {{"layout", "quilt"}, {"quilt", "8x2"}, {"video", dir_ / "a.mkv"}}));
  convert("whole/frame_0003.png", "one.png", "quilt", of_views({4, 4}, ViewGrid{8, 2}));
  EXPECT_EQ(bytes("quilts/frame_0003_qs8x2a1.png"), bytes("one_qs8x2a1.png"));
  EXPECT_EQ(report.videos, std::vector<std::string>{dir_ / "a_qs8x2a1.mkv"});
  EXPECT_TRUE(exists("a_qs8x2a1.mkv"));
}

TEST_F(LayoutRenders, views_of_a_quilt_are_its_tiles) {
  const Settings quilt{{"optics", "multiview"}, {"views", "2x2"}, {"size", "32x48"}, {"frames", "3"}};
  render(job("teapot", "q", quilt + Settings{{"layout", "quilt"}}));
  render(job("teapot", "v", quilt + Settings{{"layout", "views"}}));
  convert("q/frame_0003_qs2x2a0.666667.png", "c", "views");
  EXPECT_EQ(files_in(dir_ / "v/frame_0003", ".png").size(), 4u);
  EXPECT_EQ(files_in(dir_ / "v/frame_0003", ".png"), files_in(dir_ / "c", ".png"));
}

TEST_F(LayoutRenders, pseudoscopic_pictures_rotate_elemental_images) {
  render(array("plain"));
  const Files recorded = rendered(array("recorded", {{"pseudoscopic", "true"}}));
  convert_to_orthoscopic({dir_ / "plain", dir_ / "turned"}, context_);
  EXPECT_EQ(recorded.size(), 2u);
  EXPECT_EQ(recorded, files_in(dir_ / "turned", ".png"));
}

TEST_F(LayoutRenders, layers_have_the_layout_of_pictures) {
  render(array("views", {{"layout", "views"}, {"aov", "depth"}}));
  EXPECT_EQ(files_in(dir_ / "views/frame_0003", ".exr").size(), 16u);
  render(array("exr", {{"layout", "views"}, {"aov", "depth"}, {"format", "exr"}}));
  EXPECT_EQ(files_in(dir_ / "exr/frame_0003", ".exr").size(), 16u);
  render(teapot("beside", "0", {{"format", "png16"}, {"aov", "depth"}}));
  EXPECT_TRUE(exists("beside/frame_0000.png"));
  EXPECT_TRUE(exists("beside/aov_0000.exr"));
}

TEST_F(LayoutRenders, impossible_layouts_are_refused_first) {
  const auto refused = [&](const Settings& settings, const std::string& message) {
    EXPECT_THAT(refusal(job("teapot", "none", Settings{{"frames", "0"}} + settings)), HasSubstr(message));
    EXPECT_FALSE(exists("none"));
  };
  refused({{"layout", "views"}, {"lens-pixels", "7.5"}, {"lenses", "8"}}, "whole number of pixels");
  refused({{"layout", "quilt"}, {"optics", "microlens"}, {"packing", "hexagonal"}}, "whole number of pixels");
  refused({{"layout", "quilt"}, {"quilt", "3x2"}}, "3x2 tiles do not hold 8 views");
  refused({{"quilt", "4x2"}}, "quilt");
  refused({{"pseudoscopic", "true"}, {"layout", "quilt"}}, "integral");
  refused({{"layout", "views"}, {"video", dir_ / "a.mp4"}}, "one picture per frame");
  refused({{"size", "20000x20000"}}, "tiff");
  refused({{"size", "65536x32768"}}, "2147483647 pixels");
  refused({{"video", dir_ / "a.webm"}, {"video-codec", "h264"}}, "cannot contain h264");
  const Settings grid{{"optics", "multiview"}, {"camera-grid", "true"}, {"views", "2x2"}, {"size", "32x32"}};
  refused(grid + Settings{{"to", "hci"}, {"aov", "normal"}}, "aov: files of the format hci cannot store these layers");
  refused(grid + Settings{{"to", "jpeg-pleno"}, {"aov", "depth"}}, "aov");
  refused(grid + Settings{{"to", "hci"}, {"transparent", "true"}}, "transparent: files of the format hci hold no alpha");
  refused(grid + Settings{{"to", "hci"}, {"video", dir_ / "a.mp4"}}, "video: needs a layout with one picture per frame");
  refused(grid + Settings{{"to", "hci"}, {"format", "tiff"}}, "format: light-field formats do not use TIFF");
  refused({{"lens-pixels", "7.5"}, {"to", "views"}}, "whole number of pixels");
  for (const char* to : {"nerf", "hci", "eslf"})
    refused({{"optics", "plenoptic"}, {"lens-pixels", "9"}, {"to", to}}, "to: the views of a plenoptic camera are computed");
}

TEST_F(LayoutRenders, tiff_has_png_codes_and_fixed_time) {
  render(array("png"));
  render(array("tiff", {{"format", "tiff"}}));
  EXPECT_TRUE(are_identical("png/frame_0003.png", "tiff/frame_0003.tif"));
  EXPECT_THAT(bytes("tiff/frame_0003.tif"), HasSubstr("1970:01:01 00:00:00"));
}

TEST_F(LayoutRenders, ffv1_video_has_the_pictures_codes) {
  RenderParams params = teapot("a", "0-3");
  params.output.video = {dir_ / "a.mkv", dir_ / "a.mp4"};
  render(params);
  EXPECT_TRUE(exists("a.mp4"));
  EXPECT_TRUE(are_identical("a", "a.mkv"));
}

TEST_F(LayoutRenders, every_stereo_packing_equals_conversion) {
  render(pair("sbs", {{"size", "128x36"}}));
  render(pair("ou", {{"size", "64x72"}, {"stereo", "over-under"}, {"right-first", "true"}}));
  render(pair("rows", {{"size", "64x36"}, {"stereo", "rows"}}));
  ConvertParams params;
  params.options.stereo = StereoLayout{.packing = StereoPacking::kOverUnder, .right_first = true};
  convert("sbs/frame_0003_2x1.png", "a.png", "stereo", params);
  EXPECT_EQ(bytes("ou/frame_0003_ou_rl.png"), bytes("a_ou_rl.png"));
  params.options.stereo = StereoLayout{.packing = StereoPacking::kRows};
  convert("sbs/frame_0003_2x1.png", "a.png", "stereo", params);
  EXPECT_EQ(bytes("rows/frame_0003_rows.png"), bytes("a_rows.png"));
}

TEST_F(LayoutRenders, quilt_shows_eyes_their_rendered_views) {
  // The quilt has 16 eyes in a row, 10 mm apart, so the stereo eyes at -25 and +25 mm are among them.
  render(job("teapot", "q",
             {{"optics", "multiview"},
              {"camera-grid", "true"},
              {"views", "16x1"},
              {"size", "1024x36"},
              {"view-angle", "15.189"},
              {"frames", "3"},
              {"viewing-distance", "600"}}));
  const ConvertedStereo made =
      convert_to_stereo({.in = dir_ / "q", .out = dir_ / "eyes", .ipd_mm = 50.0, .screen_width_mm = 64.0}, context_);
  EXPECT_EQ(made.view_size, Vec2i(64, 36));
  EXPECT_EQ(made.out_of_zone, 0.0);
  render(pair("sbs", {{"size", "128x36"}, {"ipd", "50"}, {"screen-width", "64"}}));
  EXPECT_EQ(codes_of(dir_ / "sbs/frame_0003_2x1.png").rgb, codes_of(dir_ / "eyes/frame_0003_2x1.png").rgb);
}

TEST_F(LayoutRenders, stereo_is_part_of_video_names) {
  const RenderReport report = render(pair("out", {{"size", "128x36"}, {"video", dir_ / "a.mkv"}}));
  EXPECT_EQ(report.videos, std::vector<std::string>{dir_ / "a_2x1.mkv"});
}

TEST_F(LayoutRenders, rgbd_is_one_view_with_depth) {
  const Settings room{{"size", "64x48"}, {"frames", "0"}};
  render(job("room", "a", room + Settings{{"layout", "rgbd"}}));
  render(job("room", "b", room + Settings{{"to", "rgbd"}}));
  for (const std::string file : {"frame_0000_rgbd.png", "frame_0000_rgbd.png.json"}) {
    EXPECT_EQ(bytes("a/" + file), bytes("b/" + file));
    EXPECT_NE(bytes("a/" + file), "");
  }
  EXPECT_EQ(codes_of(dir_ / "a/frame_0000_rgbd.png").width, 128);
}

RgbdSideFile side_of(const fs::path& picture) { return read_rgbd_side_file(picture).value(); }

TEST_F(LayoutRenders, rgbd_range_covers_the_whole_animation) {
  const Settings small{{"size", "64x48"}, {"layout", "rgbd"}};
  render(job("room", "a", small + Settings{{"frames", "0,100,200"}}));
  RenderParams one = job("room", "b", small + Settings{{"frames", "200"}});
  one.threads = 1;
  render(one);
  const RgbdSideFile side = side_of(dir_ / "b/frame_0200_rgbd.png");
  for (const char* frame : {"a/frame_0000_rgbd.png", "a/frame_0100_rgbd.png", "a/frame_0200_rgbd.png"})
    EXPECT_EQ(side_of(dir_ / frame), side) << frame;
  EXPECT_EQ(bytes("a/frame_0200_rgbd.png"), bytes("b/frame_0200_rgbd.png"));
  render(job("room", "plain",
             {{"optics", "multiview"}, {"views", "3x1"}, {"size", "192x48"}, {"aov", "depth"}, {"frames", "0,100,200"}}));
  convert("plain", "each", "rgbd");
  for (const int frame : {0, 100, 200}) {
    const DepthRange own = side_of(dir_ / "each" / fmt::format("frame_{:04}_rgbd.png", frame)).coding.range;
    EXPECT_LE(own.near_mm, side.coding.range.near_mm + 1e-3) << frame;
    EXPECT_GE(own.far_mm, side.coding.range.far_mm - 1e-3) << frame;
  }
}

TEST_F(LayoutRenders, rgbd_coding_is_refused_elsewhere) {
  const Settings small{{"size", "64x48"}, {"frames", "0"}};
  render(job(
      "room", "a",
      small + Settings{{"layout", "rgbd"}, {"depth-range", "12.5:-40"}, {"depth-coding", "depth"}, {"near-black", "true"}}));
  const DepthCoding coding = side_of(dir_ / "a/frame_0000_rgbd.png").coding;
  EXPECT_EQ(coding, (DepthCoding{{12.5, -40}, true, true}));
  const auto refusal = [&](const Settings& more) { return error_message([&] { render(job("room", "b", small + more)); }); };
  EXPECT_THAT(refusal({{"depth-range", "10:-30"}}), HasSubstr("depth-range: has no effect without `layout` rgbd"));
  EXPECT_THAT(refusal({{"layout", "rgbd"}, {"depth-range", "1e6:0"}}), HasSubstr("does not lie in front of the eye"));
  EXPECT_THAT(refusal({{"layout", "rgbd"}, {"depth-range", "-30:10"}}), HasSubstr("as a range of depths"));
}

TEST_F(LayoutRenders, rgbd_video_has_a_side_file) {
  const Settings clip{{"size", "64x48"}, {"frames", "0-2"}, {"layout", "rgbd"}, {"video", dir_ / "v/clip.mkv"}};
  const RenderReport report = render(job("room", "a", clip));
  const fs::path video = dir_ / "v/clip_rgbd.mkv";
  EXPECT_EQ(report.videos, std::vector<std::string>{video});
  EXPECT_EQ(side_of(video), side_of(dir_ / "a/frame_0001_rgbd.png"));
  VideoReader reader(video);
  for (const char* frame : {"0000", "0001", "0002"}) {
    const std::optional<Image8> shown = reader.next();
    ASSERT_TRUE(shown);
    EXPECT_EQ(shown->rgb, codes_of(dir_ / "a" / fmt::format("frame_{}_rgbd.png", frame)).rgb);
  }
  EXPECT_FALSE(reader.next());
  const std::string bytes_before = bytes("v/clip_rgbd.mkv");
  fs::remove(dir_ / "a/frame_0002_rgbd.png"), fs::remove(video);
  EXPECT_EQ(kept(resume(job("room", "a", clip))), 2u);
  EXPECT_EQ(bytes("v/clip_rgbd.mkv"), bytes_before) << "from kept frames and a new one";
  EXPECT_THAT(error_message([&] {
                render(job("room", "b", clip + Settings{{"format", "exr"}}));
              }),
              HasSubstr("store depth as integers"));
}

TEST_F(LayoutRenders, mixed_rows_of_stereo_video_give_warnings) {
  const Settings rows{{"stereo", "rows"}, {"size", "64x36"}};
  render(pair("a", rows + Settings{{"video", dir_ / "a.mp4"}}));
  EXPECT_THAT(warnings_, HasSubstr("An .mkv with FFV1 keeps them apart."));
  render(pair("b", rows + Settings{{"video", dir_ / "b.mkv"}}));
  EXPECT_EQ(warnings_, "");
  render(pair("c", {{"size", "64x36"}, {"video", dir_ / "c.mp4"}}));
  EXPECT_EQ(warnings_, "");
}

TEST_F(LayoutRenders, views_from_depth_resemble_true_ones) {
  render(job("room", "true",
             {{"optics", "multiview"},
              {"views", "5x1"},
              {"size", "640x128"},
              {"view-angle", "10"},
              {"frames", "0"},
              {"spp", "16"},
              {"aov", "depth"}}));
  convert("true", "middle", "rgbd");
  convert("true", "views", "views");
  DepthConversion params{dir_ / "middle/frame_0000_rgbd.png", dir_ / "made", "views", {}, 10.0};
  params.options.views = ViewGrid{5, 1};
  const ConvertedDepth made = convert_depth_frames(params, context_);
  EXPECT_EQ(made.views, (ViewGrid{5, 1}));
  EXPECT_LT(made.filled_share, 0.05);
  const auto psnr = [&](const std::string& view) {
    return measure_difference(codes_of(dir_ / "views/frame_0000" / view), codes_of(dir_ / "made" / view)).psnr_db;
  };
  EXPECT_GT(psnr("view_002.png"), 50.0) << "the picture itself";
  for (const char* view : {"view_000.png", "view_001.png", "view_003.png", "view_004.png"}) EXPECT_GT(psnr(view), 25.0) << view;
}

TEST_F(LayoutRenders, picture_with_depth_is_shown_everywhere) {
  render(job("room", "a", {{"size", "60x80"}, {"frames", "0"}, {"layout", "rgbd"}}));
  DepthConversion params{dir_ / "a", dir_ / "q", "quilt"};
  params.options.display = load_display("portrait"), params.depth_scale = 0.5;
  convert_depth_frames(params, context_);
  EXPECT_EQ(codes_of(dir_ / "q/frame_0000_qs8x6a0.75.png").width, 3360);
  params = {dir_ / "a", dir_ / "sheet", "integral"};
  params.options.display = load_display("microlens-0.7mm-phone"), params.options.display->pixels = {180, 320};
  EXPECT_EQ(convert_depth_frames(params, context_).views, (ViewGrid{23, 23}));
  EXPECT_EQ(codes_of(dir_ / "sheet/frame_0000.png").height, 320) << "the panel's pixels";
  DepthConversion eyes{dir_ / "a", dir_ / "p", "stereo"};
  eyes.ipd_mm = 5.0;
  EXPECT_EQ(convert_depth_frames(eyes, context_).view_size, Vec2i(60, 80));
}

}  // namespace
}  // namespace lippmann::test
