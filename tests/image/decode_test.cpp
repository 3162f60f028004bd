// A damaged file must give a picture or an Error.
#include "image/decode.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tiffio.h>
#include <webp/encode.h>

#include <cstring>
#include <fstream>
#include <functional>
#include <iterator>

#include "image/exr.hpp"
#include "image/netpbm.hpp"
#include "image/png.hpp"
#include "image/tiff.hpp"
#include "support/encode_image.hpp"
#include "support/error_message.hpp"
#include "support/exr_file.hpp"
#include "support/pictures.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;
using test::encode_jpeg;
using test::encode_png;
using test::error_message;
using test::noise_codes;
using test::noise_image;
using test::TempDir;
using ::testing::AllOf;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

using Bytes = std::vector<std::byte>;

constexpr int kWidth = 12, kHeight = 9;

template <class Range>
Bytes bytes_of(const Range& range) {
  const auto bytes = std::as_bytes(std::span(std::data(range), std::size(range)));
  return {bytes.begin(), bytes.end()};
}

Bytes bytes_of_file(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return bytes_of(std::string{std::istreambuf_iterator<char>(in), {}});
}

void write_bytes(const fs::path& path, const Bytes& bytes) {
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

Bytes exr_file(ExrCompression compression) {
  const TempDir dir;
  const Image film = noise_image(kWidth, kHeight, 3);
  const ExrLayer layers[] = {film_layer(film)};
  write_exr(dir / "a.exr", layers, compression);
  return bytes_of_file(dir / "a.exr");
}

Bytes own_tiff_file() {
  const TempDir dir;
  write_tiff(dir / "a.tif", noise_codes(kWidth, kHeight));
  return bytes_of_file(dir / "a.tif");
}

Bytes tiff_file(const std::function<void(TIFF*)>& write) {
  const TempDir dir;
  TIFF* tiff = TIFFOpen((dir / "a.tif").c_str(), "w");
  if (!tiff) throw std::runtime_error("libtiff opens no file");
  TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
  TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
  TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
  write(tiff);
  TIFFClose(tiff);
  return bytes_of_file(dir / "a.tif");
}

void set_tiff_size(TIFF* tiff, int width, int height, int bits) {
  TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, width);
  TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, height);
  TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, bits);
}

Bytes palette_tiff_file() {
  return tiff_file([](TIFF* tiff) {
    set_tiff_size(tiff, 2, 1, 8);
    TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_PALETTE);
    std::vector<std::uint16_t> red(256), green(256), blue(256);
    red[3] = 65535, green[4] = 65535, blue[4] = 32896;
    TIFFSetField(tiff, TIFFTAG_COLORMAP, red.data(), green.data(), blue.data());
    unsigned char row[] = {3, 4};
    TIFFWriteEncodedStrip(tiff, 0, row, sizeof row);
  });
}

/// 3 x 2 float pixels in one tile of 16 x 16.
Bytes tiled_float_tiff_file() {
  return tiff_file([](TIFF* tiff) {
    set_tiff_size(tiff, 3, 2, 32);
    TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_IEEEFP);
    TIFFSetField(tiff, TIFFTAG_TILEWIDTH, 16);
    TIFFSetField(tiff, TIFFTAG_TILELENGTH, 16);
    TIFFSetField(tiff, TIFFTAG_COMPRESSION, COMPRESSION_LZW);
    std::vector<float> tile(16 * 16, -1.0f);
    for (std::size_t i = 0; i < 6; ++i) tile[i / 3 * 16 + i % 3] = 0.5f * static_cast<float>(i);
    TIFFWriteEncodedTile(tiff, 0, tile.data(), static_cast<tmsize_t>(tile.size() * sizeof(float)));
  });
}

/// 2 x 1 pixels of 16 bits, stored as red samples, green samples, blue samples.
Bytes planar_word_tiff_file() {
  return tiff_file([](TIFF* tiff) {
    set_tiff_size(tiff, 2, 1, 16);
    TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 3);
    TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_RGB);
    TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_SEPARATE);
    TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, 1);
    std::uint16_t planes[3][2] = {{1, 2}, {300, 400}, {65535, 7}};
    for (std::uint32_t plane = 0; plane < 3; ++plane) TIFFWriteEncodedStrip(tiff, plane, planes[plane], 4);
  });
}

