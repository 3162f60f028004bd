#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tiffio.h>

#include <array>
#include <fstream>
#include <iterator>
#include <optional>

#include "image/chromaticities.hpp"
#include "image/color_profile.hpp"
#include "image/decode.hpp"
#include "image/exif.hpp"
#include "image/icc_transform.hpp"
#include "image/orientation.hpp"
#include "image/png.hpp"
#include "image/read_image.hpp"
#include "image/tiff.hpp"
#include "support/encode_image.hpp"
#include "support/error_message.hpp"
#include "support/icc_profile.hpp"
#include "support/pictures.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

using namespace std::string_literals;
using namespace std::string_view_literals;
using test::big_endian;
using test::error_message;
using test::kP3Primaries;
using test::kSrgbPrimaries;
using test::press_profile;
using test::profile_with;
using test::TempDir;
using ::testing::ElementsAre;
using ::testing::FloatEq;
using ::testing::FloatNear;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

using Bytes = std::vector<std::byte>;

template <class Range>
Bytes to_bytes(const Range& range) {
  const auto bytes = std::as_bytes(std::span(std::data(range), std::size(range)));
  return {bytes.begin(), bytes.end()};
}

std::string exif_with(char orientation) {
  return std::string("MM\0\x2a\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0"sv) + orientation + std::string(6, '\0');
}

PictureHeader header_in(const Bytes& file) { return picture_header(file, "the file"); }

template <class Sample>
std::vector<Sample> decoded_as(const Bytes& file) {
  return std::get<std::vector<Sample>>(decode_picture(file, "the file").samples);
}

// The stored rows are 1 2 3 and 4 5 6.
TEST(Orientation, all_eight_are_as_in_tiff) {
  const std::vector<std::vector<std::uint8_t>> expected{{1, 2, 3, 4, 5, 6}, {3, 2, 1, 6, 5, 4}, {6, 5, 4, 3, 2, 1},
                                                        {4, 5, 6, 1, 2, 3}, {1, 4, 2, 5, 3, 6}, {4, 1, 5, 2, 6, 3},
                                                        {6, 3, 5, 2, 4, 1}, {3, 6, 2, 5, 1, 4}};
  for (unsigned number = 1; number <= 8; ++number) {
    DecodedPicture picture{plain_header(3, 2, 1, SampleKind::kByte), std::vector<std::uint8_t>{1, 2, 3, 4, 5, 6}};
    picture.header.orientation = orientation_of(number);
    const DecodedPicture turned = upright(picture);
    EXPECT_EQ(std::get<std::vector<std::uint8_t>>(turned.samples), expected[number - 1]) << number;
    EXPECT_EQ(turned.header.width, number >= 5 ? 2 : 3) << number;
    EXPECT_EQ(turned.header.orientation, Orientation::kUpright);
  }
  EXPECT_EQ(orientation_of(0), Orientation::kUpright);
  EXPECT_EQ(orientation_of(9), Orientation::kUpright);
}

TEST(Exif, both_byte_orders_are_read) {
  EXPECT_EQ(exif_orientation(to_bytes(exif_with(6))), Orientation::kRightSide);
  EXPECT_EQ(exif_orientation(to_bytes("Exif\0\0"s + exif_with(3))), Orientation::kUpsideDown);
  EXPECT_EQ(exif_orientation(to_bytes("II\x2a\0\x08\0\0\0\x01\0\x12\x01\x03\0\x01\0\0\0\x08\0\0\0\0\0\0\0"sv)),
            Orientation::kLeftSide);
  const std::string whole = exif_with(6);
  for (std::size_t size = 0; size < 20; ++size)
    EXPECT_EQ(exif_orientation(to_bytes(whole.substr(0, size))), Orientation::kUpright) << size;
}

