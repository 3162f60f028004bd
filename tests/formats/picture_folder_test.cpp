#include "formats/picture_folder.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <limits>

#include "formats/light_field_source.hpp"
#include "formats/view_files.hpp"
#include "lippmann/formats/open_light_field.hpp"
#include "lippmann/image/picture_file.hpp"
#include "support/encode_image.hpp"
#include "support/error_message.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;
using test::error_message;
using test::TempDir;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

void write_bytes(const fs::path& path, const std::vector<unsigned char>& bytes) {
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

std::vector<unsigned char> grey_png(int width, int height, std::uint8_t code) {
  return test::encode_png(width, height, 1, std::vector<std::uint8_t>(static_cast<std::size_t>(width) * height, code));
}

/// Writes a PNG file of 4 x 3 equal pixels under any name.
void write_grey(const fs::path& path, std::uint8_t code) { write_bytes(path, grey_png(4, 3, code)); }

std::vector<int> codes_of_views(const LightField& field) {
  std::vector<int> codes;
  for (int view = 0; view < field.grid.count(); ++view) codes.push_back(std::get<Image8>(view_of(field, view)).rgb[0]);
  return codes;
}

TEST(PictureFolder, views_are_in_natural_order) {
  const TempDir dir;
  for (const int number : {10, 1, 2, 9}) write_grey(dir / (std::to_string(number) + ".jpg"), number);
  const OpenedLightField opened = open_light_field(dir.path(), "", {});
  EXPECT_EQ(opened.format, "views");
  EXPECT_EQ(opened.field.grid, (ViewGrid{4, 1}));
  EXPECT_THAT(codes_of_views(opened.field), ElementsAre(1, 2, 9, 10));
  EXPECT_EQ(open_light_field(dir.path(), "views", {.views = ViewGrid{2, 2}}).field.grid, (ViewGrid{2, 2}));
  EXPECT_THAT(error_message([&] {
                open_light_field(dir.path(), "views", {.views = ViewGrid{3, 1}});
              }),
              HasSubstr("3x1 does not match the 4 views"));
}

TEST(PictureFolder, sixteen_bits_are_kept) {
  const TempDir dir;
  for (const char* name : {"a.png", "b.png"}) write_picture(dir / name, Image16{1, 1, {1000, 2000, 3000}});
  const OpenedLightField opened = open_light_field(dir.path(), "", {});
  EXPECT_THAT(std::get<Image16>(view_of(opened.field, 1)).rgb, ElementsAre(1000, 2000, 3000));
}

TEST(PictureFolder, what_is_left_out_is_named_once) {
  const TempDir dir;
  for (const char* name : {"a.png", "b.png"}) write_grey(dir / name, 7);
  for (const char* name : {".DS_Store", "Thumbs.db", "notes.txt", "report.json"}) std::ofstream(dir / name) << "{";
  fs::create_directories(dir / "more/deep.png");
  write_grey(dir / "more/c.png", 8);
  std::vector<std::string> warnings;
  const auto warn = [&](std::string_view text) { warnings.emplace_back(text); };
  EXPECT_EQ(open_light_field(dir.path(), "views", {.warn = warn}).field.grid.count(), 2);
  EXPECT_THAT(warnings, ElementsAre(HasSubstr("from a.png to b.png; left out: Thumbs.db, more/, notes.txt, report.json.")));
}

TEST(PictureFolder, sizes_that_differ_are_listed) {
  const TempDir dir;
  for (int i = 1; i <= 9; ++i) write_grey(dir / (std::to_string(i) + ".png"), 1);
  write_bytes(dir / "2.png", grey_png(3, 4, 1));
  write_picture(dir / "8.png", Image16{4, 3, std::vector<std::uint16_t>(36)});
  EXPECT_THAT(error_message([&] { open_light_field(dir.path(), "", {}); }),
              HasSubstr("7 of its 9 pictures are 4x3 8-bit, but others differ: 2.png: 3x4 8-bit, 8.png: 4x3 16-bit; accepted"));
  for (int i = 10; i <= 20; ++i) write_bytes(dir / (std::to_string(i) + ".png"), grey_png(9, i, 1));
  EXPECT_THAT(error_message([&] { open_light_field(dir.path(), "", {}); }), HasSubstr("10.png: 9x10 8-bit, 11.png: 9x11 8-bit, "
                                                                                      "12.png: 9x12 8-bit and 8 more"));
}

TEST(PictureFolder, fewer_than_two_pictures_are_refused) {
  const TempDir dir;
  const auto message = [&] { return error_message([&] { open_light_field(dir.path(), "views", {}); }); };
  EXPECT_THAT(message(), HasSubstr("contains no views; accepted"));
  std::ofstream(dir / "IMG_1.CR2") << "x";
  EXPECT_THAT(message(), HasSubstr("contains no views, only IMG_1.CR2; accepted"));
  write_grey(dir / "a.png", 1);
  EXPECT_THAT(message(), HasSubstr("contains only one picture, a.png; accepted"));
  EXPECT_THAT(message(), HasSubstr("two or more pictures"));
  write_grey(dir / "a.jpg", 1);
  EXPECT_THAT(message(), HasSubstr("has two pictures with the same name: a.jpg and a.png"));
}

TEST(PictureFolder, pictures_are_listed_by_their_headers) {
  const TempDir dir;
  std::vector<unsigned char> png = grey_png(64, 64, 200);
  png.resize(png.size() - 20);
  for (const char* name : {"a.png", "b.png"}) write_bytes(dir / name, png);
  EXPECT_EQ(pictures_of_views(dir.path()).size(), 2u);
  EXPECT_THAT(error_message([&] { open_light_field(dir.path(), "", {}); }), HasSubstr("a.png: cannot be read as a picture"));
}

TEST(PictureFolder, accepts_folders_with_only_pictures) {
  const TempDir dir;
  write_grey(dir / "a.png", 1);
  EXPECT_FALSE(is_light_field_folder(dir.path())) << "one picture";
  write_grey(dir / "b.png", 1);
  fs::create_directories(dir / "originals");
  for (const char* name : {".hidden", "THUMBS.DB", "desktop.ini", "a.txt", "Notes.MD"}) std::ofstream(dir / name) << "x";
  EXPECT_TRUE(is_light_field_folder(dir.path()));
  for (const char* name : {"index.html", "report.json", "clip.mp4"}) {
    std::ofstream(dir / name) << "x";
    EXPECT_FALSE(is_light_field_folder(dir.path())) << name;
    fs::remove(dir / name);
  }
}

TEST(PictureFolder, named_frames_and_quilts_go_first) {
  const TempDir dir;
  write_grey(dir / "a_qs2x1a1.png", 1);
  write_grey(dir / "b.png", 1);
  EXPECT_THAT(light_field_frames(dir.path(), ""), ElementsAre(dir / "a_qs2x1a1.png"));
  write_grey(dir / "frame_0000.png", 1);
  EXPECT_THAT(light_field_frames(dir.path(), ""), ElementsAre(dir / "frame_0000.png"));
  EXPECT_THAT(light_field_frames(dir.path(), "views"), IsEmpty()) << "--from says that all of them are views";
}

TEST(StackOfViews, rejects_more_than_memory_or_indices) {
  constexpr double kGiB = 1024.0 * 1024.0 * 1024.0, kAny = std::numeric_limits<double>::infinity();
  const auto message = [](int views, Vec2i size, std::size_t bytes, double available) {
    return error_message([&] { require_stack_fits("dir", views, size, bytes, available); });
  };
  EXPECT_THAT(message(10000, {4000, 3000}, 1, kAny), HasSubstr("dir: 10000 views of 4000x3000 pixels are too many"));
  EXPECT_EQ(message(1, {65535, 65537}, 1, kAny), "(no Error)") << "2^32 - 1 pixels";
  EXPECT_THAT(message(1, {65536, 65536}, 1, kAny), HasSubstr("too many"));
  EXPECT_EQ(message(2, {16384, 16384}, 2, 3 * kGiB), "(no Error)") << "2^29 pixels of 6 bytes";
  EXPECT_THAT(message(2, {16384, 16384}, 2, 2.9 * kGiB), HasSubstr("need 3.0 GiB of memory, but 2.9 GiB are available"));
}

}  // namespace
}  // namespace lippmann
