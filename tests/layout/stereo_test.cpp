#include "lippmann/layout/stereo.hpp"

#include <gmock/gmock.h>

#include "layout/light_fields.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/formats/convert.hpp"
#include "lippmann/formats/open_light_field.hpp"
#include "support/error_message.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

using test::error_message;
using test::numbered_field;
using test::same_samples;
using test::TempDir;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr std::array kPackings{StereoPacking::kSideBySide, StereoPacking::kHalfSideBySide, StereoPacking::kOverUnder,
                               StereoPacking::kHalfOverUnder, StereoPacking::kRows};

std::vector<StereoLayout> all_layouts() {
  std::vector<StereoLayout> layouts;
  for (const StereoPacking packing : kPackings)
    for (const bool right_first : {false, true}) layouts.push_back({packing, right_first});
  return layouts;
}

LightField flat_pair(Vec2i size, unsigned char left, unsigned char right) {
  LightField field = numbered_field({2, 1}, size);
  const std::size_t samples = 3 * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
  set_view(field, 0, Image8{size.x, size.y, std::vector<unsigned char>(samples, left)});
  set_view(field, 1, Image8{size.x, size.y, std::vector<unsigned char>(samples, right)});
  return field;
}

Image8 written_as(const LightField& field, const StereoLayout& layout) {
  const TempDir dir;
  FormatOptions options;
  options.stereo = layout;
  return std::get<Image8>(read_picture(stereo_format().write(field, dir / "pair.png", options).front()));
}

int red(const Image8& image, int x, int y) { return image.rgb[static_cast<std::size_t>(3 * (y * image.width + x))]; }

TEST(Stereo, parses_and_writes_names) {
  EXPECT_EQ(with_stereo_name("a/room.png", {StereoPacking::kHalfSideBySide}), "a/room_half_2x1.png");
  EXPECT_EQ(with_stereo_name("room_ou.png", {StereoPacking::kSideBySide, true}), "room_2x1_rl.png");
  for (const StereoLayout& layout : all_layouts()) {
    const auto path = with_stereo_name("a/room.b.png", layout);
    EXPECT_EQ(parse_stereo_name(path), layout) << path;
    EXPECT_EQ(without_stereo_name(path), "a/room.b.png");
  }
  EXPECT_FALSE(parse_stereo_name("room_8x6.png"));
}

TEST(Stereo, left_view_is_first_by_default) {
  const LightField field = flat_pair({2, 2}, 10, 200);
  EXPECT_EQ(red(written_as(field, {StereoPacking::kSideBySide}), 0, 1), 10);
  EXPECT_EQ(red(written_as(field, {StereoPacking::kSideBySide}), 3, 1), 200);
  EXPECT_EQ(red(written_as(field, {StereoPacking::kSideBySide, true}), 0, 1), 200);
  EXPECT_EQ(red(written_as(field, {StereoPacking::kOverUnder}), 1, 0), 10) << "on top";
  EXPECT_EQ(red(written_as(field, {StereoPacking::kOverUnder}), 1, 3), 200);
  EXPECT_EQ(red(written_as(field, {StereoPacking::kRows}), 1, 0), 10);
  EXPECT_EQ(red(written_as(field, {StereoPacking::kRows}), 1, 1), 200);
  EXPECT_EQ(red(written_as(field, {StereoPacking::kRows, true}), 1, 0), 200);
}

TEST(Stereo, picture_has_the_size_of_its_packing) {
  const LightField field = flat_pair({6, 4}, 0, 0);
  const auto size = [&](StereoPacking packing) { return size_of(Picture(written_as(field, {packing}))); };
  EXPECT_EQ(size(StereoPacking::kSideBySide), Vec2i(12, 4));
  EXPECT_EQ(size(StereoPacking::kHalfSideBySide), Vec2i(6, 4));
  EXPECT_EQ(size(StereoPacking::kOverUnder), Vec2i(6, 8));
  EXPECT_EQ(size(StereoPacking::kHalfOverUnder), Vec2i(6, 4));
  EXPECT_EQ(size(StereoPacking::kRows), Vec2i(6, 4));
}

