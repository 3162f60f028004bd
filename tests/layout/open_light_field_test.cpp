// Light fields whose format nobody names: files say it.
#include "lippmann/layout/open_light_field.hpp"

#include <gmock/gmock.h>

#include <filesystem>

#include "layout/light_fields.hpp"
#include "lippmann/core/error.hpp"
#include "support/error_message.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

using test::numbered_field;
using test::same_samples;
using test::TempDir;

TEST(OpenLightField, folders_and_quilts_are_known_by_their_names) {
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

TEST(OpenLightField, what_is_not_there_is_said_not_to_be_there) {
  const TempDir dir;
  EXPECT_THAT(test::error_message([&] { open_light_field(dir / "nosuch", "", {}); }), testing::HasSubstr("no such file"));
}

TEST(OpenLightField, a_folder_of_frames_has_one_for_each_and_others_themselves) {
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
