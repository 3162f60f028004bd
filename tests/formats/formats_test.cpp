// Tests that every light field format restores the views written to it, also through every other format.
#include "lippmann/formats/formats.hpp"

#include <gmock/gmock.h>

#include <fstream>

#include "image/netpbm.hpp"
#include "image/png.hpp"
#include "layout/light_fields.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/formats/convert.hpp"
#include "lippmann/formats/open_light_field.hpp"
#include "support/error_message.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;
using test::error_message;
using test::numbered_field;
using test::same_samples;
using test::TempDir;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const LightFieldFormat& format(const std::string& name) { return find_format(name, "--from"); }

/// Returns uniform views. Red is the view's column and green its row.
LightField coloured_field(ViewGrid grid) {
  LightField field = numbered_field(grid, {2, 2});
  for (int view = 0; view < grid.count(); ++view) {
    Image8 flat{2, 2, std::vector<unsigned char>(12, 77)};
    for (std::size_t i = 0; i < 12; i += 3) {
      flat.rgb[i] = static_cast<unsigned char>(view % grid.columns);
      flat.rgb[i + 1] = static_cast<unsigned char>(view / grid.columns);
    }
    set_view(field, view, flat);
  }
  return field;
}

Vec2i view_in(const fs::path& path) {
  const Image8 image = std::get<Image8>(read_picture(path));
  return {image.rgb[0], image.rgb[1]};
}

/// Returns the formats that hold any views exactly. Other formats have a fixed number of views, hold parts of views, or
/// cannot store off-axis cameras. They have their own tests.
std::vector<LightFieldFormat> exact_formats() {
  std::vector<LightFieldFormat> formats = light_field_formats();
  std::erase_if(formats, [](const LightFieldFormat& format) {
    return format.name == "native" || format.name == "stereo" || format.name == "quad" || format.name == "rgbd" ||
           format.name == "plenoptic" || format.name == "hci-hdf5" || format.name == "llff";
  });
  return formats;
}

/// Returns views in which all samples differ, with cameras because MIV requires them.
LightField numbered_views(bool words = false) {
  LightField field = numbered_field({3, 2}, {4, 5}, words);
  field.cameras = {500.0, Vec2d(0.5), Vec2d(2.0, 2.5), {}};
  for (int view = 0; view < 6; ++view) field.cameras->eyes_mm.emplace_back(10.0 * (view % 3 - 1), 10.0 * (view / 3) - 5.0);
  return field;
}

/// A format without cameras cannot be converted to a format that requires them.
bool can_follow(const LightFieldFormat& from, const LightFieldFormat& to) {
  const auto needs_cameras = [](const LightFieldFormat& format) {
    return format.name == "miv" || format.name == "cvkit" || format.name == "nerf" || format.name == "colmap";
  };
  return !needs_cameras(to) || from.name == "hci" || needs_cameras(from);
}

TEST(Formats, every_one_brings_back_what_was_written) {
  for (const bool words : {false, true})
    for (const LightFieldFormat& one : exact_formats()) {
      const TempDir dir;
      const LightField field = numbered_views(words);
      const fs::path path = one.write(field, dir / (one.is_folder ? "field" : "field.png"), {}).front();
      const LightField back = one.read(one.is_folder ? dir / "field" : path, {.views = ViewGrid{3, 2}});
      EXPECT_EQ(back.grid, field.grid) << one.name;
      EXPECT_TRUE(same_samples(back.stack, field.stack)) << one.name;
    }
}

TEST(Formats, every_pair_is_exact_there_and_back) {
  const LightField field = numbered_views();
  const std::vector<LightFieldFormat> formats = exact_formats();
  for (std::size_t i = 0; i < formats.size(); ++i)
    for (std::size_t k = i; k < formats.size(); ++k) {
      const LightFieldFormat &one = formats[i], &other = formats[k];
      if (!can_follow(one, other) || !can_follow(other, one)) continue;
      const TempDir dir;
      const auto path_of = [&](const LightFieldFormat& f, const char* stem) {
        return dir / (std::string(stem) + (f.is_folder ? "" : f.name == "quilt" ? "_qs3x2a0.8.png" : ".png"));
      };
      one.write(field, path_of(one, "a"), {});
      ConvertParams there, back;
      there.from = back.to = one.name, there.to = back.from = other.name;
      there.options.views = back.options.views = ViewGrid{3, 2};
      there.options.aspect = back.options.aspect = 0.8;
      convert(path_of(one, "a"), path_of(other, "b"), there);
      convert(path_of(other, "b"), path_of(one, "c"), back);
      const LightField read = one.read(path_of(one, "c"), {.views = ViewGrid{3, 2}});
      EXPECT_TRUE(same_samples(read.stack, field.stack)) << one.name << " " << other.name;
    }
}

