#include "lippmann/formats/open_light_field.hpp"

#include <gmock/gmock.h>

#include <filesystem>

#include "layout/light_fields.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/image/picture_file.hpp"
#include "support/error_message.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

using test::numbered_field;
using test::same_samples;
using test::TempDir;

TEST(OpenLightField, detects_folders_and_quilts_by_name) {
  const TempDir dir;
  const LightField field = numbered_field({3, 2}, {4, 5});
  stanford_format().write(field, dir / "stanford", {});
  quilt_format().write(field, dir / "quilt.png", {});
  const OpenedLightField folder = open_light_field(dir / "stanford", "", {});
  EXPECT_EQ(folder.format, "stanford");
  EXPECT_EQ(folder.field.grid, field.grid);
  EXPECT_TRUE(same_samples(folder.field.stack, field.stack));
  EXPECT_FALSE(folder.optics.has_value());
  const OpenedLightField quilt = open_light_field(dir / "quilt_qs3x2a0.8.png", "", {});
  EXPECT_EQ(quilt.format, "quilt");
  EXPECT_TRUE(same_samples(quilt.field.stack, field.stack));
}

/// Writes 3 x 2 views as a quilt whose name does not state the number of tiles.
LightField write_plain_quilt(const TempDir& dir, const std::string& name) {
  const LightField field = numbered_field({3, 2}, {4, 5});
  quilt_format().write(field, dir / "made.png", {});
  std::filesystem::rename(dir / "made_qs3x2a0.8.png", dir / name);
  std::filesystem::rename(dir / "made_qs3x2a0.8.png.json", dir / (name + ".json"));
  return field;
}

TEST(OpenLightField, detects_quilt_by_side_file) {
  const TempDir dir;
  const LightField field = write_plain_quilt(dir, "plain.png");
  const OpenedLightField opened = open_light_field(dir / "plain.png", "", {});
  EXPECT_EQ(opened.format, "quilt");
  EXPECT_TRUE(same_samples(opened.field.stack, field.stack));
}

TEST(OpenLightField, names_of_copies_and_capitals_are_known) {
  const TempDir dir;
  const LightField pair = numbered_field({2, 1}, {6, 4});
  stereo_format().write(pair, dir / "s.png", {});
  std::filesystem::rename(dir / "s_2x1.png", dir / "S_2X1 (1).png");
  EXPECT_EQ(open_light_field(dir / "S_2X1 (1).png", "", {}).format, "stereo");
  for (const char* name : {"p_RGBD.png", "p_rgbd (2).png", "p_Rgbd - Copy.png"}) {
    Image8 picture{8, 2, std::vector<unsigned char>(48, 90)};
    write_picture(dir / name, picture);
    EXPECT_EQ(open_light_field(dir / name, "", {}).format, "rgbd") << name;
  }
}

TEST(OpenLightField, folder_of_described_pictures_holds_them_all) {
  const TempDir dir;
  std::filesystem::create_directories(dir / "batch");
  Image8 picture{8, 2, std::vector<unsigned char>(48, 90)};
  for (const char* name : {"batch/IMG_10_rgbd.png", "batch/IMG_9_rgbd.png", "batch/notes.png"})
    write_picture(dir / name, picture);
  const auto frames = light_fields_in(dir / "batch", "");
  ASSERT_EQ(frames.size(), 2u);
  EXPECT_EQ(frames[0].filename(), "IMG_9_rgbd.png");
  EXPECT_EQ(light_fields_in(dir / "batch", "rgbd").size(), 3u) << "--from says what all of them are";
}

TEST(OpenLightField, jpeg_pleno_folder_of_png_pictures) {
  const TempDir dir;
  const LightField field = numbered_field({3, 2}, {4, 5});
  std::filesystem::create_directories(dir / "p");
  for (int i = 0; i < 6; ++i)
    write_picture(dir / ("p/00" + std::to_string(i % 3) + "_00" + std::to_string(i / 3) + ".png"),
                  view_of(field, from_top_left(field.grid, i)));
  const OpenedLightField opened = open_light_field(dir / "p", "", {});
  EXPECT_EQ(opened.format, "jpeg-pleno");
  EXPECT_TRUE(same_samples(opened.field.stack, field.stack));
}

TEST(OpenLightField, reports_missing_files) {
  const TempDir dir;
  EXPECT_THAT(test::error_message([&] { open_light_field(dir / "nosuch", "", {}); }), testing::HasSubstr("no such file"));
}

TEST(OpenLightField, lists_frames_of_a_folder) {
  const TempDir dir;
  const LightField field = numbered_field({2, 1}, {4, 4});
  std::filesystem::create_directories(dir / "frames");
  for (const char* name : {"frame_0001", "frame_0000"}) stanford_format().write(field, dir / "frames" / name, {});
  const auto frames = light_fields_in(dir / "frames", "");
  ASSERT_EQ(frames.size(), 2u);
  EXPECT_EQ(frames[0].filename(), "frame_0000");
  EXPECT_EQ(light_fields_in(dir / "frames/frame_0001", ""), std::vector{dir / "frames/frame_0001"});
  EXPECT_THROW(light_fields_in(dir / "nowhere", ""), Error);
  EXPECT_THROW(light_fields_in(dir.path(), ""), Error);
}

}  // namespace
}  // namespace lippmann
