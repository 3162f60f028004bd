#include <gmock/gmock.h>

#include <cmath>
#include <fstream>

#include "cli/tool.hpp"
#include "lippmann/image/picture_file.hpp"
#include "lippmann/layout/light_field.hpp"

namespace lippmann::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using testing::HasSubstr;

Words small_views(const std::string& folder, const Words& more = {}) {
  return Words{"render", "teapot", "--optics", "multiview", "--views", "2x2",
               "--size", "64x64",  "--frames", "0",         "-o",      folder} +
         more;
}

TEST(Convert, prints_files_and_refuses_irregular_grids) {
  const TempDir dir;
  expect_done(dir, small_teapot("0", "r"));
  const Words convert{"convert", "r/frame_0000.png", "q.png", "--from", "integral", "--to", "quilt"};
  const Json report = report_of(dir, convert + Words{"--views", "8x1"});
  EXPECT_EQ(report["view_size"], Json({16, 128}));
  EXPECT_TRUE(fs::exists(dir / report["files"][0].get<std::string>()));
  for (const char* grid : {"8", "8x", "x1", "0x1", "8x1x2", "-8x1", "99999x1"})
    expect_refusal(run_tool(dir, convert + Words{"--views", grid}), 2, "--views");
  EXPECT_EQ(run_tool(dir, convert).exit_code, 0) << "the report beside it has the number of views";
  fs::copy(dir / "r/frame_0000.png", dir / "alone.png");
  expect_refusal(run_tool(dir, {"convert", "alone.png", "q.png", "--from", "integral", "--to", "quilt"}), 2, "--views");
  expect_refusal(run_tool(dir, {"convert", "alone.png", "q.png", "--to", "quilt"}), 2, "--from");
}

TEST(Convert, assumed_cameras_and_depth_are_reported) {
  const TempDir dir;
  expect_done(dir, small_views("r", {"--camera-grid"}));
  const RunResult no_depth = run_tool(dir, {"convert", "r/frame_0000.png", "hci", "--to", "hci"});
  EXPECT_EQ(no_depth.exit_code, 0);
  EXPECT_THAT(no_depth.err, HasSubstr("--aov depth"));
  EXPECT_TRUE(fs::exists(dir / "hci/parameters.cfg"));
  fs::copy(dir / "r/frame_0000.png", dir / "alone.png");
  const RunResult no_cameras = run_tool(dir, {"convert", "alone.png", "h", "--from", "quilt", "--quilt", "2x2", "--to", "hci"});
  EXPECT_THAT(no_cameras.err, HasSubstr("report.json"));
  EXPECT_FALSE(fs::exists(dir / "h/parameters.cfg"));
}

