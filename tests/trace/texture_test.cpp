#include "shading/texture.hpp"

#include <gtest/gtest.h>

namespace lippmann {
namespace {

constexpr float kStep = 1.0f / 65535.0f;  // difference between adjacent 16-bit codes

Texture gray(int width, int height, const std::vector<int>& bytes) {
  Texture t;
  t.width = width, t.height = height;
  t.srgb = false;
  for (const int b : bytes)
    for (int c = 0; c < 4; ++c) t.rgba.push_back(static_cast<std::uint8_t>(c == 3 ? 255 : b));
  return t;
}

const Vec2f kNone(0.0f);
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

constexpr int kLane = 5;

LaneMask one_lane() {
  LaneMask mask{};
  mask.lane[kLane] = -1;
  return mask;
}

Vec4f sample_uv(const DeviceTexture& texture, Vec2f uv, Vec2f a, Vec2f b) {
  UvLanes lanes;
  for (Lanes* value : {&lanes.u, &lanes.v, &lanes.a_u, &lanes.a_v, &lanes.b_u, &lanes.b_v})
    for (int i = 0; i < kLanes; ++i) (*value)[i] = kNan;
  lanes.u[kLane] = uv.x, lanes.v[kLane] = uv.y;
  lanes.a_u[kLane] = a.x, lanes.a_v[kLane] = a.y;
  lanes.b_u[kLane] = b.x, lanes.b_v[kLane] = b.y;
  TexelLanes texels;
  lippmann::sample_uv(texture, lanes, one_lane(), texels);
  return Vec4f(texels.color.get(kLane), texels.alpha[kLane]);
}

Vec3f sample_projected(const DeviceTexture& texture, const ImageProjection& projection, Vec3f point, float path_length) {
  Lanes3 points, color;
  Lanes lengths;
  for (int i = 0; i < kLanes; ++i) points.set(i, Vec3f(kNan)), lengths[i] = kNan;
  points.set(kLane, point), lengths[kLane] = path_length;
  lippmann::sample_projected(texture, projection, points, lengths, one_lane(), color);
  return color.get(kLane);
}

TEST(SampleUv, texel_centre_gives_the_texel) {
  const DeviceTexture t = make_device_texture(gray(2, 2, {0, 51, 102, 255}), false);
  EXPECT_NEAR(sample_uv(t, {0.25f, 0.25f}, kNone, kNone).r, 0.0f, kStep);
  EXPECT_NEAR(sample_uv(t, {0.75f, 0.25f}, kNone, kNone).r, 0.2f, kStep);
  EXPECT_NEAR(sample_uv(t, {0.25f, 0.75f}, kNone, kNone).r, 0.4f, kStep) << "v grows downwards";
  EXPECT_NEAR(sample_uv(t, {0.5f, 0.5f}, kNone, kNone).r, (0.0f + 0.2f + 0.4f + 1.0f) / 4, kStep);
}

TEST(SampleUv, wrap_modes_beyond_the_border) {
  Texture source = gray(2, 1, {0, 255});
  const auto at = [&](Wrap wrap, float u) {
    source.wrap_u = source.wrap_v = wrap;
    return sample_uv(make_device_texture(source, false), {u, 0.5f}, kNone, kNone).r;
  };
  EXPECT_NEAR(at(Wrap::kRepeat, 1.25f), 0.0f, kStep);
  EXPECT_NEAR(at(Wrap::kRepeat, -0.25f), 1.0f, kStep);
  EXPECT_NEAR(at(Wrap::kRepeat, 1.0f), 0.5f, kStep) << "between the last texel and the first";
  EXPECT_NEAR(at(Wrap::kMirror, 1.25f), 1.0f, kStep);
  EXPECT_NEAR(at(Wrap::kMirror, -0.25f), 0.0f, kStep);
  EXPECT_NEAR(at(Wrap::kClamp, 7.0f), 1.0f, kStep);
  EXPECT_NEAR(at(Wrap::kClamp, -7.0f), 0.0f, kStep);
}

TEST(SampleUv, srgb_texels_are_decoded_before_filtering) {
  Texture source = gray(2, 1, {0, 255});
  source.srgb = true;
  EXPECT_NEAR(sample_uv(make_device_texture(source, false), {0.5f, 0.5f}, kNone, kNone).r, 0.5f, kStep);
  source = gray(1, 1, {188});
  source.srgb = true;
  EXPECT_NEAR(sample_uv(make_device_texture(source, false), {0.5f, 0.5f}, kNone, kNone).r, 0.50289f, 1e-4f);
}

TEST(SampleUv, wide_footprint_averages_a_checkerboard) {
  std::vector<int> bytes;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) bytes.push_back((x + y) % 2 ? 255 : 0);
  const DeviceTexture t = make_device_texture(gray(64, 64, bytes), false);
  for (const float u : {0.1f, 0.31f, 0.77f}) {
    EXPECT_NEAR(sample_uv(t, {u, 0.4f}, {0.3f, 0.0f}, {0.0f, 0.3f}).r, 0.5f, 1e-3f) << "isotropic";
  }
}

TEST(SampleUv, anisotropic_footprint_blurs_along_its_axis) {
  // A footprint of 16 texels along u must leave horizontal stripes of 8 texels sharp.
  std::vector<int> bytes;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) bytes.push_back((y / 8) % 2 ? 255 : 0);
  const DeviceTexture t = make_device_texture(gray(64, 64, bytes), false);
  const Vec2f along_u(8.0f / 64, 0.0f), thin(0.0f, 1.0f / 64);
  EXPECT_NEAR(sample_uv(t, {0.3f, 4.0f / 64}, along_u, thin).r, 0.0f, 1e-3f);
  EXPECT_NEAR(sample_uv(t, {0.3f, 12.0f / 64}, along_u, thin).r, 1.0f, 1e-3f);
  EXPECT_NEAR(sample_uv(t, {0.3f, 12.0f / 64}, thin, along_u).r, 1.0f, 1e-3f) << "whichever of the two is longer";
  EXPECT_NEAR(sample_uv(t, {0.3f, 0.5f}, {0.0f, 16.0f / 64}, {1.0f / 64, 0.0f}).r, 0.5f, 0.02f) << "across the stripes";
}

