#include "formats/depth_map.hpp"

#include <gmock/gmock.h>

#include <limits>

#include "core/atomic_file.hpp"
#include "lippmann/image/picture_file.hpp"
#include "support/error_message.hpp"
#include "support/exr_file.hpp"
#include "support/temp_dir.hpp"

namespace lippmann::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pointwise;

Image8 greys(int width, int height, const std::vector<int>& codes) {
  Image8 picture{width, height, {}};
  for (const int code : codes) picture.rgb.insert(picture.rgb.end(), 3, static_cast<unsigned char>(code));
  return picture;
}

TEST(DepthMap, integer_samples_are_linear) {
  const TempDir dir;
  write_picture(dir / "8.png", greys(2, 2, {0, 51, 102, 255}));
  EXPECT_THAT(read_depth_map(dir / "8.png", {2, 2}, false).data, Pointwise(testing::FloatEq(), {0.0f, 0.2f, 0.4f, 1.0f}));
  Image16 words{2, 1, {}};
  for (const int code : {13107, 65535}) words.rgb.insert(words.rgb.end(), 3, static_cast<std::uint16_t>(code));
  write_picture(dir / "16.png", words);
  EXPECT_THAT(read_depth_map(dir / "16.png", {2, 1}, false).data, Pointwise(testing::FloatEq(), {0.2f, 1.0f}));
}

TEST(DepthMap, resizing_keeps_edges_between_surfaces) {
  const TempDir dir;
  write_picture(dir / "small.png", greys(4, 1, {100, 104, 200, 200}));
  const std::vector<float> wide = read_depth_map(dir / "small.png", {16, 4}, false).data;
  EXPECT_FLOAT_EQ(wide[3], 101.5f / 255) << "three eighths of the way";
  EXPECT_FLOAT_EQ(wide[5], 103.5f / 255);
  EXPECT_FLOAT_EQ(wide[6], 200.0f / 255) << "between two surfaces the nearer one";
  const std::vector<float> near_black = read_depth_map(dir / "small.png", {16, 4}, true).data;
  EXPECT_NEAR(near_black[9], 104.0f / 255, 1e-6);
  EXPECT_NEAR(near_black[10], 200.0f / 255, 1e-6);
}

TEST(DepthMap, scales_exr_z_to_its_range) {
  const TempDir dir;
  write_file_atomically(dir / "z.exr", exr_file({{0, 0, 3, 0}, {0, 0, 3, 0}, {{"R", {9, 9, 9, 9}}, {"Z", {2, 4, 6, 1e10f}}}}));
  EXPECT_THAT(read_depth_map(dir / "z.exr", {4, 1}, false).data, ElementsAre(0.0f, 0.5f, 1.0f, 1.0f));
}

TEST(DepthMap, z_is_distance_or_height_without_colours) {
  const TempDir dir;
  const auto write_z = [&](const char* name, const std::vector<float>& z) {
    write_file_atomically(dir / name, exr_file({{0, 0, 3, 0}, {0, 0, 3, 0}, {{"R", {9, 9, 9, 9}}, {"Z", z}}}));
  };
  write_z("distance.exr", {2, 4, 6, 1e10f});
  const DepthMapCoding distance = default_depth_coding(dir / "distance.exr");
  EXPECT_TRUE(distance.near_black);
  EXPECT_TRUE(distance.even_in_depth);
  write_z("height.exr", {-2, 0, 2, -std::numeric_limits<float>::infinity()});
  const DepthMapCoding height = default_depth_coding(dir / "height.exr");
  EXPECT_FALSE(height.near_black);
  EXPECT_TRUE(height.even_in_depth);
  EXPECT_THAT(read_depth_map(dir / "height.exr", {4, 1}, false).data, ElementsAre(0.0f, 0.5f, 1.0f, 0.0f))
      << "no surface is far away";
  write_picture(dir / "grey.png", greys(2, 1, {0, 255}));
  EXPECT_FALSE(default_depth_coding(dir / "grey.png").near_black);
  EXPECT_FALSE(default_depth_coding(dir / "grey.png").even_in_depth);
}

TEST(DepthMap, refuses_what_is_no_depth) {
  const TempDir dir;
  const auto error = [&](const Image8& picture) {
    write_picture(dir / "a.png", picture);
    return error_message([&] { read_depth_map(dir / "a.png", {4, 2}, false); });
  };
  EXPECT_THAT(error(greys(2, 1, {7, 7})), HasSubstr("the same depth everywhere"));
  EXPECT_THAT(error(greys(2, 2, {0, 1, 2, 3})), HasSubstr("2x2 pixels, a different aspect ratio than the picture"));
  EXPECT_THAT(error({2, 1, {255, 0, 0, 0, 0, 255}}), HasSubstr("has colours, so it is not"));
  EXPECT_THAT(error_message([&] { read_depth_map(dir / "none.png", {4, 2}, false); }), HasSubstr("none.png"));
}

}  // namespace
}  // namespace lippmann::test
