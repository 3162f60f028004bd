#include "lippmann/formats/convert.hpp"

#include <gmock/gmock.h>

#include <fstream>

#include "image/exr.hpp"
#include "image/png.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/image/picture_file.hpp"
#include "support/error_message.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;
using test::TempDir;
using testing::AllOf;
using testing::HasSubstr;

/// Returns a picture in which neighbouring samples and rows differ.
Image8 picture8(int width, int height) {
  Image8 image{width, height, {}};
  for (int i = 0; i < 3 * width * height; ++i) image.rgb.push_back(static_cast<unsigned char>(i * 7 + i / 256));
  return image;
}

Image16 picture16(int width, int height) {
  Image16 image{width, height, {}};
  for (int i = 0; i < 3 * width * height; ++i) image.rgb.push_back(static_cast<std::uint16_t>(i * 257 + 13));
  return image;
}

Image8 read8(const fs::path& path) { return std::get<Image8>(read_picture(path)); }

ConvertParams params(const char* from, const char* to, std::optional<ViewGrid> views = {}, std::optional<ViewGrid> tiles = {}) {
  ConvertParams params;
  params.from = from, params.to = to;
  params.options.views = views, params.options.tiles = tiles;
  return params;
}
constexpr const char *kIntegral = "integral", *kQuilt = "quilt", *kViews = "views";

TEST(Convert, integral_views_quilt_round_trip_is_exact) {
  const TempDir dir;
  const Image8 original = picture8(8 * 4, 6);
  write_png(dir / "in.png", original);
  const Converted views = convert(dir / "in.png", dir / "views", params(kIntegral, kViews, ViewGrid{8, 1}));
  EXPECT_EQ(views.written.size(), 8u + 1u) << "and views.json, because pixels are not square";
  EXPECT_EQ(views.view_size, Vec2i(4, 6));
  const Converted quilt = convert(dir / "views", dir / "q.png", params(kViews, kQuilt, {}, ViewGrid{4, 2}));
  EXPECT_EQ(quilt.written.front().filename(), "q_qs4x2a5.33333.png");
  convert(quilt.written.front(), dir / "back.png", params(kQuilt, kIntegral));
  EXPECT_EQ(read8(dir / "back.png").rgb, original.rgb);
}

TEST(Convert, batch_endings_suit_the_samples) {
  const TempDir dir;
  fs::create_directories(dir / "b");
  for (const char* name : {"b/v1.0_qs2x1a2.ppm", "b/w_qs2x1a2 (1).ppm"})
    std::ofstream(dir / name, std::ios::binary) << "P6\n4 1\n255\nabcdefghijkl";
  EXPECT_EQ(convert(dir / "b", dir / "out", params("", kIntegral)).written.size(), 2u);
  EXPECT_TRUE(fs::exists(dir / "out/v1.0.png"));
  EXPECT_TRUE(fs::exists(dir / "out/w (1).png"));
}

TEST(Convert, stanford_positions_are_kept) {
  const TempDir dir;
  fs::create_directories(dir / "in");
  const char* names[] = {"out_00_00_-381.909271_1103.376221_.png", "out_00_01_-381.909271_1043.262939.png",
                         "out_01_00_-311.250000_1103.376221_.png", "out_01_01_-311.250000_1043.262939_.png"};
  for (const char* name : names) write_png(dir / "in" / name, picture8(4, 3));
  convert(dir / "in", dir / "all", params("stanford", "stanford"));
  EXPECT_TRUE(fs::exists(dir / "all/out_00_00_-381.909271_1103.376221.png"));
  EXPECT_TRUE(fs::exists(dir / "all/out_01_01_-311.250000_1043.262939.png"));
  EXPECT_FALSE(fs::exists(dir / "all/parameters.cfg")) << "the distance of the cameras is unknown";
  ConvertParams column = params("stanford", "stanford");
  column.keep = read_kept_views("1x0-1", "--keep");
  convert(dir / "in", dir / "column", column);
  EXPECT_TRUE(fs::exists(dir / "column/out_00_00_-381.909271_1043.262939.png"));
  EXPECT_TRUE(fs::exists(dir / "column/out_01_00_-311.250000_1043.262939.png"));
}