TEST(Formats, folders_number_views_from_the_top_left) {
  const TempDir dir;
  const LightField field = coloured_field({3, 2});
  format("hci").write(field, dir / "hci", {});
  EXPECT_EQ(view_in(dir / "hci/input_Cam000.png"), Vec2i(0, 1));
  EXPECT_EQ(view_in(dir / "hci/input_Cam002.png"), Vec2i(2, 1));
  EXPECT_EQ(view_in(dir / "hci/input_Cam003.png"), Vec2i(0, 0));
  format("stanford").write(field, dir / "stanford", {});
  EXPECT_EQ(view_in(dir / "stanford/out_00_02_0.000000_2.000000.png"), Vec2i(2, 1));
  EXPECT_EQ(view_in(dir / "stanford/out_01_00_1.000000_0.000000.png"), Vec2i(0, 0));
  format("jpeg-pleno").write(field, dir / "pleno", {});
  EXPECT_EQ(view_in(dir / "pleno/001_000.ppm"), Vec2i(1, 1)) << "columns before rows, as JPLM and WaSP name them";
  EXPECT_EQ(view_in(dir / "pleno/002_001.ppm"), Vec2i(2, 0));
  EXPECT_TRUE(same_samples(format("jpeg-pleno").read(dir / "pleno", {}).stack, field.stack));
}

TEST(Formats, eslf_takes_nth_pixels_and_integral_inverts) {
  const TempDir dir;
  const LightField field = coloured_field({3, 2});
  format("eslf").write(field, dir / "eslf.png", {});
  format("integral").write(field, dir / "integral.png", {});
  const Image8 eslf = std::get<Image8>(read_picture(dir / "eslf.png"));
  const Image8 integral = std::get<Image8>(read_picture(dir / "integral.png"));
  for (int y = 0; y < eslf.height; ++y)
    for (int x = 0; x < eslf.width; ++x) {
      const std::size_t at = 3 * static_cast<std::size_t>(y * eslf.width + x);
      EXPECT_EQ(Vec2i(eslf.rgb[at], eslf.rgb[at + 1]), Vec2i(x % 3, 1 - y % 2));
      EXPECT_EQ(Vec2i(integral.rgb[at], integral.rgb[at + 1]), Vec2i(2 - x % 3, y % 2));
    }
}

TEST(Formats, stanford_names_with_trailing_underscore) {
  const TempDir dir;
  const Image8 picture = std::get<Image8>(numbered_field({1, 1}, {2, 2}).stack);
  for (const char* name :
       {"out_00_00_-780.134705_-3355.331299_.png", "out_00_01_-780.1_-3300.3_.png", "out_01_00_-700.1_-3355.3_.png"})
    write_png(dir / name, picture);
  EXPECT_THAT(error_message([&] { format("stanford").read(dir.path(), {}); }),
              AllOf(HasSubstr("row 1, column 1"), HasSubstr("missing")));
  write_png(dir / "out_01_01_-700_-3300_.png", picture);
  EXPECT_EQ(format("stanford").read(dir.path(), {}).grid, (ViewGrid{2, 2}));
}

TEST(Formats, hci_folders_default_to_squares) {
  const TempDir dir;
  const LightField field = numbered_field({3, 3}, {2, 2});
  format("hci").write(field, dir / "a", {});
  EXPECT_EQ(format("hci").read(dir / "a", {}).grid, (ViewGrid{3, 3}));
  fs::remove(dir / "a/input_Cam008.png");
  EXPECT_THAT(error_message([&] { format("hci").read(dir / "a", {}); }), HasSubstr("do not form a square"));
  fs::remove(dir / "a/input_Cam004.png");
  EXPECT_THAT(error_message([&] { format("hci").read(dir / "a", {}); }), HasSubstr("input_Cam004.png is missing"));
}

