#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>

#include "image/exr.hpp"
#include "image/png.hpp"
#include "image/read_image.hpp"
#include "image/tiff.hpp"
#include "lippmann/image/encode.hpp"
#include "support/error_message.hpp"
#include "support/file_size_limit.hpp"
#include "support/pictures.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;
using test::error_message;
using test::noise_codes;
using test::noise_image;
using test::TempDir;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::string file_bytes(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

fs::path truncated(const fs::path& whole, double share) {
  const std::string bytes = file_bytes(whole);
  const fs::path path = whole.parent_path() / ("truncated" + whole.extension().string());
  std::ofstream(path, std::ios::binary) << bytes.substr(0, static_cast<std::size_t>(bytes.size() * share));
  return path;
}

TEST(Png, eight_bit_codes_survive_any_option) {
  const TempDir dir;
  const Image8 image = noise_codes(37, 21);
  for (const PngStrategy strategy :
       {PngStrategy::kDefault, PngStrategy::kFiltered, PngStrategy::kRunLength, PngStrategy::kHuffman})
    for (const PngFilter filter :
         {PngFilter::kNone, PngFilter::kLeft, PngFilter::kUp, PngFilter::kAverage, PngFilter::kPaeth, PngFilter::kAdaptive}) {
      write_png(dir / "a.png", image, {3, strategy, filter});
      const Image8 read = read_image8(dir / "a.png");
      EXPECT_EQ(read.width, 37);
      EXPECT_EQ(read.height, 21);
      EXPECT_EQ(read.rgb, image.rgb);
    }
}

TEST(Png, sixteen_bit_codes_come_back) {
  const TempDir dir;
  const Image16 image = to_codes16(noise_image(19, 23, 3), Encoding::kSrgb);
  write_png(dir / "a.png", image);
  const Image read = read_image(dir / "a.png");
  ASSERT_EQ(read.data.size(), image.rgb.size());
  for (std::size_t i = 0; i < image.rgb.size(); ++i) EXPECT_EQ(std::lround(read.data[i] * 65535.0), image.rgb[i]);
}

TEST(Png, equal_pictures_give_equal_bytes) { EXPECT_EQ(encode_png(noise_codes(16, 16)), encode_png(noise_codes(16, 16))); }

TEST(Png, missing_folder_is_an_error) {
  const TempDir dir;
  const std::string message = error_message([&] { write_png(dir / "none/a.png", noise_codes(4, 4)); });
  EXPECT_THAT(message, AllOf(HasSubstr("none/a.png"), HasSubstr("there is no folder")));
}

TEST(Png, full_disk_leaves_no_file) {
  const TempDir dir;
  {
    const test::FileSizeLimit full(4096);
    EXPECT_THAT(error_message([&] { write_png(dir / "a.png", noise_codes(64, 64)); }), HasSubstr("a.png: cannot be written"));
  }
  EXPECT_TRUE(fs::is_empty(dir.path()));
}

TEST(Png, size_outside_the_limits_is_an_error) {
  EXPECT_THAT(error_message([] { encode_png(Image8{}); }), HasSubstr("sides of 1 to 65536"));
  EXPECT_THAT(error_message([] {
                encode_png(Image8{65537, 1, std::vector<unsigned char>(3 * 65537)});
              }),
              HasSubstr("65537 x 1"));
}

// The version number after "II" is 42 in a classic TIFF, and 43 in a BigTIFF, whose offsets have 8 bytes.
TEST(Tiff, big_tiff_has_the_same_codes) {
  const test::TempDir dir;
  const Image8 codes = noise_codes(33, 17);
  const auto version = [](const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    char begin[4]{};
    file.read(begin, sizeof(begin));
    EXPECT_EQ(std::string(begin, 2), "II");
    return static_cast<int>(begin[2]);
  };
  write_tiff(dir / "small.tif", codes, {.pixels_per_mm = 10.0});
  write_tiff(dir / "big.tif", codes, {10.0, TiffKind::kBig});
  EXPECT_EQ(version(dir / "small.tif"), 42);
  EXPECT_EQ(version(dir / "big.tif"), 43);
  EXPECT_EQ(read_image8(dir / "big.tif").rgb, codes.rgb);
}

TEST(Alpha, is_stored_unassociated) {
  const TempDir dir;
  Image8 codes = noise_codes(5, 3);
  Image16 wide = to_codes16(noise_image(5, 3, 3), Encoding::kSrgb);
  for (int i = 0; i < 15; ++i) {
    codes.alpha.push_back(static_cast<unsigned char>(17 * i));
    wide.alpha.push_back(static_cast<std::uint16_t>(4369 * i));
  }
  write_png(dir / "a.png", codes);
  write_tiff(dir / "a.tif", codes);
  write_png(dir / "wide.png", wide);
  for (const auto& [name, max] : {std::pair("a.png", 255.0), {"a.tif", 255.0}, {"wide.png", 65535.0}}) {
    const Image read = read_image(dir / name);
    ASSERT_EQ(read.channels, 4) << name;
    for (std::size_t i = 0; i < 60; ++i) {
      const std::size_t p = i / 4, c = i % 4;
      const int code =
          max == 255.0 ? (c == 3 ? codes.alpha[p] : codes.rgb[3 * p + c]) : (c == 3 ? wide.alpha[p] : wide.rgb[3 * p + c]);
      EXPECT_EQ(std::lround(read.data[i] * max), code) << name << " " << i;
    }
  }
}

TEST(Alpha, divides_premultiplied_light) {
  Image film(3, 1, 3), alpha(3, 1, 1);
  film.data = {0.25f, 0.5f, 0.0f, 0.5f, 0.25f, 1.0f, 0.0f, 0.0f, 0.0f};
  alpha.data = {0.5f, 1.0f, 0.0f};
  divide_by_alpha(alpha, film);
  EXPECT_EQ(film.data, (std::vector<float>{0.5f, 1.0f, 0.0f, 0.5f, 0.25f, 1.0f, 0.0f, 0.0f, 0.0f}));
  EXPECT_THAT(alpha_codes(alpha), ElementsAre(128, 255, 0));
  EXPECT_THAT(alpha_codes16(alpha), ElementsAre(32768, 65535, 0));
}

ExrLayer ids_layer(const Image& ids) { return {"", &ids, {"id"}, ExrSample::kFloat}; }

TEST(Exr, float_layers_survive_bit_by_bit) {
  const TempDir dir;
  const Image film = noise_image(13, 9, 3, 1), depth = noise_image(13, 9, 1, 2), normal = noise_image(13, 9, 3, 3),
              id = noise_image(13, 9, 1, 4), position = noise_image(13, 9, 3, 5);
  const ExrLayer layers[] = {film_layer(film, ExrSample::kFloat),
                             depth_layer(depth),
                             {"N", &normal, {"X", "Y", "Z"}},
                             ids_layer(id),
                             {"P", &position, {"X", "Y", "Z"}, ExrSample::kFloat}};
  write_exr(dir / "a.exr", layers);
  EXPECT_EQ(read_channels(dir / "a.exr", std::vector<std::string>{"R", "G", "B"}).data, film.data);
  EXPECT_EQ(read_channels(dir / "a.exr", std::vector<std::string>{"Z"}).data, depth.data);
  EXPECT_EQ(read_channels(dir / "a.exr", std::vector<std::string>{"id"}).data, id.data);
  EXPECT_EQ(read_channels(dir / "a.exr", std::vector<std::string>{"P.X", "P.Y", "P.Z"}).data, position.data);
  const Image n = read_channels(dir / "a.exr", std::vector<std::string>{"N.X", "N.Y", "N.Z"});
  for (std::size_t i = 0; i < n.data.size(); ++i)
    EXPECT_NEAR(n.data[i], normal.data[i], 0x1p-12) << "half has 11 bits of precision: half a unit of 2^-11 below 1";
}

TEST(Exr, half_precision_film_comes_first) {
  const TempDir dir;
  const Image film = noise_image(8, 8, 3), depth = noise_image(8, 8, 1);
  const ExrLayer layers[] = {depth_layer(depth), film_layer(film)};
  write_exr(dir / "a.exr", layers);
  EXPECT_THAT(channel_names(dir / "a.exr"), ElementsAre("R", "G", "B", "Z"));
  EXPECT_EQ(read_image(dir / "a.exr").channels, 4);
}

TEST(Exr, infinite_depth_and_negative_ids_are_kept) {
  const TempDir dir;
  Image depth(2, 1, 1), id(2, 1, 1);
  depth.data = {-std::numeric_limits<float>::infinity(), 3.5f};
  id.data = {-1.0f, 16777215.0f};
  const ExrLayer layers[] = {depth_layer(depth), ids_layer(id)};
  for (const ExrCompression compression : {ExrCompression::kNone, ExrCompression::kRunLength, ExrCompression::kZipRow,
                                           ExrCompression::kZip, ExrCompression::kPiz}) {
    write_exr(dir / "a.exr", layers, compression);
    EXPECT_EQ(read_channels(dir / "a.exr", std::vector<std::string>{"Z"}).data, depth.data);
    EXPECT_EQ(read_channels(dir / "a.exr", std::vector<std::string>{"id"}).data, id.data);
  }
}

TEST(Exr, equal_pictures_give_equal_bytes) {
  const TempDir dir;
  const Image film = noise_image(8, 8, 3);
  const ExrLayer layers[] = {film_layer(film)};
  write_exr(dir / "a.exr", layers);
  EXPECT_THAT(file_bytes(dir / "a.exr"), HasSubstr("1970:01:01"));
  EXPECT_THAT(file_bytes(dir / "a.exr"), ::testing::Not(HasSubstr(":20")));
}

TEST(Exr, incompatible_layers_are_errors) {
  const TempDir dir;
  const Image small = noise_image(4, 4, 1), large = noise_image(8, 4, 1);
  const ExrLayer sizes[] = {depth_layer(small), ids_layer(large)};
  EXPECT_THAT(error_message([&] { write_exr(dir / "a.exr", sizes); }), HasSubstr("differs in size"));
  const ExrLayer twice[] = {depth_layer(small), depth_layer(small)};
  EXPECT_THAT(error_message([&] { write_exr(dir / "a.exr", twice); }), HasSubstr("two channels are called Z"));
  EXPECT_THAT(error_message([&] { write_exr(dir / "a.exr", {}); }), HasSubstr("without layers"));
}

TEST(Exr, full_disk_leaves_no_file) {
  const TempDir dir;
  const Image film = noise_image(64, 64, 3);
  const ExrLayer layers[] = {film_layer(film)};
  {
    const test::FileSizeLimit full(4096);
    EXPECT_THAT(error_message([&] { write_exr(dir / "a.exr", layers); }), HasSubstr("a.exr: cannot be written"));
  }
  EXPECT_TRUE(fs::is_empty(dir.path()));
}

TEST(ReadImage, eight_bit_codes_are_code_over_255) {
  const TempDir dir;
  write_png(dir / "a.png", Image8{2, 1, {0, 1, 127, 128, 254, 255}});
  EXPECT_THAT(read_image(dir / "a.png").data,
              ElementsAre(0.0f, 1.0f / 255.0f, 127.0f / 255.0f, 128.0f / 255.0f, 254.0f / 255.0f, 1.0f));
}

TEST(ReadImage8, sixteen_bit_codes_are_rounded_to_eight) {
  const TempDir dir;
  // a 16-bit code is rounded to the nearest code / 257, which changes at 257 k + 128.5
  write_png(dir / "a.png", Image16{2, 1, {0, 128, 129, 65535, 65407, 65406}});
  EXPECT_THAT(read_image8(dir / "a.png").rgb, ElementsAre(0, 0, 1, 255, 255, 254));
}

TEST(ReadImage8, linear_exr_is_encoded_as_srgb) {
  const TempDir dir;
  Image film(2, 1, 3);
  film.data = {0.0f, 0.5f, 1.0f, 2.0f, 0.25f, -1.0f};
  const ExrLayer layers[] = {film_layer(film)};
  write_exr(dir / "a.exr", layers);
  EXPECT_EQ(read_image8(dir / "a.exr").rgb, to_codes(film, Encoding::kSrgb).rgb);
}

TEST(ReadImage8, grey_picture_is_repeated) {
  const TempDir dir;
  std::ofstream(dir / "a.pgm", std::ios::binary) << "P5\n2 1\n255\n" << '\x07' << '\x64';
  EXPECT_THAT(read_image8(dir / "a.pgm").rgb, ElementsAre(7, 7, 7, 100, 100, 100));
}

TEST(ReadImage, missing_and_empty_files_are_errors) {
  const TempDir dir;
  std::ofstream(dir / "empty.png").flush();
  EXPECT_THAT(error_message([&] { read_image(dir / "none.png"); }), HasSubstr("none.png: there is no such file"));
  EXPECT_THAT(error_message([&] { read_image(dir.path()); }), HasSubstr("is not a regular file but a folder"));
  EXPECT_THAT(error_message([&] { read_image(dir / "empty.png"); }),
              HasSubstr("empty.png: cannot be read as a picture: it is empty (0 bytes)"));
}

TEST(ReadImage, text_file_is_an_error) {
  const TempDir dir;
  for (const char* name : {"a.png", "a.exr", "a.tif", "a.jpg", "a.txt"}) {
    std::ofstream(dir / name) << "this is not a picture";
    EXPECT_THAT(error_message([&] { read_image(dir / name); }), HasSubstr(name)) << name;
  }
}

TEST(ReadImage, truncated_png_and_exr_are_errors) {
  const TempDir dir;
  const Image film = noise_image(64, 64, 3);
  const ExrLayer layers[] = {film_layer(film)};
  write_png(dir / "a.png", noise_codes(64, 64));
  write_exr(dir / "a.exr", layers);
  for (const double share : {0.02, 0.2, 0.5, 0.9, 0.98})
    for (const char* name : {"a.png", "a.exr"})
      EXPECT_THAT(error_message([&] { read_image(truncated(dir / name, share)); }), HasSubstr("truncated")) << name << share;
}

TEST(ReadImage, truncated_jpeg_scan_is_an_error) {
  const TempDir dir;
  std::ofstream(dir / "a.jpg", std::ios::binary) << "\xff\xd8\xff\xe0" << std::string(5000, 'x');
  EXPECT_THAT(error_message([&] { read_image(dir / "a.jpg"); }), HasSubstr("the file is truncated"));
}

TEST(ReadImage, header_of_a_huge_picture_is_refused) {
  const TempDir dir;
  std::ofstream(dir / "a.ppm", std::ios::binary) << "P6\n60000 60000\n255\nabc";
  EXPECT_THAT(error_message([&] { read_image(dir / "a.ppm"); }), HasSubstr("60000 x 60000"));
  std::ofstream(dir / "b.ppm", std::ios::binary) << "P6\n100000 1\n255\nabc";
  EXPECT_THAT(error_message([&] { read_image(dir / "b.ppm"); }), HasSubstr("100000 x 1"));
}

TEST(ReadChannels, unknown_name_lists_the_known_ones) {
  const TempDir dir;
  const Image film = noise_image(4, 4, 3);
  const ExrLayer layers[] = {film_layer(film)};
  write_exr(dir / "a.exr", layers);
  EXPECT_THAT(error_message([&] { read_channels(dir / "a.exr", std::vector<std::string>{"Z"}); }),
              AllOf(HasSubstr("has no channel Z"), HasSubstr("R, G, B")));
}

}  // namespace
}  // namespace lippmann