TEST(Convert, regular_cameras_survive_the_way_over_stanford) {
  const TempDir dir;
  fs::create_directories(dir / "hci");
  for (int i = 0; i < 4; ++i) write_png(dir / "hci" / ("input_Cam00" + std::to_string(i) + ".png"), picture8(4, 4));
  std::ofstream(dir / "hci/parameters.cfg") << "focal_length_mm = 100\nimage_resolution_x_px = 4\nimage_resolution_y_px = 4\n"
                                               "sensor_size_mm = 35\nfstop = 100\nnum_cams_x = 2\nnum_cams_y = 2\n"
                                               "baseline_mm = 6\nfocus_distance_m = 1.15\n";
  convert(dir / "hci", dir / "s", params("hci", "stanford"));
  convert(dir / "s", dir / "back", params("stanford", "hci"));
  std::ifstream text(dir / "back/parameters.cfg");
  const std::string parameters{std::istreambuf_iterator<char>(text), {}};
  EXPECT_THAT(parameters, testing::AllOf(HasSubstr("baseline_mm = 6\n"), HasSubstr("focus_distance_m = 1.15"),
                                         HasSubstr("num_cams_x = 2\n")));
}

TEST(Convert, two_dimensional_views_keep_their_grid) {
  const TempDir dir;
  const Image8 original = picture8(3 * 4, 2 * 5);
  write_png(dir / "in.png", original);
  const Converted quilt = convert(dir / "in.png", dir / "q.png", params(kIntegral, kQuilt, ViewGrid{3, 2}));
  EXPECT_THAT(quilt.written.front().filename().string(), HasSubstr("_qs3x2a1.2."));
  convert(quilt.written.front(), dir / "back.png", params(kQuilt, kIntegral, ViewGrid{3, 2}));
  EXPECT_EQ(read8(dir / "back.png").rgb, original.rgb);
}

TEST(Convert, keeps_16_bits_and_floats) {
  const TempDir dir;
  const Image16 words = picture16(6, 2);
  write_png(dir / "w.png", words);
  convert(dir / "w.png", dir / "w", params(kIntegral, kViews, ViewGrid{3, 1}));
  convert(dir / "w", dir / "w2.png", params(kViews, kIntegral));
  EXPECT_EQ(std::get<Image16>(read_picture(dir / "w2.png")).rgb, words.rgb);

  Image floats(6, 2, 3);
  for (std::size_t i = 0; i < floats.data.size(); ++i) floats.data[i] = 0.001f * static_cast<float>(i * i) + 1e-7f;
  const std::vector<ExrLayer> layers{film_layer(floats, ExrSample::kFloat)};
  write_exr(dir / "f.exr", layers);
  convert(dir / "f.exr", dir / "f", params(kIntegral, kViews, ViewGrid{2, 1}));
  convert(dir / "f", dir / "f2.exr", params(kViews, kIntegral));
  EXPECT_EQ(std::get<Image>(read_picture(dir / "f2.exr")).data, floats.data);
}

TEST(Convert, every_frame_of_a_folder_is_converted) {
  const TempDir dir;
  fs::create_directories(dir / "in");
  write_png(dir / "in/frame_0000.png", picture8(4, 2));
  write_png(dir / "in/frame_0001.png", picture8(4, 2));
  std::ofstream(dir / "in/report.json") << "{}";
  EXPECT_EQ(convert(dir / "in", dir / "views", params(kIntegral, kViews, ViewGrid{2, 1})).written.size(), 2u * (2u + 1u));
  EXPECT_TRUE(fs::exists(dir / "views/frame_0001/view_001.png"));
  convert(dir / "in", dir / "quilts", params(kIntegral, kQuilt, ViewGrid{2, 1}));
  EXPECT_TRUE(fs::exists(dir / "quilts/frame_0001_qs2x1a2.png"));
}

TEST(Convert, one_frame_of_a_folder_becomes_a_picture) {
  const TempDir dir;
  fs::create_directories(dir / "in");
  write_png(dir / "in/frame_0003.png", picture8(4, 2));
  convert(dir / "in", dir / "quilt.png", params(kIntegral, kQuilt, ViewGrid{2, 1}));
  EXPECT_TRUE(fs::is_regular_file(dir / "quilt_qs2x1a2.png"));
  write_png(dir / "in/frame_0004.png", picture8(4, 2));
  EXPECT_THAT(test::error_message([&] {
                convert(dir / "in", dir / "two.png", params(kIntegral, kQuilt, ViewGrid{2, 1}));
              }),
              AllOf(HasSubstr("two.png: is the name of one picture"), HasSubstr("has 2 frames"), HasSubstr("frame_0003.png")));
}