TEST(JpegPleno, restores_10_bit_samples_from_16_bits) {
  const TempDir dir;
  fs::create_directories(dir / "in");
  PpmCodes ppm{{32, 32, {}}, 1023};
  for (int i = 0; i < 3 * 32 * 32; ++i) ppm.codes.rgb.push_back(static_cast<std::uint16_t>(i % 1024));
  write_ppm(dir / "in/000_000.ppm", ppm);
  ConvertParams to_views;
  to_views.from = "jpeg-pleno", to_views.to = "views";
  convert(dir / "in", dir / "views", to_views);
  const Image16 png = std::get<Image16>(read_picture(dir / "views/view_000.png"));
  EXPECT_EQ(png.rgb[1023], 65535) << "the highest code is white in both";
  ConvertParams back;
  back.from = "views", back.to = "jpeg-pleno", back.options.bits = 10;
  convert(dir / "views", dir / "back", back);
  EXPECT_EQ(read_ppm(dir / "back/000_000.ppm").codes.rgb, ppm.codes.rgb);
  EXPECT_EQ(read_ppm(dir / "back/000_000.ppm").highest, 1023);
}

TEST(Quilt, side_file_adds_to_the_name) {
  const TempDir dir;
  const LightField field = coloured_field({5, 1});
  LightField six = coloured_field({6, 1});
  const fs::path written = format("quilt").write(six, dir / "q.png", {.tiles = ViewGrid{3, 2}, .aspect = 0.75}).front();
  EXPECT_TRUE(fs::exists(dir / "q_qs3x2a0.75.png.json"));
  fs::rename(written, dir / "plain.png");
  std::ofstream(dir / "plain.png.json")
      << R"({"mediaType":"image","quilt_settings":{"viewX":3,"viewY":2,"viewTotal":5,"aspect":0.75,"invertViews":false}})";
  const LightField back = format("quilt").read(dir / "plain.png", {});
  EXPECT_EQ(back.grid, (ViewGrid{5, 1}));
  EXPECT_EQ(back.aspect, 0.75);
  EXPECT_TRUE(same_samples(back.stack, field.stack));
}

TEST(Quilt, side_files_of_other_tools_are_read) {
  const TempDir dir;
  const fs::path written = format("quilt").write(coloured_field({6, 1}), dir / "q.png", {.tiles = ViewGrid{3, 2}}).front();
  fs::rename(written, dir / "plain.png");
  for (const char* json :
       {R"({"columns":3,"rows":2,"aspect":0.75})", R"({"quiltCols":3,"quiltRows":2,"aspect":0.75})",
        R"({"viewX":3,"viewY":2,"viewTotal":6,"aspect":0.75})", R"({"quilt":{"columns":3,"rows":2,"aspect":0.75}})"}) {
    std::ofstream(dir / "plain.png.json") << json;
    const OpenedLightField opened = open_light_field(dir / "plain.png", "", {});
    EXPECT_EQ(opened.format, "quilt") << json;
    EXPECT_EQ(opened.field.tiles, (ViewGrid{3, 2})) << json;
    EXPECT_EQ(opened.field.aspect, 0.75) << json;
  }
  std::ofstream(dir / "plain.png.json") << R"({"tiles":"3 by 2"})";
  for (const char* from : {"", "quilt"})
    EXPECT_THAT(error_message([&] { open_light_field(dir / "plain.png", from, {}); }),
                AllOf(HasSubstr("plain.png.json"), HasSubstr("viewX")))
        << from;
}

TEST(Quilt, inverted_views_are_turned_round) {
  const TempDir dir;
  const fs::path written = format("quilt").write(coloured_field({4, 1}), dir / "q.png", {.tiles = ViewGrid{2, 2}}).front();
  std::ofstream(written.string() + ".json")
      << R"({"quilt_settings":{"viewX":2,"viewY":2,"viewTotal":4,"aspect":1,"invertViews":true}})";
  const LightField back = format("quilt").read(written, {});
  for (int view = 0; view < 4; ++view) EXPECT_EQ(std::get<Image8>(view_of(back, view)).rgb[0], 3 - view);
}

TEST(Quilt, inverted_grids_keep_their_rows) {
  const TempDir dir;
  const fs::path written = format("quilt").write(coloured_field({3, 2}), dir / "q.png", {}).front();
  std::ofstream(written.string() + ".json")
      << R"({"quilt_settings":{"viewX":3,"viewY":2,"viewTotal":6,"invertViews":true},"grid":{"columns":3,"rows":2}})";
  const LightField back = format("quilt").read(written, {});
  for (int view = 0; view < 6; ++view) {
    EXPECT_EQ(std::get<Image8>(view_of(back, view)).rgb[0], 2 - view % 3);
    EXPECT_EQ(std::get<Image8>(view_of(back, view)).rgb[1], view / 3);
  }
}