TEST(Stereo, rows_are_the_views_own) {
  const LightField field = numbered_field({2, 1}, {3, 4});
  const Image8 picture = written_as(field, {StereoPacking::kRows});
  const Image8 left = std::get<Image8>(view_of(field, 0)), right = std::get<Image8>(view_of(field, 1));
  EXPECT_EQ(red(picture, 1, 2), red(left, 1, 2));
  EXPECT_EQ(red(picture, 2, 3), red(right, 2, 3));
}

TEST(Stereo, squeezes_in_linear_light) {
  LightField field = flat_pair({2, 1}, 0, 0);
  std::get<Image8>(field.stack).rgb = {0, 0, 0, 255, 255, 255, 0, 0, 0, 0, 0, 0};
  const Image8 picture = written_as(field, {StereoPacking::kHalfSideBySide});
  EXPECT_EQ(red(picture, 0, 0), 188);  // the mean of black and white in linear light: 255 srgb(1/2) = 187.5
  EXPECT_EQ(red(picture, 1, 0), 0);
}

TEST(Stereo, what_is_read_is_written_again_exactly) {
  const TempDir dir;
  const LightField field = numbered_field({2, 1}, {6, 4});
  for (const StereoLayout& layout : all_layouts()) {
    FormatOptions options;
    options.stereo = layout;
    const auto first = stereo_format().write(field, dir / "first.png", options).front();
    const OpenedLightField opened = open_light_field(first, "", {});
    EXPECT_EQ(opened.format, "stereo");
    EXPECT_EQ(opened.field.grid, (ViewGrid{2, 1}));
    EXPECT_DOUBLE_EQ(opened.field.aspect, 1.5);
    const auto again = stereo_format().write(opened.field, dir / "again.png", options).front();
    EXPECT_TRUE(same_samples(read_picture(first), read_picture(again))) << first;
  }
}

TEST(Stereo, whole_views_come_back_as_they_were) {
  const TempDir dir;
  const LightField field = numbered_field({2, 1}, {5, 4});
  for (const StereoPacking packing : {StereoPacking::kSideBySide, StereoPacking::kOverUnder}) {
    FormatOptions options;
    options.stereo = StereoLayout{packing, true};
    const auto path = stereo_format().write(field, dir / "pair.png", options).front();
    EXPECT_TRUE(same_samples(stereo_format().read(path, {}).stack, field.stack)) << path;
  }
}

TEST(Stereo, converts_frames_between_packings) {
  const TempDir dir;
  FormatOptions sbs;
  sbs.stereo = StereoLayout{};
  const LightField field = flat_pair({4, 2}, 30, 60);
  for (const char* name : {"frame_0000.png", "frame_0001.png"}) stereo_format().write(field, dir / name, sbs);
  ConvertParams params;
  params.to = "stereo";
  params.options.stereo = StereoLayout{StereoPacking::kOverUnder, false};
  const Converted converted = convert(dir.path(), dir / "out", params);
  EXPECT_THAT(converted.written, ElementsAre(dir / "out/frame_0000_ou.png", dir / "out/frame_0001_ou.png"));
  params.to = "quilt", params.options.stereo.reset();
  EXPECT_EQ(convert(dir / "frame_0000_2x1.png", dir / "q.png", params).written.front(), dir / "q_qs2x1a2.png");
}

TEST(Stereo, what_is_no_pair_is_refused) {
  const TempDir dir;
  EXPECT_THAT(error_message([&] {
                stereo_format().write(numbered_field({3, 1}, {4, 4}), dir / "a.png", {});
              }),
              HasSubstr("the views of two eyes, but the light field has 3x1"));
  write_picture(dir / "odd.png", Image8{3, 3, std::vector<unsigned char>(27)});
  FormatOptions options;
  EXPECT_THAT(error_message([&] { stereo_format().read(dir / "odd.png", options); }),
              HasSubstr("the packing of the two views"));
  for (const StereoPacking packing : kPackings) {
    options.stereo = StereoLayout{packing, false};
    EXPECT_THAT(error_message([&] { stereo_format().read(dir / "odd.png", options); }),
                HasSubstr("3x3 pixels do not hold two views"));
  }
}

}  // namespace
}  // namespace lippmann