void expect_refusal(const fs::path& in, const fs::path& out, const ConvertParams& how, const std::string& where,
                    const std::string& problem) {
  try {
    convert(in, out, how);
    ADD_FAILURE() << "accepted";
  } catch (const Error& error) {
    EXPECT_THAT(error.where(), HasSubstr(where));
    EXPECT_THAT(error.problem(), HasSubstr(problem));
  }
  EXPECT_FALSE(fs::exists(out));
}

TEST(Convert, what_cannot_be_is_refused) {
  const TempDir dir;
  write_png(dir / "in.png", picture8(10, 4));
  expect_refusal(dir / "in.png", dir / "o.png", params(kIntegral, kQuilt), "views", "is unknown");
  expect_refusal(dir / "in.png", dir / "o.png", params(kIntegral, kQuilt, ViewGrid{3, 1}), "in.png", "10x4");
  expect_refusal(dir / "in.png", dir / "o.png", params(kQuilt, kIntegral), "quilt", "is unknown");
  expect_refusal(dir / "in.png", dir / "o.png", params(kQuilt, kIntegral, ViewGrid{3, 1}, ViewGrid{2, 2}), "views",
                 "do not match");
  expect_refusal(dir / "in.png", dir / "o.png", params(kIntegral, kQuilt, ViewGrid{2, 1}, ViewGrid{3, 1}), "quilt",
                 "do not match");
  expect_refusal(dir / "in.png", dir / "o.exr", params(kIntegral, kIntegral, ViewGrid{2, 1}), "o.exr",
                 "cannot store the samples unchanged");
  expect_refusal(dir / "missing.png", dir / "o.png", params(kIntegral, kQuilt, ViewGrid{2, 1}), "missing.png", "");
  expect_refusal(dir / "none", dir / "o.png", params(kViews, kQuilt), "none", "cannot be listed");
}

TEST(Convert, missing_and_unequal_views_are_refused) {
  const TempDir dir;
  for (const char* folder : {"gap", "size", "kind", "twice"}) {
    fs::create_directories(dir / folder);
    write_png(dir / folder / "view_000.png", picture8(2, 2));
  }
  write_png(dir / "gap/view_002.png", picture8(2, 2));
  write_png(dir / "size/view_001.png", picture8(2, 3));
  write_png(dir / "kind/view_001.png", picture16(2, 2));
  write_png(dir / "twice/view_0.png", picture8(2, 2));
  expect_refusal(dir / "gap", dir / "o.png", params(kViews, kQuilt), "gap", "missing");
  expect_refusal(dir / "size", dir / "o.png", params(kViews, kQuilt), "view_001.png",
                 "differs from the other views in size or sample type");
  expect_refusal(dir / "kind", dir / "o.png", params(kViews, kQuilt), "view_001.png",
                 "differs from the other views in size or sample type");
  expect_refusal(dir / "twice", dir / "o.png", params(kViews, kQuilt), "twice", "two pictures for view 0");
}

TEST(Convert, only_quilts_are_named_like_quilts) {
  const TempDir dir;
  fs::create_directories(dir / "in");
  write_png(dir / "in/frame_0000_qs4x1a2.png", picture8(16, 2));
  const Converted converted = convert(dir / "in", dir / "out", params("", kIntegral));
  EXPECT_EQ(converted.written.front().filename(), "frame_0000.png");
  EXPECT_THAT(
      test::error_message([&] { convert(dir / "in/frame_0000_qs4x1a2.png", dir / "a_qs4x1a2.png", params("", kIntegral)); }),
      HasSubstr("a_qs4x1a2.png is a quilt name"));
}

TEST(Convert, detects_view_folders_by_file_names) {
  const TempDir dir;
  const Image8 original = picture8(3 * 4, 3 * 5);
  write_png(dir / "in.png", original);
  for (const char* format : {"hci", "stanford", "jpeg-pleno"}) {
    convert(dir / "in.png", dir / format, params(kIntegral, format, ViewGrid{3, 3}));
    convert(dir / format, dir / "back.png", params("", kIntegral));
    EXPECT_EQ(read8(dir / "back.png").rgb, original.rgb) << format;
  }
}

}  // namespace
}  // namespace lippmann