Bytes webp_file(bool alpha) {
  std::vector<std::uint8_t> samples;
  for (int i = 0; i < kWidth * kHeight * (alpha ? 4 : 3); ++i) samples.push_back(static_cast<std::uint8_t>(37 * i));
  if (alpha) return bytes_of(test::encode_webp(kWidth, kHeight, samples));
  std::uint8_t* encoded = nullptr;
  const std::size_t size = WebPEncodeRGB(samples.data(), kWidth, kHeight, 3 * kWidth, 80.0f, &encoded);
  const Bytes file = bytes_of(std::span(encoded, size));
  WebPFree(encoded);
  return file;
}

/// Two equal rows of 8 pixels, run-length encoded.
Bytes hdr_file() {
  std::string text = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 8\n";
  const char row[] = {2, 2, 0, 8, '\x88', '\x40', 3, 1, 2, 3, '\x85', 9, '\x88', 0, '\x84', '\x81', '\x84', '\x80'};
  for (int y = 0; y < 2; ++y) text.append(row, sizeof row);
  return bytes_of(text);
}

/// 2 x 2 pixels, the bottom row first.
Bytes tga_file() {
  const char file[] = {0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 2, 0, 24, 0, 7, 8, 9, 10, 11, 12, 1, 2, 3, 4, 5, 6};
  return bytes_of(std::string(file, sizeof file));
}

/// 4 x 1 grey pixels: a run of three and a single one.
Bytes tga_run_file() {
  const char file[] = {0, 0, 11, 0, 0, 0, 0, 0, 0, 0, 0, 0, 4, 0, 1, 0, 8, 0, '\x82', 50, 0, 60};
  return bytes_of(std::string(file, sizeof file));
}

/// 3 x 2 pixels of 24 bits, the bottom row first, with rows padded to 12 bytes.
Bytes bmp_file() {
  const char header[] = {'B', 'M', 78, 0, 0, 0, 0, 0, 0, 0, 54, 0, 0, 0, 40, 0, 0, 0, 3, 0, 0, 0, 2, 0, 0, 0, 1, 0, 24, 0};
  const std::string rows = std::string("abcdefghi\0\0\0jklmnopqr\0\0\0", 24);
  return bytes_of(std::string(header, sizeof header) + std::string(24, '\0') + rows);
}

/// The data window is partly outside the display window.
Bytes exr_windows_file() {
  return test::exr_file({{1, 1, 3, 2}, {0, 0, 2, 2}, {{"A", {1, 1, 1, 1, 1, 1}}, {"Y", {1, 2, 3, 4, 5, 6}}}});
}

Bytes exr_parts_file() {
  test::ExrPart part{{0, 0, 1, 0}, {0, 0, 1, 0}, {{"b", {1, 2}}, {"g", {3, 4}}, {"r", {5, 6}}}};
  part.name = "one";
  test::ExrPart other = part;
  other.name = "other";
  return test::exr_file(std::vector{part, other});
}

/// Plain pixels and a run in the old encoding, stored column by column.
Bytes hdr_plain_file() {
  using namespace std::literals;
  return bytes_of(
      "#?RGBE\nEXPOSURE=2\nFORMAT=32-bit_rle_xyze\n\n+X 2 -Y 3\nabc\x80\1\1\1\2abc\x80"
      "abc\x80"
      "abc\x80"s);
}

/// 2 x 2 pixels in four colours. LZW codes of 3 bits: 4 (clear), 0, 1, 2; of 4 bits: 3 and 5 (end).
Bytes gif_file() {
  using namespace std::literals;
  return bytes_of(
      "GIF89a\2\0\2\0\x81\0\0"
      "\x0a\x14\x1e\x28\x32\x3c\x46\x50\x5a\x64\x6e\x78"
      "\x2c\0\0\0\0\2\0\2\0\0"
      "\2\3\x44\x34\5\0\x3b"s);
}

Bytes ppm_file() {
  const Image8 codes = noise_codes(kWidth, kHeight);
  return encode_ppm({{kWidth, kHeight, {codes.rgb.begin(), codes.rgb.end()}}, 255});
}

struct Case {
  const char* name;
  Bytes (*file)();
  int width, height;
  std::vector<std::string> channels;
  SampleKind kind;
};

const std::vector<std::string> kGrey{"Y"}, kRgb{"R", "G", "B"}, kRgba{"R", "G", "B", "A"};

std::vector<std::uint8_t> slopes(int channels) {
  std::vector<std::uint8_t> samples;
  for (int i = 0; i < kWidth * kHeight * channels; ++i) samples.push_back(static_cast<std::uint8_t>(i / channels * 2));
  return samples;
}