TEST(Exif, turns_jpeg_png_and_webp) {
  const std::vector<std::uint8_t> grey(16 * 8, 90);
  const std::string exif = "Exif\0\0"s + exif_with(6);
  std::string jpeg;
  for (const unsigned char c : test::encode_jpeg(16, 8, 1, grey)) jpeg += static_cast<char>(c);
  jpeg.insert(2, "\xff\xe1" + big_endian(static_cast<std::uint32_t>(exif.size() + 2), 2) + exif);
  EXPECT_EQ(header_in(to_bytes(jpeg)).width, 8);
  EXPECT_EQ(jpeg_header(to_bytes(jpeg), "a").width, 16);
  EXPECT_EQ(decoded_as<std::uint8_t>(to_bytes(jpeg)).size(), grey.size());

  std::string webp;
  for (const unsigned char c : test::encode_webp(16, 8, std::vector<std::uint8_t>(4 * 16 * 8, 255)))
    webp += static_cast<char>(c);
  webp = "RIFF" + std::string(4, '\0') + "WEBPVP8X\x0a\0\0\0\x18\0\0\0\x0f\0\0\x07\0\0"s + webp.substr(12) + "EXIF" +
         std::string("\x1a\0\0\0", 4) + exif_with(6);
  const auto size = static_cast<std::uint32_t>(webp.size() - 8);
  for (std::size_t i = 0; i < 4; ++i) webp[4 + i] = static_cast<char>(size >> 8 * i & 0xff);
  EXPECT_EQ(header_in(to_bytes(webp)).width, 8);
}

std::uint32_t png_checksum(std::string_view bytes) {
  std::uint32_t sum = 0xffffffff;
  for (const char c : bytes) {
    sum ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) sum = sum >> 1 ^ (sum & 1 ? 0xedb88320 : 0);
  }
  return ~sum;
}

Bytes png_with(const std::vector<std::pair<std::string, std::string>>& chunks) {
  std::string file;
  for (const unsigned char c : test::encode_png(4, 2, 3, std::vector<std::uint8_t>(24, 100))) file += static_cast<char>(c);
  for (std::string_view unwanted : {"sRGB"sv, "gAMA"sv})
    if (const std::size_t at = file.find(unwanted); at != file.npos)
      file.erase(at - 4, 12 + static_cast<unsigned char>(file[at - 1]));
  std::string added;
  for (const auto& [name, data] : chunks) {
    const std::string body = name + data;
    added += big_endian(static_cast<std::uint32_t>(data.size())) + body + big_endian(png_checksum(body));
  }
  constexpr std::size_t kBehindHeader = 8 + 25;
  file.insert(kBehindHeader, added);
  return to_bytes(file);
}

std::string chrm(const std::array<std::uint32_t, 8>& values) {
  std::string data;
  for (const std::uint32_t value : values) data += big_endian(value);
  return data;
}

TEST(PngNotices, ordinary_pictures_have_none) {
  const std::string srgb_colours = chrm({31270, 32900, 64000, 33000, 30000, 60000, 15000, 6000});
  EXPECT_THAT(header_in(png_with({})).notices, IsEmpty());
  EXPECT_THAT(header_in(png_with({{"sRGB", std::string(1, '\0')}, {"gAMA", big_endian(45455)}})).notices, IsEmpty());
  EXPECT_THAT(header_in(png_with({{"gAMA", big_endian(45455)}, {"cHRM", srgb_colours}})).notices, IsEmpty());
  EXPECT_THAT(header_in(png_with({{"pHYs", big_endian(2835) + big_endian(2835) + "\x01"}})).notices, IsEmpty());
  EXPECT_THAT(header_in(png_with({{"cICP", std::string("\x01\x0d\0\x01", 4)}})).notices, IsEmpty());
}

TEST(PngNotices, ignored_properties_are_reported) {
  const std::string p3 = chrm({31270, 32900, 68000, 32000, 26500, 69000, 15000, 6000});
  EXPECT_THAT(header_in(png_with({{"gAMA", big_endian(100000)}})).notices, ElementsAre(HasSubstr("gAMA 1)")));
  EXPECT_THAT(header_in(png_with({{"cHRM", p3}})).notices, ElementsAre(HasSubstr("cHRM")));
  EXPECT_THAT(header_in(png_with({{"cICP", std::string("\x0c\x0d\0\x01", 4)}})).notices, ElementsAre(HasSubstr("cICP")));
  EXPECT_THAT(header_in(png_with({{"pHYs", big_endian(1000) + big_endian(2000) + "\x01"}})).notices,
              ElementsAre("its pixels are 2 times as wide as high, and are read as square"));
  EXPECT_THAT(header_in(png_with({{"oFFs", big_endian(7) + big_endian(9) + std::string(1, '\0')}})).notices,
              ElementsAre("its offset (oFFs) of 7, 9 is ignored"));
  EXPECT_EQ(header_in(png_with({{"eXIf", exif_with(8)}})).width, 2);
}