TEST(SampleUv, extreme_coordinates_give_a_texel) {
  const DeviceTexture t = make_device_texture(gray(2, 2, {10, 20, 30, 40}), false);
  for (const float bad : {kNan, kInfinity, -1e30f}) {
    const float value = sample_uv(t, {bad, bad}, {bad, 0}, {0, bad}).r;
    EXPECT_GE(value, 10 / 255.0f - kStep);
    EXPECT_LE(value, 40 / 255.0f + kStep);
  }
}

TEST(SampleProjected, coordinates_fraction_and_level_by_hand) {
  // Except for the first row, all texels of a row are equal.
  const DeviceTexture t =
      make_device_texture(gray(4, 4, {0, 51, 102, 255, 60, 60, 60, 60, 120, 120, 120, 120, 180, 180, 180, 180}), true);
  ImageProjection m;
  m.center = {1, 0, 0};
  m.scale = {0.5f, 0.25f, 0.0f};
  // u = 0.5 (x - 1) and v = 0.25 y. A path length of 0 selects level 0. Interpolation is over (resolution - 1) = 3 texels, so u
  // = 1/6 is half-way from the first to the second texel.
  EXPECT_NEAR(sample_projected(t, m, {1, 0, 0}, 0.0f).r, 0.0f, kStep);
  EXPECT_NEAR(sample_projected(t, m, {1 + 1 / 3.0f, 0, 0}, 0.0f).r, 0.1f, kStep);
  EXPECT_NEAR(sample_projected(t, m, {1 / 3.0f, 0, 0}, 0.0f).r, 0.4f, kStep) << "-1/3 wraps to 2/3: the third texel";
  EXPECT_NEAR(sample_projected(t, m, {1, 2 / 3.0f, 0}, 0.0f).r, 30 / 255.0f, kStep) << "v = 1/6: half-way down to 60";
  // A path of 20 selects the coarsest level of 1 x 1 texel. Its code 115 is the truncated mean of the codes 42, 119,
  // 150 and 150 of level 1, which are truncated means of 2 x 2 texels. A path of 10 gives the level min(1, 0.05 x 10 x
  // 0.5) x (3 - 0.9999) = 0.500025.
  EXPECT_NEAR(sample_projected(t, m, {1, 0, 0}, 20.0f).r, 115 / 255.0f, kStep);
  EXPECT_NEAR(sample_projected(t, m, {1, 0, 0}, 10.0f).r, 0.500025f * 42 / 255.0f, 2 * kStep) << "half-way to level 1";
}

TEST(MakeDeviceTexture, tachyon_averages_truncate) {
  const Texture source = gray(2, 2, {0, 0, 0, 255});
  EXPECT_EQ(make_device_texture(source, true).levels[1].rgba[0], 63 * 257) << "255 / 4 = 63.75";
  EXPECT_EQ(make_device_texture(source, false).levels[1].rgba[0], 16384) << "63.75 x 257 rounded";
}

TEST(MakeDeviceTexture, odd_sizes_halve_down_to_one) {
  const DeviceTexture t = make_device_texture(gray(5, 3, std::vector<int>(15, 200)), false);
  ASSERT_EQ(t.levels.size(), 3u);
  EXPECT_EQ(t.levels[1].width, 2);
  EXPECT_EQ(t.levels[1].height, 1);
  EXPECT_EQ(t.levels[2].width, 1);
  for (const auto& level : t.levels)
    for (std::size_t i = 0; i < level.rgba.size(); i += 4) EXPECT_EQ(level.rgba[i], 200 * 257);
}

}  // namespace
}  // namespace lippmann