const Case kCases[] = {
    {"png_rgb", [] { return bytes_of(encode_png(kWidth, kHeight, 3, slopes(3))); }, kWidth, kHeight, kRgb, SampleKind::kByte},
    {"png_alpha", [] { return bytes_of(encode_png(kWidth, kHeight, 4, slopes(4))); }, kWidth, kHeight, kRgba,
     SampleKind::kByte},
    {"png_grey", [] { return bytes_of(encode_png(kWidth, kHeight, 1, slopes(1))); }, kWidth, kHeight, kGrey, SampleKind::kByte},
    {"jpeg", [] { return bytes_of(encode_jpeg(kWidth, kHeight, 3, slopes(3))); }, kWidth, kHeight, kRgb, SampleKind::kByte},
    {"jpeg_grey", [] { return bytes_of(encode_jpeg(kWidth, kHeight, 1, slopes(1))); }, kWidth, kHeight, kGrey,
     SampleKind::kByte},
    {"jpeg_cmyk", [] { return bytes_of(encode_jpeg(kWidth, kHeight, 4, slopes(4))); }, kWidth, kHeight, kRgb,
     SampleKind::kByte},
    {"jpeg_progressive", [] { return bytes_of(encode_jpeg(kWidth, kHeight, 3, slopes(3), true)); }, kWidth, kHeight, kRgb,
     SampleKind::kByte},
    {"tiff", own_tiff_file, kWidth, kHeight, kRgb, SampleKind::kByte},
    {"tiff_palette", palette_tiff_file, 2, 1, kRgb, SampleKind::kByte},
    {"tiff_tiled_floats", tiled_float_tiff_file, 3, 2, kGrey, SampleKind::kFloat},
    {"tiff_planar_words", planar_word_tiff_file, 2, 1, kRgb, SampleKind::kWord},
    {"exr_zip", [] { return exr_file(ExrCompression::kZip); }, kWidth, kHeight, kRgb, SampleKind::kFloat},
    {"exr_piz", [] { return exr_file(ExrCompression::kPiz); }, kWidth, kHeight, kRgb, SampleKind::kFloat},
    {"exr_run_length", [] { return exr_file(ExrCompression::kRunLength); }, kWidth, kHeight, kRgb, SampleKind::kFloat},
    {"exr_plain", [] { return exr_file(ExrCompression::kNone); }, kWidth, kHeight, kRgb, SampleKind::kFloat},
    {"exr_windows", exr_windows_file, 3, 3, {"Y", "A"}, SampleKind::kFloat},
    {"exr_parts", exr_parts_file, 2, 1, {"r", "g", "b"}, SampleKind::kFloat},
    {"hdr", hdr_file, 8, 2, kRgb, SampleKind::kFloat},
    {"hdr_plain", hdr_plain_file, 2, 3, kRgb, SampleKind::kFloat},
    {"webp", [] { return webp_file(false); }, kWidth, kHeight, kRgb, SampleKind::kByte},
    {"webp_lossless_alpha", [] { return webp_file(true); }, kWidth, kHeight, kRgba, SampleKind::kByte},
    {"ppm", ppm_file, kWidth, kHeight, kRgb, SampleKind::kByte},
    {"pfm", [] { return encode_pfm(noise_image(kWidth, kHeight, 3)); }, kWidth, kHeight, kRgb, SampleKind::kFloat},
    {"bmp", bmp_file, 3, 2, kRgb, SampleKind::kByte},
    {"gif", gif_file, 2, 2, kRgb, SampleKind::kByte},
    {"tga", tga_file, 2, 2, kRgb, SampleKind::kByte},
    {"tga_runs", tga_run_file, 4, 1, kGrey, SampleKind::kByte},
};

class EveryFormat : public ::testing::TestWithParam<Case> {};

INSTANTIATE_TEST_SUITE_P(Decode, EveryFormat, ::testing::ValuesIn(kCases),
                         [](const auto& one) { return std::string(one.param.name); });

std::size_t samples_in(const DecodedPicture& picture) {
  return std::visit([](const auto& samples) { return samples.size(); }, picture.samples);
}