TEST(PngNotices, are_warned_about_once_with_the_file) {
  const TempDir dir;
  const Bytes file = png_with({{"gAMA", big_endian(100000)}});
  std::ofstream(dir / "a.png", std::ios::binary)
      .write(reinterpret_cast<const char*>(file.data()), static_cast<std::streamsize>(file.size()));
  std::vector<std::string> warnings;
  read_image8(dir / "a.png", [&](std::string_view text) { warnings.emplace_back(text); });
  EXPECT_THAT(warnings, ElementsAre(HasSubstr("a.png: its gamma (gAMA 1) is not applied")));
}

TEST(ColorProfile, srgb_is_silent_and_others_are_named) {
  EXPECT_EQ(color_profile_notice({}), "");
  EXPECT_EQ(color_profile_notice(to_bytes(profile_with(kSrgbPrimaries, 2.2))), "");
  EXPECT_THAT(color_profile_notice(to_bytes(profile_with(kP3Primaries, 2.2))), HasSubstr("its colour profile 'Mine' is not"));
  EXPECT_THAT(color_profile_notice(to_bytes(profile_with(kSrgbPrimaries, 1.8))), HasSubstr("'Mine'"));
}

TEST(ColorProfile, damaged_profiles_are_not_srgb) {
  constexpr std::size_t kHeader = 132;
  const std::string whole = profile_with(kP3Primaries, 2.2);
  for (std::size_t size = 0; size < kHeader; ++size) EXPECT_EQ(color_profile_notice(to_bytes(whole.substr(0, size))), "");
  for (std::size_t size = kHeader; size < whole.size(); ++size)
    EXPECT_THAT(color_profile_notice(to_bytes(whole.substr(0, size))), HasSubstr("is not applied")) << size;
  for (std::size_t at = 128; at < whole.size(); ++at) {
    std::string damaged = whole;
    damaged[at] = '\xff';
    EXPECT_THAT(color_profile_notice(to_bytes(damaged)), HasSubstr("is not applied")) << at;
  }
}

TEST(ColorProfile, jpeg_and_png_profiles_are_found) {
  const std::string profile = profile_with(kP3Primaries, 2.2), segment = "ICC_PROFILE\0\x01\x01"s + profile;
  std::string jpeg;
  for (const unsigned char c : test::encode_jpeg(8, 8, 1, std::vector<std::uint8_t>(64, 90))) jpeg += static_cast<char>(c);
  jpeg.insert(2, "\xff\xe2" + big_endian(static_cast<std::uint32_t>(segment.size() + 2), 2) + segment);
  EXPECT_EQ(header_in(to_bytes(jpeg)).profile.size(), profile.size());
  EXPECT_THAT(decode_picture(to_bytes(jpeg), "a").header.notices, ElementsAre(HasSubstr("'Mine'"))) << "RGB's, of a grey file";
}

#ifdef LIPPMANN_HAS_LCMS

template <class Code>
std::vector<Code> by_profile(const std::string& profile, int channels, std::vector<Code> codes) {
  const SampleKind kind = sizeof(Code) == 1 ? SampleKind::kByte : SampleKind::kWord;
  Samples samples(std::move(codes));
  EXPECT_TRUE(apply_color_profile(to_bytes(profile), plain_header(1, 1, channels, kind), samples));
  return std::get<std::vector<Code>>(samples);
}