TEST(Convert, folder_of_pictures_is_views) {
  const TempDir dir;
  fs::create_directories(dir / "photos");
  for (const int number : {2, 10, 1})
    write_picture(dir / "photos" / (std::to_string(number) + ".png"),
                  Image8{1, 1, std::vector<unsigned char>(3, static_cast<unsigned char>(number))});
  std::ofstream(dir / "photos/notes.txt") << "mine";
  const RunResult result = run_tool(dir, {"convert", "photos", "p.png", "--to", "eslf"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("its 3 pictures are the views, in the order of their names from 1.png to 10.png; "
                                    "left out: notes.txt"));
  EXPECT_EQ(std::get<Image8>(read_picture(dir / "p.png")).rgb, (std::vector<unsigned char>{1, 1, 1, 2, 2, 2, 10, 10, 10}));
  write_picture(dir / "photos/3.png", Image8{2, 1, std::vector<unsigned char>(6)});
  expect_refusal(run_tool(dir, {"convert", "photos", "q.png", "--to", "eslf"}), 1, "3.png: 2x1 8-bit");
  EXPECT_FALSE(fs::exists(dir / "q.png"));
}

TEST(Convert, dropped_camera_positions_are_reported) {
  const TempDir dir;
  fs::create_directories(dir / "s");
  for (const char* name : {"out_00_00_0.0_0.0.png", "out_00_01_0.0_4.0.png"})
    write_picture(dir / "s" / name, Image8{2, 2, std::vector<unsigned char>(12)});
  const auto warning = [&](const std::string& to) {
    return run_tool(dir, {"convert", "s", to == "eslf" ? "e.png" : "h", "--to", to}).err;
  };
  EXPECT_THAT(warning("hci"), HasSubstr("not written, because hci cannot store them: camera positions without a unit"));
  EXPECT_THAT(warning("jpeg-pleno"), HasSubstr("because jpeg-pleno cannot store them: camera positions without a unit"));
  EXPECT_EQ(warning("eslf"), "");
}

TEST(Convert, views_keep_grid_and_cameras) {
  const TempDir dir;
  expect_done(dir, {"render", "room", "--optics", "multiview", "--camera-grid", "--views", "3x2", "--size", "48x32",
                    "--view-angle", "4", "--frames", "0", "-o", "r"});
  const RunResult run = run_tool(dir, {"convert", "r/frame_0000.png", "v", "--to", "views"});
  EXPECT_EQ(run.err, "");
  const Json info = report_of(dir, {"info", "v"}), of_render = report_of(dir, {"info", "r/frame_0000.png"});
  EXPECT_EQ(info["views"], Json({3, 2}));
  EXPECT_EQ(info["cameras"], of_render["cameras"]);
  EXPECT_THAT(info["cameras"].get<std::string>(), HasSubstr("mm apart"));
  EXPECT_EQ(info["side_file"], "v/views.json");
  expect_done(dir, {"convert", "v", "hci", "--to", "hci"});
  EXPECT_TRUE(fs::exists(dir / "hci/parameters.cfg"));
  EXPECT_EQ(run_tool(dir, {"convert", "v", "q", "--to", "quilt"}).err, "");
  EXPECT_THAT(run_tool(dir, {"convert", "v", "j", "--to", "jpeg-pleno"}).err,
              HasSubstr("not written, because jpeg-pleno cannot store them: the cameras of 6 views"));
}

TEST(Convert, rendered_lenses_of_fractional_pitch_become_views) {
  const TempDir dir;
  expect_done(dir, {"render", "room", "--optics", "microlens", "--lenses", "12x9", "--lens-pixels", "4.135", "--spp", "1",
                    "--frames", "0", "-o", "r"});
  const Json views = report_of(dir, {"convert", "r", "v", "--to", "views"});
  EXPECT_EQ(views["views"], Json({4, 4}));
  EXPECT_THAT(report_of(dir, {"info", "v"})["cameras"].get<std::string>(), HasSubstr("mm apart"));
}

TEST(Convert, failure_leaves_no_folder) {
  const TempDir dir;
  expect_done(dir, small_views("r"));
  // The format hci requires equal distances between cameras. These views are at equal angles.
  EXPECT_EQ(run_tool(dir, {"convert", "r/frame_0000.png", "one", "--to", "hci"}).exit_code, 1);
  EXPECT_EQ(run_tool(dir, {"convert", "r", "all", "--to", "hci"}).exit_code, 1);
  EXPECT_FALSE(fs::exists(dir / "one") || fs::exists(dir / "all"));
  fs::create_directory(dir / "was_there");
  EXPECT_EQ(run_tool(dir, {"convert", "r", "was_there", "--to", "hci"}).exit_code, 1);
  EXPECT_TRUE(fs::exists(dir / "was_there"));
}

TEST(Convert, rgbd_reports_filled_share_and_assumptions) {
  const TempDir dir;
  const RunResult made = run_tool(dir, {"render", "room", "--size", "60x80", "--frames", "0", "--layout", "rgbd", "-o", "a"});
  EXPECT_THAT(made.out, HasSubstr("pictures  a/frame_0000_rgbd.png"));
  const Words to_quilt{"convert", "a", "q", "--to", "quilt", "--display", "portrait", "--depth-scale", "0.5"};
  EXPECT_THAT(run_tool(dir, to_quilt).out, HasSubstr("of them filled"));
  EXPECT_EQ(report_of(dir, {"convert", "a", "p", "--to", "stereo", "--ipd", "5"})["view_size"], Json({60, 80}));
  fs::remove(dir / "a/frame_0000_rgbd.png.json");
  EXPECT_THAT(run_tool(dir, {"convert", "a/frame_0000_rgbd.png", "v", "--from", "rgbd", "--to", "views", "--views", "3x1"}).err,
              HasSubstr("--depth-range"));
}

TEST(Convert, rgbd_video_equals_its_frames) {
  const TempDir dir;
  expect_done(dir, {"render", "room", "--size", "60x80", "--frames", "0-1", "--layout", "rgbd", "-o", "a"});
  EXPECT_EQ(report_of(dir, {"encode", "a", "clip.mkv"})["file"], "clip_rgbd.mkv");
  EXPECT_EQ(bytes_of(dir / "clip_rgbd.mkv.json"), bytes_of(dir / "a/frame_0001_rgbd.png.json"));
  const Words rest{"--to", "quilt", "--quilt", "3x1", "--views", "3x1"};
  const Json of_video = report_of(dir, Words{"convert", "clip_rgbd.mkv", "v"} + rest);
  const Json of_pictures = report_of(dir, Words{"convert", "a", "p"} + rest);
  EXPECT_GT(of_video["filled_share"], 0.0);
  EXPECT_EQ(of_video["filled_share"], of_pictures["filled_share"]);
  ASSERT_EQ(of_video["files"].size(), of_pictures["files"].size());
  for (std::size_t i = 0; i < of_video["files"].size(); ++i) {
    const fs::path made = dir / of_video["files"][i].get<std::string>();
    EXPECT_EQ(bytes_of(made), bytes_of(dir / "p" / made.filename())) << made;
  }
  expect_refusal(run_tool(dir, Words{"convert", "clip_rgbd.mkv", "v.mp4"} + rest), 1, "lippmann encode");
  fs::remove(dir / "a/frame_0001_rgbd.png.json");
  EXPECT_THAT(run_tool(dir, {"encode", "a", "clip.mkv"}).err, HasSubstr("frame_0001_rgbd.png.json: is missing"));
  fs::remove_all(dir / "a/.lippmann");
  EXPECT_THAT(run_tool(dir, {"encode", "a", "clip.mkv"}).err, HasSubstr("Make the frames with one --depth-range"));
  EXPECT_FALSE(fs::exists(dir / "clip_rgbd.mkv.json"));
}

TEST(Convert, frames_to_rgbd_warn_of_ranges) {
  const TempDir dir;
  expect_done(dir, {"render", "room", "--optics", "multiview", "--views", "3x1", "--size", "180x80", "--frames", "0-1", "--aov",
                    "depth", "-o", "a"});
  EXPECT_THAT(run_tool(dir, {"convert", "a", "b", "--to", "rgbd"}).err,
              HasSubstr("set one range for all frames with --depth-range"));
  EXPECT_EQ(run_tool(dir, {"convert", "a", "c", "--to", "rgbd", "--depth-range", "20:-60"}).err,
            "warning: not written, because rgbd cannot store them: 2 other views\n");
  EXPECT_EQ(bytes_of(dir / "c/frame_0000_rgbd.png.json"), bytes_of(dir / "c/frame_0001_rgbd.png.json"));
}

TEST(Convert, rgbd_fills_the_panel_behind_lenses) {
  const TempDir dir;
  std::ofstream(dir / "sheet.toml") << R"(kind = "lenticular-sheet"
pixels = [150, 100]
dpi = 60
view_cone_deg = 30
viewing_distance_mm = 500
[lenses]
lenses_per_inch = 8.2
)";
  expect_done(dir, {"render", "room", "--size", "60x40", "--frames", "0", "--layout", "rgbd", "-o", "a"});
  const Words to_sheet{"convert", "a/frame_0000_rgbd.png", "x.png", "--to", "integral", "--display", "sheet.toml"};
  EXPECT_EQ(report_of(dir, to_sheet)["views"], Json({8, 1})) << "60 / 8.2 = 7.3 pixels below a lens, rounded up";
  EXPECT_EQ(size_of(read_picture(dir / "x.png")), Vec2i(150, 100));
  EXPECT_EQ(report_of(dir, to_sheet + Words{"--views", "16x1"})["views"], Json({16, 1}));
  EXPECT_EQ(size_of(read_picture(dir / "x.png")), Vec2i(150, 100));
}