TEST_P(EveryFormat, is_recognised_by_its_first_bytes) {
  const Case& expected = GetParam();
  const TempDir dir;
  write_bytes(dir / "a.txt", expected.file());
  EXPECT_EQ(channel_names(dir / "a.txt"), expected.channels);
  EXPECT_EQ(sample_kind(dir / "a.txt"), expected.kind);
  const PictureShape shape = picture_shape(dir / "a.txt");
  EXPECT_EQ(std::tuple(shape.width, shape.height, shape.kind), std::tuple(expected.width, expected.height, expected.kind));
  const Image read = read_image(dir / "a.txt");
  EXPECT_EQ(read.width, expected.width);
  EXPECT_EQ(read.height, expected.height);
  EXPECT_EQ(read.data.size(), static_cast<std::size_t>(read.width) * read.height * expected.channels.size());
}

bool decodes_or_throws(const Bytes& file) {
  try {
    const DecodedPicture picture = decode_picture(file, "the file");
    EXPECT_EQ(samples_in(picture), static_cast<std::size_t>(picture.header.width) *
                                       static_cast<std::size_t>(picture.header.height) * picture.header.channels.size());
    return true;
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("the file"), ::testing::Not(HasSubstr("\n"))));
    return false;
  }
}

TEST_P(EveryFormat, every_proper_prefix_is_an_error) {
  const Bytes whole = GetParam().file();
  ASSERT_TRUE(decodes_or_throws(whole));
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_FALSE(decodes_or_throws(Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)))) << size;
}

TEST_P(EveryFormat, one_changed_byte_gives_picture_or_error) {
  const Bytes whole = GetParam().file();
  for (std::size_t at = 0; at < whole.size(); ++at)
    for (const unsigned mask : {0x01u, 0x10u, 0x80u, 0xffu}) {
      Bytes damaged = whole;
      damaged[at] ^= static_cast<std::byte>(mask);
      decodes_or_throws(damaged);
    }
}

TEST_P(EveryFormat, four_changed_bytes_give_picture_or_error) {
  const Bytes whole = GetParam().file();
  for (std::size_t at = 0; at + 4 <= whole.size(); ++at)
    for (const unsigned value : {0x00u, 0x7fu, 0xffu}) {
      Bytes damaged = whole;
      std::fill_n(damaged.begin() + static_cast<std::ptrdiff_t>(at), 4, static_cast<std::byte>(value));
      decodes_or_throws(damaged);
    }
}

template <class Sample>
std::vector<Sample> samples_of(const Bytes& file) {
  return std::get<std::vector<Sample>>(decode_picture(file, "the file").samples);
}

TEST(DecodeTiff, palette_becomes_colours) {
  EXPECT_THAT(samples_of<std::uint8_t>(palette_tiff_file()), ElementsAre(255, 0, 0, 0, 255, 128));
}

TEST(DecodeTiff, tiles_of_floats_are_put_together) {
  EXPECT_THAT(samples_of<float>(tiled_float_tiff_file()), ElementsAre(0.0f, 0.5f, 1.0f, 1.5f, 2.0f, 2.5f));
}

TEST(DecodeTiff, planes_are_interleaved) {
  EXPECT_THAT(samples_of<std::uint16_t>(planar_word_tiff_file()), ElementsAre(1, 300, 65535, 2, 400, 7));
}

// Mantissas of a row: red is a run of 0x40; green is 1, 2, 3 and a run of 9; blue is 0. A value is its mantissa times
// 2^-7 for the exponent 129, and times 2^-8 for 128.
TEST(DecodeHdr, runs_and_dumps_with_their_exponents) {
  const std::vector<float> samples = samples_of<float>(hdr_file());
  ASSERT_EQ(samples.size(), 48u);
  EXPECT_EQ(samples[0], 0.5f);
  EXPECT_EQ(samples[1], 0x1p-7f);
  EXPECT_EQ(samples[2], 0.0f);
  EXPECT_EQ(samples[3 * 3 + 1], 9 * 0x1p-7f);
  EXPECT_EQ(samples[3 * 4], 0.25f);
  EXPECT_EQ(samples[3 * 7 + 1], 9 * 0x1p-8f);
}

TEST(DecodeTga, rows_from_the_bottom_and_blue_first) {
  EXPECT_THAT(samples_of<std::uint8_t>(tga_file()), ElementsAre(3, 2, 1, 6, 5, 4, 9, 8, 7, 12, 11, 10));
}

TEST(DecodeGif, colours_of_the_table) {
  EXPECT_THAT(samples_of<std::uint8_t>(gif_file()), ElementsAre(10, 20, 30, 40, 50, 60, 70, 80, 90, 100, 110, 120));
}

