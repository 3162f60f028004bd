#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <string>

#include "formats/lfp_file.hpp"
#include "formats/lytro_raw.hpp"
#include "image/demosaic.hpp"
#include "lippmann/formats/formats.hpp"
#include "lippmann/formats/open_light_field.hpp"
#include "lippmann/image/encode.hpp"
#include "support/error_message.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

using test::error_message;
using testing::HasSubstr;

std::string section(char kind, const std::string& name, const std::string& data) {
  std::string text = std::string("\x89LF") + kind + "\r\n\x1a\n" + std::string(4, '\0');
  for (int shift = 24; shift >= 0; shift -= 8) text += static_cast<char>(data.size() >> shift & 255);
  if (data.empty()) return text;
  text += name + std::string(80 - name.size(), '\0') + data;
  return text + std::string((16 - text.size() % 16) % 16, '\0');
}

/// Metadata of a camera with a hexagonal lens grid, shifted by (6, -0.5) pixels from the sensor's middle.
std::string illum_metadata(int width, int height, const std::string& corner = "gr") {
  return R"({"image": {"width": )" + std::to_string(width) + R"(, "height": )" + std::to_string(height) +
         R"(, "orientation": 1, "pixelPacking": {"bitsPerPixel": 10, "endianness": "little"},
    "pixelFormat": {"rightShift": 0, "black": {"r": 64, "gr": 64, "gb": 64, "b": 64},
                    "white": {"r": 1023, "gr": 1023, "gb": 1023, "b": 1023}},
    "mosaic": {"tile": "r,gr:gb,b", "upperLeftPixel": ")" +
         corner + R"("},
    "color": {"whiteBalanceGain": {"r": 2.0, "gr": 1.0, "gb": 1.0, "b": 1.5}, "ccm": [1, 0, 0, 0, 1, 0, 0, 0.5, 0.5]}},
  "devices": {"sensor": {"pixelPitch": 1.4e-06},
    "mla": {"tiling": "hexUniformRowMajor", "lensPitch": 2e-05, "rotation": -0.0005, "scaleFactor": {"x": 1.0, "y": 1.0003},
            "sensorOffset": {"x": 8.4e-06, "y": -7e-07, "z": 3.7e-05}},
    "lens": {"exitPupilOffset": {"z": 0.0973}}}})";
}

/// Packs four samples of 10 bits into five bytes.
std::string packed_10(const std::vector<unsigned>& codes) {
  std::string bytes;
  for (std::size_t i = 0; i < codes.size(); i += 4) {
    unsigned low = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      bytes += static_cast<char>(codes[i + k] >> 2);
      low |= (codes[i + k] & 3u) << (2 * k);
    }
    bytes += static_cast<char>(low);
  }
  return bytes;
}

std::string lfr(const std::string& metadata, const std::string& codes) {
  const std::string table = R"({"frames": [{"frame": {"metadataRef": "sha1-m", "imageRef": "sha1-i"}}]})";
  return section('P', "", "") + section('M', "sha1-t", table) + section('C', "sha1-m", metadata) +
         section('C', "sha1-i", codes);
}

std::span<const std::byte> bytes_of(const std::string& text) { return std::as_bytes(std::span(text)); }

/// Returns samples of a uniform colour behind a Bayer mosaic with the rows green, red and blue, green.
std::vector<unsigned> flat_codes(int width, int height, unsigned red, unsigned green, unsigned blue) {
  std::vector<unsigned> codes;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) codes.push_back(y % 2 == 0 ? (x % 2 == 0 ? green : red) : (x % 2 == 0 ? blue : green));
  return codes;
}