TEST(Convert, depth_is_inverted_by_both_methods) {
  const TempDir dir;
  expect_done(dir, small_teapot("0", "out"));
  EXPECT_EQ(report_of(dir, {"convert", "out", "turned", "--rotate-elemental"})["files"].size(), 2u);
  expect_done(dir, {"convert", "out", "smart", "--spoc", "8", "--lens-pixels", "12", "--gap", "3"});
  EXPECT_EQ(json_of(bytes_of(dir / "smart/report.json"))["optics"]["gap_mm"], 3.0);
  expect_refusal(run_tool(dir, {"convert", "out", "a", "--spoc", "8", "--reference-plane", "-1"}), 2, "--reference-plane");
  expect_refusal(run_tool(dir, {"convert", "out", "out", "--rotate-elemental"}), 1, "out: holds a render");
  expect_done(dir, {"convert", "out", "made", "--precompensate", "--crosstalk", "0.35"});
  EXPECT_TRUE(fs::exists(dir / "made/frame_0000.png"));
}

/// Writes a raw plenoptic picture with one bright spot per lens. The lenses are 10.4 pixels apart.
void write_lens_spots(const fs::path& path, int side) {
  Image8 codes{side, side, {}};
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const auto wave = [](int at) { return 0.5 - 0.5 * std::cos(6.283185307 * (at + 0.5) / 10.4); };
      codes.rgb.insert(codes.rgb.end(), 3, static_cast<unsigned char>(250.0 * wave(x) * wave(y)));
    }
  write_picture(path, codes);
}