// Expected codes follow from the primaries' XYZ values under D50: the P3 colour (100, 150, 120) is (82.9, 153.1, 118.3)
// in sRGB. With a gamma of 1.8, code c is the light (c / largest code)^1.8.
TEST(ApplyColorProfile, codes_become_those_of_srgb) {
  using testing::AllOf, testing::Ge, testing::Le;
  const auto near = [](int value, int error) { return AllOf(Ge(value - error), Le(value + error)); };
  EXPECT_THAT(by_profile<std::uint8_t>(profile_with(kP3Primaries, 2.2), 3, {100, 150, 120}),
              ElementsAre(near(83, 1), near(153, 1), near(118, 1)));
  EXPECT_THAT(by_profile<std::uint8_t>(profile_with(kSrgbPrimaries, 1.8), 4, {128, 128, 128, 77}),
              ElementsAre(near(146, 1), near(146, 1), near(146, 1), 77))
      << "alpha stays";
  EXPECT_THAT(by_profile<std::uint16_t>(profile_with(kSrgbPrimaries, 1.8), 3, {30000, 30000, 30000}),
              testing::Each(near(34874, 40)));
  std::string grey = profile_with(kSrgbPrimaries, 1.8);
  grey.replace(16, 4, "GRAY").replace(grey.find("rTRC"), 4, "kTRC");
  EXPECT_THAT(by_profile<std::uint8_t>(grey, 2, {128, 5}), ElementsAre(near(146, 1), 5));
}

TEST(ApplyColorProfile, damaged_profiles_do_not_change_codes) {
  const std::string whole = profile_with(kP3Primaries, 2.2);
  for (std::size_t size = 0; size < whole.size(); ++size) {
    Samples samples(std::vector<std::uint8_t>{100, 150, 120});
    const bool is_applied =
        apply_color_profile(to_bytes(whole.substr(0, size)), plain_header(1, 1, 3, SampleKind::kByte), samples);
    EXPECT_EQ(is_applied, samples != Samples(std::vector<std::uint8_t>{100, 150, 120})) << size;
  }
}

TEST(ApplyColorProfile, files_are_read_as_srgb_without_notice) {
  std::vector<std::uint8_t> codes;
  for (int i = 0; i < 64; ++i) codes.insert(codes.end(), {100, 150, 120});
  const std::string segment = "ICC_PROFILE\0\x01\x01"s + profile_with(kP3Primaries, 2.2);
  std::string jpeg;
  for (const unsigned char c : test::encode_jpeg(8, 8, 3, codes)) jpeg += static_cast<char>(c);
  jpeg.insert(2, "\xff\xe2" + big_endian(static_cast<std::uint32_t>(segment.size() + 2), 2) + segment);
  const DecodedPicture picture = decode_picture(to_bytes(jpeg), "a");
  EXPECT_THAT(picture.header.notices, IsEmpty());
  EXPECT_THAT(picture.header.profile, IsEmpty());
  EXPECT_NEAR(std::get<std::vector<std::uint8_t>>(picture.samples)[0], 83, 3) << "JPEG changes codes by one or two";
}

/// magenta at half strength, magenta at full strength, and paper without ink
TEST(RgbOfInks, by_the_profile_of_a_press) {
  const std::vector<std::uint8_t> inks{0, 128, 0, 0, 0, 255, 0, 0, 0, 0, 0, 0};
  const std::optional<Samples> samples = rgb_of_inks(to_bytes(press_profile()), inks);
  ASSERT_TRUE(samples);
  const auto& rgb = std::get<std::vector<std::uint8_t>>(*samples);
  ASSERT_EQ(rgb.size(), 9u);
  EXPECT_NEAR(rgb[0], 119, 2) << "L* = 50 is 118.9";
  EXPECT_NEAR(rgb[1], rgb[0], 1);
  EXPECT_THAT(std::vector(rgb.begin() + 3, rgb.end()), ElementsAre(0, 0, 0, 255, 255, 255));
  EXPECT_FALSE(rgb_of_inks(to_bytes(profile_with(kP3Primaries, 2.2)), inks)) << "not of inks";
}

#endif

TEST(RgbOfInks, jpeg_without_a_profile_is_an_estimate) {
  const auto file = test::encode_jpeg(8, 8, 4, std::vector<std::uint8_t>(256, 255));
  const Bytes bytes = to_bytes(std::string(file.begin(), file.end()));
  EXPECT_THAT(decode_picture(bytes, "a").header.notices, ElementsAre(HasSubstr("its inks (CMYK) have no colour profile")));
}