TEST(Quilt, side_file_keeps_the_grid) {
  const TempDir dir;
  const LightField field = coloured_field({4, 5});
  for (const std::optional<ViewGrid>& tiles : {std::optional<ViewGrid>(), std::optional(ViewGrid{10, 2})}) {
    const fs::path written = format("quilt").write(field, dir / "q.png", {.tiles = tiles}).front();
    const LightField back = open_light_field(written, "", {}).field;
    EXPECT_EQ(back.grid, field.grid);
    EXPECT_EQ(back.tiles, tiles.value_or(field.grid));
    EXPECT_TRUE(same_samples(back.stack, field.stack));
    EXPECT_EQ(open_light_field(written, "", {.views = ViewGrid{20, 1}}).field.grid, (ViewGrid{20, 1}));
  }
}

TEST(Quilt, one_row_needs_no_grid_in_the_side_file) {
  const TempDir dir;
  const fs::path written = format("quilt").write(coloured_field({4, 1}), dir / "q.png", {}).front();
  std::ifstream side(written.string() + ".json");
  EXPECT_THAT(std::string(std::istreambuf_iterator<char>(side), {}), Not(HasSubstr("grid")));
}

TEST(Quilt, rejects_conflicting_name_and_side_file) {
  const TempDir dir;
  const fs::path written = format("quilt").write(coloured_field({6, 1}), dir / "q.png", {.tiles = ViewGrid{3, 2}}).front();
  const auto refusal = [&](const char* json) {
    std::ofstream(written.string() + ".json") << json;
    return error_message([&] { format("quilt").read(written, {}); });
  };
  EXPECT_THAT(refusal(R"({"quilt_settings":{"viewX":2,"viewY":3}})"), AllOf(HasSubstr("3x2"), HasSubstr("2x3")));
  EXPECT_THAT(refusal(R"({"quilt_settings":{"viewX":0,"viewY":3}})"), HasSubstr("quilt_settings.viewX"));
  EXPECT_THAT(refusal(R"({"quilt_settings":{"viewX":3,"viewY":2,"viewTotal":7}})"),
              HasSubstr("quilt_settings.viewTotal: is 7"));
  EXPECT_THAT(refusal(R"({"quilt_settings":{"viewX":3,"viewY":2},"grid":{"columns":2,"rows":2}})"),
              AllOf(HasSubstr("grid: has 2x2 views"), HasSubstr("6")));
  EXPECT_THAT(refusal(R"({"quilt_settings":{"viewX":3,"viewY":2},"grid":{"columns":6}})"), HasSubstr("grid.rows"));
  EXPECT_THAT(refusal(R"({"quilt_settings":{"viewX":"a"}})"), HasSubstr("quilt_settings.viewX: is not a number"));
  EXPECT_THAT(refusal("{"), HasSubstr("not JSON"));
}

TEST(Quilt, drops_padding_at_right_and_top) {
  const TempDir dir;
  Image8 picture{7, 5, std::vector<unsigned char>(3 * 7 * 5)};
  for (int y = 0; y < 5; ++y)
    for (int x = 0; x < 7; ++x) picture.rgb[3 * static_cast<std::size_t>(y * 7 + x)] = static_cast<unsigned char>(10 * y + x);
  write_png(dir / "other_qs2x2a1.png", picture);
  std::string warning;
  const LightField field = format("quilt").read(dir / "other_qs2x2a1.png",
                                                {.warn = [&warning](std::string_view text) { warning = std::string(text); }});
  EXPECT_THAT(warning, HasSubstr("1 columns at the right and 1 rows at the top are left out"));
  EXPECT_EQ(field.view_size, Vec2i(3, 2));
  EXPECT_EQ(std::get<Image8>(view_of(field, 0)).rgb[0], 30) << "bottom left tile: its top row is row 3";
  EXPECT_EQ(std::get<Image8>(view_of(field, 3)).rgb[0], 13) << "top right tile: row 1, column 3";
}

TEST(FindFormat, unknown_name_suggests_the_nearest) {
  EXPECT_THAT(error_message([] { find_format("stamford", "--to"); }),
              AllOf(HasSubstr("--to"), HasSubstr("did you mean 'stanford'"), HasSubstr("jpeg-pleno")));
}

}  // namespace
}  // namespace lippmann