TEST(Convert, plenoptic_grid_is_given_or_found) {
  const TempDir dir;
  write_lens_spots(dir / "raw.png", 104);
  write_lens_spots(dir / "white.png", 104);
  const Words convert{"convert", "raw.png", "views", "--from", "plenoptic", "--to", "views"};
  const Json given = report_of(dir, convert + Words{"--lens-pitch-px", "10.4", "--views", "9x9"});
  EXPECT_EQ(given["view_size"], Json({10, 10}));
  EXPECT_FALSE(given.contains("lens_grid"));
  fs::remove_all(dir / "views");
  const Json found = report_of(dir, convert + Words{"--white", "white.png"});
  EXPECT_NEAR(found["lens_grid"]["plenoptic"]["pitch_px"].get<double>(), 10.4, 0.01);
  EXPECT_LT(found["lens_grid"]["residual_px"].get<double>(), 0.1);
  fs::remove_all(dir / "views");
  EXPECT_THAT(run_tool(dir, convert + Words{"--white", "white.png", "--sampling", "lanczos"}).out,
              HasSubstr("lens grid: square"));
}

TEST(Convert, rendered_plenoptic_pictures_become_views) {
  const TempDir dir;
  expect_done(dir, {"render", "room", "--optics", "plenoptic", "--lenses", "16x12", "--lens-pixels", "5.5",
                    "--viewing-distance", "200", "--packing", "hexagonal", "--frames", "0", "-o", "out"});
  EXPECT_EQ(json_of(bytes_of(dir / "out/report.json"))["optics"]["distance_mm"], 200.0);
  EXPECT_NEAR(json_of(bytes_of(dir / "out/frame_0000.png.json"))["plenoptic"]["pitch_px"].get<double>(), 5.5, 1e-4);
  const Json views = report_of(dir, {"convert", "out", "views", "--to", "views"});
  EXPECT_EQ(views["views"], Json({5, 5}));
  EXPECT_EQ(views["files"].size(), 25u + 1u) << "and views.json";
}

TEST(Convert, rendered_plenoptic_pictures_keep_cameras_and_depth) {
  const TempDir dir;
  expect_done(dir, {"render", "room", "--optics", "plenoptic", "--lenses", "16x12", "--lens-pixels", "5", "--viewing-distance",
                    "200", "--frames", "0", "--aov", "depth", "-o", "out"});
  const RunResult run = run_tool(dir, {"convert", "out", "set", "--to", "nerf"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.err, "");
  EXPECT_TRUE(fs::exists(dir / "set/frame_0000/depth/024.npy"));
  EXPECT_EQ(json_of(bytes_of(dir / "set/frame_0000/transforms.json"))["frames"].size(), 25u);
}

TEST(Convert, plenoptic_flags_without_effect_are_refused) {
  const TempDir dir;
  write_lens_spots(dir / "raw.png", 104);
  const Words convert{"convert", "raw.png", "views", "--from", "plenoptic", "--to", "views"};
  expect_refusal(run_tool(dir, convert), 2, "--lens-pitch-px");
  expect_refusal(run_tool(dir, convert + Words{"--lens-rotation", "2"}), 2, "--lens-rotation");
  expect_refusal(run_tool(dir, convert + Words{"--lens-pitch-px", "10.4", "--lens-offset", "5"}), 2, "--lens-offset");
  expect_refusal(run_tool(dir, convert + Words{"--lens-pitch-px", "nan"}), 2, "--lens-pitch-px");
  expect_refusal(run_tool(dir, convert + Words{"--lens-pitch-px", "10.4", "--views", "12x12"}), 2, "--views");
  expect_refusal(run_tool(dir, {"convert", "raw.png", "v", "--from", "eslf", "--views", "8x8", "--to", "views", "--inverted"}),
                 2, "--inverted");
  expect_refusal(run_tool(dir, {"convert", "raw.png", "p.png", "--from", "eslf", "--views", "8x8", "--to", "plenoptic"}), 2,
                 "--to");
  EXPECT_FALSE(fs::exists(dir / "p.png"));
}

}  // namespace
}  // namespace lippmann::test