std::string tiff_of_inks(int bits, const std::string& profile) {
  const test::TempDir dir;
  TIFF* tiff = TIFFOpen((dir / "a.tif").c_str(), "w");
  TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, 1);
  TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, 1);
  TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, bits);
  TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 4);
  TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_SEPARATED);
  TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
  if (!profile.empty()) TIFFSetField(tiff, TIFFTAG_ICCPROFILE, static_cast<std::uint32_t>(profile.size()), profile.data());
  std::array<std::uint8_t, 8> magenta{};
  for (int i = 0; i < bits / 8; ++i) magenta[static_cast<std::size_t>(bits / 8 + i)] = 255;
  TIFFWriteEncodedStrip(tiff, 0, magenta.data(), bits / 2);
  TIFFClose(tiff);
  std::ifstream file(dir / "a.tif", std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(RgbOfInks, tiff_by_its_profile_or_an_estimate) {
  EXPECT_THAT(decoded_as<std::uint8_t>(to_bytes(tiff_of_inks(8, ""))), ElementsAre(255, 0, 255));
  EXPECT_THAT(decode_picture(to_bytes(tiff_of_inks(8, "")), "a").header.notices, ElementsAre(HasSubstr("its inks (CMYK)")));
  EXPECT_THAT(error_message([] { decode_picture(to_bytes(tiff_of_inks(16, "")), "a.tif"); }),
              HasSubstr("a.tif: cannot be read as a picture: its inks (CMYK) of 16 bits have no colour profile"));
#ifdef LIPPMANN_HAS_LCMS
  EXPECT_THAT(decoded_as<std::uint8_t>(to_bytes(tiff_of_inks(8, press_profile()))), ElementsAre(0, 0, 0));
  EXPECT_THAT(decoded_as<std::uint16_t>(to_bytes(tiff_of_inks(16, press_profile()))), ElementsAre(0, 0, 0));
#endif
}

// Columns X and Y of the standard matrix from XYZ to sRGB: (3.2406, -0.9689, 0.0557) and (-1.5372, 1.8758, -0.2040). X
// is scaled by 0.3127 / 0.3290 = 0.9505, the X of the D65 white.
TEST(Chromaticities, xyz_under_d65_gives_the_usual_matrix) {
  Chromaticities xyz = kXyz;
  xyz.xy[6] = 0.3127, xyz.xy[7] = 0.3290;
  const auto matrix = rec709_from(xyz);
  ASSERT_TRUE(matrix);
  const double x = 0.3127 / 0.3290;
  EXPECT_NEAR((*matrix)[0][0] / x, 3.2406, 2e-3);
  EXPECT_NEAR((*matrix)[0][1] / x, -0.9689, 2e-3);
  EXPECT_NEAR((*matrix)[1][0], -1.5372, 2e-3);
  EXPECT_NEAR((*matrix)[1][1], 1.8758, 2e-3);
}

// White must stay white, so the weights of red, green and blue in each row sum to 1.
TEST(Chromaticities, white_of_another_colour_stays_white) {
  const auto matrix = rec709_from({{0.713, 0.293, 0.165, 0.830, 0.128, 0.044, 0.32168, 0.33767}});  // chromaticities of ACEScg
  ASSERT_TRUE(matrix);
  for (int row = 0; row < 3; ++row) EXPECT_NEAR((*matrix)[0][row] + (*matrix)[1][row] + (*matrix)[2][row], 1.0, 1e-9);
  EXPECT_NEAR((*matrix)[0][0], 1.7051, 2e-3);  // published value of the matrix from AP1 to Rec. 709 with Bradford adaptation
  EXPECT_NEAR((*matrix)[1][0], -0.6218, 2e-3);
}

/// Grey pixels with the exponent 129: the mantissa 128 is the light 1.
Bytes grey_hdr(const std::string& variables, const std::string& resolution, const std::vector<std::uint8_t>& mantissas) {
  std::string text = "#?RADIANCE\n" + variables + "\n" + resolution + "\n";
  for (const std::uint8_t mantissa : mantissas) text += std::string(3, static_cast<char>(mantissa)) + '\x81';
  return to_bytes(text);
}

std::vector<float> greys_of(const Bytes& file) {
  std::vector<float> greys;
  const std::vector<float> samples = decoded_as<float>(file);
  for (std::size_t i = 0; i < samples.size(); i += 3) greys.push_back(samples[i]);
  return greys;
}

TEST(DecodeHdr, exposures_and_colour_corrections_are_undone) {
  const std::string format = "FORMAT=32-bit_rle_rgbe\n";
  EXPECT_THAT(decoded_as<float>(grey_hdr(format, "-Y 1 +X 1", {128})), ElementsAre(1, 1, 1));
  EXPECT_THAT(decoded_as<float>(grey_hdr(format + "EXPOSURE=4\nEXPOSURE= 0.5 \n", "-Y 1 +X 1", {128})),
              ElementsAre(0.5f, 0.5f, 0.5f));
  EXPECT_THAT(decoded_as<float>(grey_hdr(format + "COLORCORR= 1 2 4\n", "-Y 1 +X 1", {128})), ElementsAre(1, 0.5f, 0.25f));
  EXPECT_THAT(decoded_as<float>(grey_hdr("\tEXPOSURE=2\n# EXPOSURE=3\n" + format, "-Y 1 +X 1", {128})),
              // EXPOSURE is ignored in comments and in indented lines, which repeat the headers of input pictures.
              ElementsAre(1, 1, 1));
  for (const char* exposure : {"0", "-1", "nan", "many", "1e-40"})
    EXPECT_THAT(
        error_message([&] { decode_picture(grey_hdr(format + "EXPOSURE=" + exposure + "\n", "-Y 1 +X 1", {128}), "a.hdr"); }),
        HasSubstr("a.hdr: cannot be read as a picture: its EXPOSURE"))
        << exposure;
}

// The file stores the pixels 64, 128, 192 and then 32, 96, 160.
TEST(DecodeHdr, resolution_sets_the_order_of_pixels) {
  const auto greys = [](const char* resolution) {
    const Bytes file = grey_hdr("FORMAT=32-bit_rle_rgbe\n", resolution, {64, 128, 192, 32, 96, 160});
    return greys_of(file);
  };
  EXPECT_THAT(greys("-Y 2 +X 3"), ElementsAre(0.5f, 1, 1.5f, 0.25f, 0.75f, 1.25f));
  EXPECT_THAT(greys("+Y 2 +X 3"), ElementsAre(0.25f, 0.75f, 1.25f, 0.5f, 1, 1.5f));
  EXPECT_THAT(greys("-Y 2 -X 3"), ElementsAre(1.5f, 1, 0.5f, 1.25f, 0.75f, 0.25f));
  EXPECT_THAT(greys("+Y 2 -X 3"), ElementsAre(1.25f, 0.75f, 0.25f, 1.5f, 1, 0.5f));
  EXPECT_THAT(greys("+X 2 -Y 3"), ElementsAre(0.5f, 0.25f, 1, 0.75f, 1.5f, 1.25f));
  EXPECT_THAT(greys("-X 2 -Y 3"), ElementsAre(0.25f, 0.5f, 0.75f, 1, 1.25f, 1.5f));
  EXPECT_THAT(greys("+X 2 +Y 3"), ElementsAre(1.5f, 1.25f, 1, 0.75f, 0.5f, 0.25f));
  EXPECT_THAT(greys("-X 2 +Y 3"), ElementsAre(1.25f, 1.5f, 0.75f, 1, 0.25f, 0.5f));
  for (const char* wrong : {"-Y 2 +Y 3", "Y 2 X 3", "-Y 2", "-Y 0 +X 3", "-Y two +X 3"})
    EXPECT_THAT(error_message([&] { greys(wrong); }), HasSubstr("the file: ")) << wrong;
}

TEST(DecodeHdr, old_runs_repeat_a_pixel) {
  std::string text = "#?RGBE\n\n-Y 1 +X 300\n";
  // one pixel of light 1, two runs that repeat it 42 and 256 times, and one pixel of light 0.5
  text += "\x80\x80\x80\x81\x01\x01\x01\x2a\x01\x01\x01\x01\x40\x40\x40\x81"s;
  const std::vector<float> greys = greys_of(to_bytes(text));
  ASSERT_EQ(greys.size(), 300u);
  EXPECT_EQ(greys[298], 1.0f);
  EXPECT_EQ(greys[299], 0.5f);
}

TEST(DecodeHdr, xyz_becomes_rgb_and_white_stays) {
  EXPECT_THAT(decoded_as<float>(grey_hdr("FORMAT=32-bit_rle_xyze\n", "-Y 1 +X 1", {128})),
              ElementsAre(FloatNear(1, 1e-5f), FloatNear(1, 1e-5f), FloatNear(1, 1e-5f)));
}

TEST(DecodeHdr, ignored_properties_are_reported) {
  const auto notices = [](const std::string& variables) { return header_in(grey_hdr(variables, "-Y 1 +X 1", {128})).notices; };
  EXPECT_THAT(notices("PIXASPECT=0.5\n"), ElementsAre("its pixels are 2 times as wide as high, and are read as square"));
  EXPECT_THAT(notices("GAMMA=2.2\n"), ElementsAre(HasSubstr("GAMMA")));
  EXPECT_THAT(notices("PRIMARIES= 0 0 0 0 0 0 0 0\n"), ElementsAre(HasSubstr("PRIMARIES")));
  EXPECT_THAT(notices("SOFTWARE=x\nVIEW= -vtv\nPIXASPECT=1\nGAMMA=1\n"), IsEmpty());
}

TEST(DecodeTga, columns_from_the_right) {
  const auto file = "\0\0\x03\0\0\0\0\0\0\0\0\0\x03\0\x01\0\x08\x30\x0a\x0b\x0c"sv;
  EXPECT_THAT(decoded_as<std::uint8_t>(to_bytes(file)), ElementsAre(12, 11, 10));
}

TEST(DecodeBmp, rows_from_the_bottom_or_the_top) {
  const auto bmp = [](std::int32_t height, std::string_view rows) {
    std::string file = "BM"s + std::string(8, '\0') + "\x36\0\0\0\x28\0\0\0\x01\0\0\0"s;
    for (int i = 0; i < 4; ++i) file += static_cast<char>(static_cast<std::uint32_t>(height) >> 8 * i & 0xff);
    return to_bytes(file + "\x01\0\x18\0"s + std::string(24, '\0') + std::string(rows));
  };
  const auto rows = "\x01\x02\x03\0\x04\x05\x06\0"sv;  // each row is padded by a byte
  EXPECT_THAT(decoded_as<std::uint8_t>(bmp(2, rows)), ElementsAre(6, 5, 4, 3, 2, 1));
  EXPECT_THAT(decoded_as<std::uint8_t>(bmp(-2, rows)), ElementsAre(3, 2, 1, 6, 5, 4));
  EXPECT_THAT(error_message([&] { decode_picture(bmp(2, rows.substr(0, 5)), "a.bmp"); }), HasSubstr("truncated"));
  const std::string old =
      "BM"s + std::string(12, '\0') + "\x0c\0\0\0\x01\0\x01\0\x01"s;  // an OS/2 header without its last 3 bytes
  EXPECT_THAT(error_message([&] { decode_picture(to_bytes(old), "a.bmp"); }), HasSubstr("truncated"));
}

const std::string kGifHeader = "GIF89a\2\0\1\0\x80\0\0\x0a\x0b\x0c\x14\x15\x16"s;

/// 1 or 2 pixels of the second colour at column `x`. LZW codes of 3 bits: 4 (clear), 1 per pixel, and 5 (end).
std::string gif_picture(char x, char width) {
  return "\x2c"s + x + "\0\0\0"s + width + "\0\1\0\0\2\2"s + (width == 2 ? "\x4c\x0a"s : "\x4c\x01"s) + '\0';
}

TEST(DecodeGif, transparent_and_uncovered_pixels_have_an_alpha) {
  const auto of = [](const std::string& blocks) { return to_bytes(kGifHeader + blocks + ";"); };
  EXPECT_THAT(decoded_as<std::uint8_t>(of(gif_picture(0, 2))), ElementsAre(20, 21, 22, 20, 21, 22));
  EXPECT_THAT(decoded_as<std::uint8_t>(of(gif_picture(1, 1))), ElementsAre(0, 0, 0, 0, 20, 21, 22, 255));
  const std::string transparent = "!\xf9\4\1\0\0\1\0"s, comment = "!\xfe\3abc\0"s;
  EXPECT_THAT(decoded_as<std::uint8_t>(of(comment + transparent + gif_picture(0, 2))), testing::SizeIs(8));
}

TEST(DecodeGif, first_picture_of_an_animation_is_read) {
  const std::string first = gif_picture(0, 2);
  EXPECT_THAT(header_in(to_bytes(kGifHeader + first + ";")).notices, IsEmpty());
  EXPECT_THAT(header_in(to_bytes(kGifHeader + first + first + ";")).notices, ElementsAre(HasSubstr("it is animated")));
}

TEST(DecodeGif, missing_or_too_large_picture_is_refused) {
  const auto message = [](const std::string& text) { return error_message([&] { decode_picture(to_bytes(text), "a.gif"); }); };
  EXPECT_THAT(message(kGifHeader + ";"), HasSubstr("a.gif: cannot be read as a picture: there is no picture in it"));
  EXPECT_THAT(message("GIF89a\0\0\1\0\0\0\0;"s), HasSubstr("0 x 1 pixels"));
  EXPECT_THAT(message("GIF89a\xff\xff\xff\xff\0\0\0;"s), HasSubstr("65535 x 65535 pixels"));
  EXPECT_THAT(message("GIF89a\xff\x3f\xff\x3f\0\0\0;"s), HasSubstr("cannot hold"));
}

TEST(Resolution, tiff_has_dots_per_inch) {
  const TempDir dir;
  write_tiff(dir / "a.tif", Image8{2, 1, std::vector<unsigned char>(6)}, {.pixels_per_mm = 600.0 / 25.4});
  TIFF* tiff = TIFFOpen((dir / "a.tif").c_str(), "r");
  float across = 0.0f, down = 0.0f;
  std::uint16_t unit = 0;
  TIFFGetField(tiff, TIFFTAG_XRESOLUTION, &across);
  TIFFGetField(tiff, TIFFTAG_YRESOLUTION, &down);
  TIFFGetField(tiff, TIFFTAG_RESOLUTIONUNIT, &unit);
  TIFFClose(tiff);
  EXPECT_FLOAT_EQ(across, 600.0f);
  EXPECT_FLOAT_EQ(down, 600.0f);
  EXPECT_EQ(unit, RESUNIT_INCH);
}

TEST(Resolution, heights_are_grey_png_with_resolution) {
  const TempDir dir;
  PngOptions options;
  options.dots_per_inch = 1440.0;
  write_png(dir / "a.png", HeightMap{2, 1, {0, 0x1234}}, options);
  std::ifstream file(dir / "a.png", std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  EXPECT_THAT(bytes, HasSubstr("IHDR" + big_endian(2) + big_endian(1) + "\x10\0"s)) << "16 bits, grey";
  EXPECT_THAT(bytes, HasSubstr("pHYs" + big_endian(56693) + big_endian(56693) + "\x01"));
  EXPECT_THAT(bytes, testing::Not(testing::AnyOf(HasSubstr("sRGB"), HasSubstr("gAMA"))));
  EXPECT_THAT(decoded_as<std::uint16_t>(to_bytes(bytes)), ElementsAre(0, 0x1234));
}

TEST(DecodePicture, other_kinds_of_files_are_named) {
  const auto message = [](std::string_view text) { return error_message([&] { decode_picture(to_bytes(text), "a.png"); }); };
  EXPECT_THAT(message("version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 7\n"),
              HasSubstr("a.png: cannot be read as a picture: it is a Git LFS pointer"));
  EXPECT_THAT(message("version https://git-lfs.github.com/spec/v1\n"), HasSubstr("git lfs pull"));
  EXPECT_THAT(message(""), HasSubstr("it is empty (0 bytes)"));
  EXPECT_THAT(message("<!DOCTYPE html>"), HasSubstr("it is a web page (HTML)"));
  EXPECT_THAT(message("hello"), HasSubstr("it is text that begins 'hello'; accepted: PNG, JPEG"));
}

}  // namespace
}  // namespace lippmann