TEST(LytroRaw, flat_colour_comes_back_everywhere) {
  const std::string file = lfr(illum_metadata(64, 48), packed_10(flat_codes(64, 48, 304, 544, 224)));
  const LytroRaw raw = parse_lfr(bytes_of(file), "a.lfr");
  ASSERT_EQ(Vec2i(raw.light.width, raw.light.height), Vec2i(64, 48));
  for (std::size_t i = 0; i < raw.light.data.size(); i += 3) {
    ASSERT_NEAR(raw.light.data[i], 240.0 / 959.0, 1e-6) << i;
    ASSERT_NEAR(raw.light.data[i + 1], 480.0 / 959.0, 1e-6) << i;
    ASSERT_NEAR(raw.light.data[i + 2], 160.0 / 959.0, 1e-6) << i;
  }
  // Relative to the largest light, 959, the samples are 240 (red), 480 (green) and 160 (blue). White balance doubles
  // red and multiplies blue by 1.5: 480, 480, 240. The colour matrix replaces blue by the mean of green and blue: 360.
  const Image16 colors = developed(raw);
  const auto code = [](double linear) { return std::floor(65535.0 * srgb_from_linear(linear) + 0.5); };
  EXPECT_NEAR(colors.rgb[0], code(480.0 / 959.0), 1.0);
  EXPECT_NEAR(colors.rgb[1], code(480.0 / 959.0), 1.0);
  EXPECT_NEAR(colors.rgb[2], code(360.0 / 959.0), 1.0);
}

TEST(LytroRaw, metadata_states_the_grid) {
  const LensGrid grid =
      parse_lfr(bytes_of(lfr(illum_metadata(64, 48), packed_10(flat_codes(64, 48, 90, 90, 90)))), "a.lfr").grid;
  // lens pitch in pixels: lens pitch / pixel pitch, enlarged by the projection from the exit pupil
  const double pitch = 2e-05 / 1.4e-06 * (0.0973 + 3.7e-05) / 0.0973;
  EXPECT_NEAR(grid.pitch_px, pitch, 1e-9);
  EXPECT_NEAR(grid.row_pitch_px, pitch * std::sqrt(0.75) * 1.0003, 1e-9);
  EXPECT_DOUBLE_EQ(grid.rotation, -0.0005);
  EXPECT_NEAR(grid.offset_px.x, 32.0 + 6.0, 1e-9);
  EXPECT_NEAR(grid.offset_px.y, 24.0 - 0.5, 1e-9);
  EXPECT_EQ(grid.arrangement, LensArrangement::kHexagonal);
}

TEST(LytroRaw, twelve_bits_are_unpacked_from_the_top) {
  const std::string metadata = R"({"image": {"width": 16, "height": 16, "representation": "rawPacked", "rawDetails":
    {"pixelPacking": {"bitsPerPixel": 12, "endianness": "big"},
     "pixelFormat": {"black": {"r": 0, "gr": 0, "gb": 0, "b": 0}, "white": {"r": 4095, "gr": 4095, "gb": 4095, "b": 4095}},
     "mosaic": {"tile": "r,gr:gb,b", "upperLeftPixel": "b"}}},
    "devices": {"sensor": {"pixelPitch": 1.4e-06}, "mla": {"tiling": "squareUniform", "lensPitch": 1.4e-05, "rotation": 0.0,
                "sensorOffset": {"x": 0, "y": 0}}}})";
  std::string codes(16 * 16 / 2 * 3, '\0');
  codes[0] = '\x12', codes[1] = '\x34', codes[2] = '\x56';
  const LytroRaw raw = parse_lytro(bytes_of(codes), metadata, "a.txt");
  EXPECT_NEAR(raw.light.pixel(0, 0)[2], 0x123 / 4095.0, 1e-6);
  EXPECT_NEAR(raw.light.pixel(1, 0)[1], 0x456 / 4095.0, 1e-6);
  EXPECT_EQ(raw.grid, lens_grid(1.4e-05 / 1.4e-06, 0.0, {8.0, 8.0}, LensArrangement::kSquare));
  const std::string of_f01 = R"({"master": {"picture": {"frameArray": [{"frame": {"metadata": )" + metadata + "}}]}}}";
  EXPECT_EQ(parse_lytro(bytes_of(codes), of_f01, "a.txt").light.data, raw.light.data);
}

TEST(LytroRaw, files_become_views) {
  const test::TempDir dir;
  std::ofstream(dir / "a.LFR", std::ios::binary)
      << lfr(illum_metadata(160, 120), packed_10(flat_codes(160, 120, 304, 544, 224)));
  const OpenedLightField opened = open_light_field(dir / "a.LFR", "", {});
  EXPECT_EQ(opened.format, "plenoptic");
  EXPECT_EQ(opened.field.grid, (ViewGrid{14, 14}));
  EXPECT_TRUE(std::holds_alternative<Image16>(opened.field.stack));
  EXPECT_GE(opened.field.view_size.x, 8);
}