TEST(DecodeTga, runs) { EXPECT_THAT(samples_of<std::uint8_t>(tga_run_file()), ElementsAre(50, 50, 50, 60)); }

// Adobe stores inverted inks: 255 means no ink.
TEST(DecodeJpeg, cmyk_without_ink_is_white) {
  EXPECT_THAT(samples_of<std::uint8_t>(bytes_of(encode_jpeg(8, 8, 4, std::vector<std::uint8_t>(256, 255)))), Each(255));
}

TEST(DecodePicture, unsupported_formats_list_the_supported_ones) {
  for (const char* file :
       {"qoif....................", "BM......................", "FORM....ILBMBMHD........", "8BPS...................."})
    EXPECT_THAT(error_message([&] { decode_picture(bytes_of(std::string_view(file)), "a.png"); }),
                AllOf(HasSubstr("a.png: cannot be read as a picture"), HasSubstr("PNG, JPEG, TIFF, OpenEXR")));
}

std::size_t value_of_attribute(const Bytes& file, std::string_view name_and_type) {
  const std::string_view text(reinterpret_cast<const char*>(file.data()), file.size());
  return text.find(name_and_type) + name_and_type.size() + 4;
}

// A few hundred bytes state 60000 x 60000 pixels, which must not be allocated.
TEST(DecodeExr, small_file_with_huge_size_is_refused) {
  using namespace std::literals;
  Bytes file = exr_file(ExrCompression::kZip);
  const std::int32_t size[] = {0, 0, 59999, 59999};
  std::memcpy(file.data() + value_of_attribute(file, "dataWindow\0box2i\0"sv), size, sizeof size);
  EXPECT_THAT(error_message([&] { decode_picture(file, "a.exr"); }), HasSubstr("a.exr: "));
  const std::int32_t lower[] = {0, 0, 59999, 99};
  std::memcpy(file.data() + value_of_attribute(file, "dataWindow\0box2i\0"sv), lower, sizeof lower);
  EXPECT_THAT(error_message([&] { decode_picture(file, "a.exr"); }), HasSubstr("a.exr: cannot be read as a picture: "));
}

// The offset table, with 8 bytes for each of 10000 x 10000 tiles, would be larger than the file.
TEST(DecodeExr, small_file_with_many_tiles_is_refused) {
  using namespace std::literals;
  const std::string_view tiles = "tiles\0tiledesc\0\x09\0\0\0\x01\0\0\0\x01\0\0\0\0"sv;
  Bytes file = exr_file(ExrCompression::kZip);
  const std::int32_t size[] = {0, 0, 9999, 9999};
  std::memcpy(file.data() + value_of_attribute(file, "dataWindow\0box2i\0"sv), size, sizeof size);
  const Bytes attribute = bytes_of(tiles);
  file.insert(file.begin() + 8, attribute.begin(), attribute.end());
  file[5] |= std::byte{0x02};  // flag of tiled files
  EXPECT_THAT(error_message([&] { decode_picture(file, "a.exr"); }), HasSubstr("truncated in its header"));
}

TEST(DecodeExr, attribute_longer_than_the_file_is_truncated) {
  using namespace std::literals;
  Bytes file = exr_file(ExrCompression::kZip);
  const std::int32_t size = 1 << 30;
  std::memcpy(file.data() + value_of_attribute(file, "capDate\0string\0"sv) - 4, &size, sizeof size);
  EXPECT_THAT(error_message([&] { decode_picture(file, "a.exr"); }), HasSubstr("truncated in its header"));
}

// The attribute does not have the 4 bytes of a float. OpenEXR ignores the size and would read the rest as the next
// attribute.
TEST(DecodeExr, attribute_of_wrong_size_is_an_error) {
  using namespace std::literals;
  Bytes file = exr_file(ExrCompression::kZip);
  const std::size_t value = value_of_attribute(file, "pixelAspectRatio\0float\0"sv);
  const std::int32_t size = 8;
  std::memcpy(file.data() + value - 4, &size, sizeof size);
  file.insert(file.begin() + static_cast<std::ptrdiff_t>(value), 4, std::byte{0});
  EXPECT_THAT(error_message([&] { decode_picture(file, "a.exr"); }),
              HasSubstr("its attribute pixelAspectRatio does not have the type float"));
}

}  // namespace
}  // namespace lippmann