TEST(LytroRaw, raw_with_a_text_beside_is_read) {
  const test::TempDir dir;
  std::ofstream(dir / "mod_0001.RAW", std::ios::binary) << packed_10(flat_codes(64, 48, 304, 544, 224));
  EXPECT_FALSE(is_lytro_raw(dir / "mod_0001.RAW"));
  std::ofstream(dir / "mod_0001.TXT") << illum_metadata(64, 48);
  EXPECT_TRUE(is_lytro_raw(dir / "mod_0001.RAW"));
  EXPECT_NEAR(read_lytro(dir / "mod_0001.RAW").light.data[1], 480.0 / 959.0, 1e-6);
}

TEST(LytroRaw, bad_files_are_one_clear_error) {
  const auto complaint = [](const std::string& file) { return error_message([&] { parse_lfr(bytes_of(file), "a.lfr"); }); };
  const std::string codes = packed_10(flat_codes(64, 48, 90, 90, 90)), good = lfr(illum_metadata(64, 48), codes);
  EXPECT_THAT(complaint(good.substr(0, good.size() - 200)), HasSubstr("is truncated"));
  EXPECT_THAT(complaint(good + "rubbish beyond the end"), HasSubstr("no valid section at byte"));
  EXPECT_THAT(complaint(section('P', "", "")), HasSubstr("no section LFM"));
  EXPECT_THAT(complaint(section('P', "", "") + section('M', "t", R"({"a": 1})")), HasSubstr("processed picture"));
  EXPECT_THAT(complaint(section('P', "", "") + section('M', "t", "rubbish")), HasSubstr("is not JSON"));
  EXPECT_THAT(complaint(lfr(illum_metadata(64, 50), codes)), HasSubstr("of 10-bit samples"));
  EXPECT_THAT(complaint(lfr(illum_metadata(64, 48, "x"), codes)), HasSubstr("upperLeftPixel"));
  std::string no_frame = good;
  no_frame.replace(no_frame.find("sha1-i"), 6, "sha1-j");
  EXPECT_THAT(complaint(no_frame), HasSubstr("refers to the section"));
}

TEST(Demosaic, linear_grey_is_kept_exactly) {
  for (const Vec2i red : {Vec2i(0, 0), Vec2i(1, 0), Vec2i(0, 1), Vec2i(1, 1)}) {
    Image mosaic(12, 10, 1);
    for (int y = 0; y < 10; ++y)
      for (int x = 0; x < 12; ++x) *mosaic.pixel(x, y) = 0.1f + 0.03f * static_cast<float>(x) + 0.02f * static_cast<float>(y);
    const Image colors = demosaic(mosaic, red);
    for (int y = 2; y < 8; ++y)  // at the edges, mirrored pixels are not linear
      for (int x = 2; x < 10; ++x)
        for (const int c : {0, 1, 2})
          EXPECT_NEAR(colors.pixel(x, y)[c], *mosaic.pixel(x, y), 1e-6) << x << " " << y << " " << c;
  }
}

/// Malvar, He and Cutler, "High-quality linear interpolation for demosaicing of Bayer-patterned color images", 2004,
/// figure 2: a red pixel has the weights 1 in red, 4/8 in green and 6/8 in blue at its own position.
TEST(Demosaic, weights_are_those_of_the_paper) {
  Image mosaic(9, 9, 1);
  *mosaic.pixel(4, 4) = 1.0f;
  const Image colors = demosaic(mosaic, {0, 0});
  const auto at = [&](int x, int y, int c) { return colors.pixel(x, y)[c]; };
  EXPECT_FLOAT_EQ(at(4, 4, 0), 1.0f);
  EXPECT_FLOAT_EQ(at(4, 4, 1), 0.5f);
  EXPECT_FLOAT_EQ(at(4, 4, 2), 0.75f);
  EXPECT_FLOAT_EQ(at(5, 4, 0), 0.5f);
  EXPECT_FLOAT_EQ(at(5, 5, 0), 0.25f);
  EXPECT_FLOAT_EQ(at(6, 4, 1), 0.0f);  // the filter gives -1/8, but negative light is clamped to 0
}

}  // namespace
}  // namespace lippmann
