#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "image/decode.hpp"
#include "image/exr_channels.hpp"
#include "image/exr_header.hpp"
#include "support/error_message.hpp"
#include "support/exr_file.hpp"

namespace lippmann {
namespace {

using test::error_message;
using test::exr_chromaticities;
using test::exr_file;
using test::ExrPart;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

using Names = std::vector<std::string>;

std::vector<float> exr_samples(const std::vector<std::byte>& file) {
  return std::get<std::vector<float>>(decode_picture(file, "a.exr").samples);
}
Names exr_channels(const ExrPart& part) { return picture_header(exr_file(part), "a.exr").channels; }
Names exr_notices(const std::vector<std::byte>& file) { return picture_header(file, "a.exr").notices; }

/// Gives the channels the values 1, 2, 3, ...
ExrPart one_pixel(const Names& names) {
  ExrPart part;
  for (const std::string& name : names) part.channels.push_back({name, {1.0f + static_cast<float>(part.channels.size())}});
  return part;
}

TEST(ExrWindows, smaller_data_window_is_placed_correctly) {
  const ExrPart part{{1, 1, 2, 1}, {0, 0, 3, 2}, {{"A", {1, 1}}, {"Y", {5, 6}}}};
  const PictureHeader header = picture_header(exr_file(part), "a.exr");
  EXPECT_EQ(header.width, 4);
  EXPECT_EQ(header.height, 3);
  EXPECT_THAT(exr_samples(exr_file(part)), ElementsAre(0, 0, 0, 0, 0, 0, 0, 0,  //
                                                       0, 0, 5, 1, 6, 1, 0, 0,  //
                                                       0, 0, 0, 0, 0, 0, 0, 0));
}

TEST(ExrWindows, larger_data_window_is_cropped) {
  const ExrPart part{{-1, -1, 2, 1}, {0, 0, 1, 0}, {{"Y", {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}}}};
  EXPECT_THAT(exr_samples(exr_file(part)), ElementsAre(6, 7));
}

TEST(ExrWindows, windows_that_cross_share_their_common_pixels) {
  const ExrPart part{{9, 20, 10, 21}, {10, 21, 11, 22}, {{"Y", {1, 2, 3, 4}}}};
  EXPECT_THAT(exr_samples(exr_file(part)), ElementsAre(4, 0, 0, 0));
}

TEST(ExrWindows, disjoint_windows_give_black_and_a_notice) {
  const ExrPart part{{5, 5, 5, 5}, {0, 0, 0, 1}, {{"Y", {1}}}};
  EXPECT_THAT(exr_samples(exr_file(part)), ElementsAre(0, 0));
  EXPECT_THAT(exr_notices(exr_file(part)), ElementsAre(HasSubstr("the picture is empty")));
}

TEST(ExrWindows, absurd_display_windows_are_refused) {
  for (const test::ExrWindow display : {test::ExrWindow{0, 0, 16383, 16383}, test::ExrWindow{0, 0, 2000000000, 0},
                                        test::ExrWindow{-2147483647, 0, 2147483647, 0}, test::ExrWindow{3, 3, 2, 2}})
    EXPECT_THAT(error_message([&] {
                  decode_picture(exr_file(ExrPart{{}, display, {{"Y", {1}}}}), "a.exr");
                }),
                AllOf(HasSubstr("a.exr: "), HasSubstr(" display window "), Not(HasSubstr("memory"))));
}

TEST(ExrWindows, empty_and_distant_data_windows_are_refused) {
  for (const test::ExrWindow data :
       {test::ExrWindow{0, 0, -1, 0}, test::ExrWindow{0, 0, 70000, 0}, test::ExrWindow{2147483000, 0, 2147483000, 0}}) {
    std::vector<std::byte> file = exr_file(ExrPart{{}, {}, {{"Y", {1}}}});
    const std::string name("dataWindow\0box2i\0", 17);
    const auto* letters = reinterpret_cast<const std::byte*>(name.data());
    const auto at = std::search(file.begin(), file.end(), letters, letters + name.size());
    std::memcpy(&at[static_cast<std::ptrdiff_t>(name.size()) + 4], &data, sizeof data);
    EXPECT_THAT(error_message([&] { decode_picture(file, "a.exr"); }), HasSubstr("its data window from ("));
  }
}

TEST(ExrWindows, pixels_without_a_width_are_refused) {
  ExrPart part{{}, {}, {{"Y", {1}}}};
  part.pixel_aspect = 0.0f;
  EXPECT_THAT(error_message([&] { decode_picture(exr_file(part), "a.exr"); }), HasSubstr("its pixels are 0 times as wide"));
}

TEST(ExrChannels, colour_names_ignore_case_and_layers) {
  EXPECT_THAT(exr_channels(one_pixel({"b", "g", "r"})), ElementsAre("r", "g", "b"));
  EXPECT_THAT(exr_samples(exr_file(one_pixel({"b", "g", "r"}))), ElementsAre(3, 2, 1));
  EXPECT_THAT(exr_channels(one_pixel({"Alpha", "Blue", "Green", "Red"})), ElementsAre("Red", "Green", "Blue", "Alpha"));
  EXPECT_THAT(exr_channels(one_pixel({"B", "G", "R", "a", "z"})), ElementsAre("R", "G", "B", "a", "z"));
  EXPECT_THAT(exr_channels(one_pixel({"VL.Combined.A", "VL.Combined.B", "VL.Combined.G", "VL.Combined.R", "VL.Depth.Z"})),
              ElementsAre("VL.Combined.R", "VL.Combined.G", "VL.Combined.B", "VL.Combined.A", "VL.Depth.Z"));
  EXPECT_THAT(exr_channels(one_pixel({"A", "Y"})), ElementsAre("Y", "A"));
}

TEST(ExrChannels, main_layer_comes_first) {
  ExrPart part = one_pixel({"diffuse.B", "diffuse.G", "diffuse.R", "rgba.B", "rgba.G", "rgba.R"});
  EXPECT_EQ(exr_channels(part).front(), "rgba.R");
  EXPECT_THAT(exr_notices(exr_file(part)), IsEmpty());
  part = one_pixel({"diffuse.B", "diffuse.G", "diffuse.R", "glossy.B", "glossy.G", "glossy.R"});
  EXPECT_EQ(exr_channels(part).front(), "diffuse.R");
  EXPECT_THAT(exr_notices(exr_file(part)), ElementsAre("of its layers only 'diffuse' is read, not 'glossy'"));
  part = one_pixel({"B", "G", "R", "albedo.B", "albedo.G", "albedo.R"});
  EXPECT_EQ(exr_channels(part).front(), "R");
  EXPECT_THAT(exr_notices(exr_file(part)), IsEmpty());
}

TEST(ExrChannels, colours_are_counted_without_other_channels) {
  const auto colors = [](const Names& names) { return picture_header(exr_file(one_pixel(names)), "a.exr").colors; };
  EXPECT_EQ(colors({"B", "G", "R", "Z"}), 3);
  EXPECT_EQ(colors({"N.X", "Y", "Z"}), 1);
  EXPECT_EQ(colors({"mask"}), 1);
  EXPECT_EQ(colors({"gray"}), 1);
  EXPECT_EQ(colors({"R"}), 1);
  for (const char* data : {"Z", "A", "VL.Depth.Z", "Depth.V", "depth", "RY"}) EXPECT_EQ(colors({data}), 0) << data;
  EXPECT_EQ(colors({"X", "Y", "Z"}), 0);  // three channels named X, Y and Z hold a position
  EXPECT_EQ(colors({"u", "v"}), 0);
}

// Red: (RY + 1) Y = 1.5 * 0.5 = 0.75. Blue: (BY + 1) Y = 0.5 * 0.5 = 0.25. Green follows from the luminance Y = 0.5: (Y
// - 0.2126 red - 0.0722 blue) / 0.7152.
TEST(ExrChannels, luminance_and_chroma_become_colours) {
  ExrPart part{{0, 0, 1, 1},
               {0, 0, 1, 1},
               {{"BY", {-0.5f, -0.5f, -0.5f, -0.5f}}, {"RY", {0.5f, 0.5f, 0.5f, 0.5f}}, {"Y", {0.5f, 0.5f, 0.5f, 0.5f}}}};
  for (const int sampling : {1, 2}) {
    part.chroma_sampling = sampling;
    EXPECT_THAT(exr_channels(part), ElementsAre("R", "G", "B"));
    const std::vector<float> samples = exr_samples(exr_file(part));
    ASSERT_EQ(samples.size(), 12u);
    for (std::size_t i = 0; i < samples.size(); i += 3) {
      EXPECT_NEAR(samples[i], 0.75f, 2e-3f) << sampling;
      EXPECT_NEAR(samples[i + 1], 0.4509f, 2e-3f) << sampling;
      EXPECT_NEAR(samples[i + 2], 0.25f, 2e-3f) << sampling;
    }
  }
}

TEST(ExrChromaticities, exchanged_primaries_exchange_colours) {
  ExrPart part = one_pixel({"B", "G", "R"});
  part.attributes = exr_chromaticities({0.30f, 0.60f, 0.64f, 0.33f, 0.15f, 0.06f, 0.3127f, 0.3290f});
  EXPECT_THAT(exr_samples(exr_file(part)),
              ElementsAre(::testing::FloatNear(2, 1e-5f), ::testing::FloatNear(3, 1e-5f), ::testing::FloatNear(1, 1e-5f)));
  EXPECT_THAT(exr_notices(exr_file(part)), IsEmpty());
}

TEST(ExrChromaticities, rec709_keeps_its_bits) {
  ExrPart part = one_pixel({"B", "G", "R"});
  part.attributes = exr_chromaticities({0.64f, 0.33f, 0.30f, 0.60f, 0.15f, 0.06f, 0.3127f, 0.3290f});
  EXPECT_THAT(exr_samples(exr_file(part)), ElementsAre(3, 2, 1));
}

TEST(ExrChromaticities, nonsense_is_a_notice) {
  ExrPart part = one_pixel({"B", "G", "R"});
  part.attributes = exr_chromaticities({0, 0, 0, 0, 0, 0, 0, 0});
  EXPECT_THAT(exr_samples(exr_file(part)), ElementsAre(3, 2, 1));
  EXPECT_THAT(exr_notices(exr_file(part)), ElementsAre(HasSubstr("chromaticities")));
}

TEST(ExrNotices, non_square_pixels_give_a_notice) {
  ExrPart part = one_pixel({"Y"});
  part.pixel_aspect = 2.0f;
  EXPECT_THAT(exr_notices(exr_file(part)), ElementsAre("its pixels are 2 times as wide as high, and are read as square"));
}

TEST(ExrParts, first_part_with_colours_is_read) {
  ExrPart depth = one_pixel({"U", "V"}), color = one_pixel({"B", "G", "R"});
  depth.name = "depth", color.name = "color";
  const std::vector<std::byte> file = exr_file(std::vector{depth, color});
  EXPECT_THAT(exr_samples(file), ElementsAre(3, 2, 1));
  EXPECT_THAT(exr_notices(file), ElementsAre("only 'color' of its 2 parts is read, not 'depth'"));
  depth = color;
  depth.name = "other";
  EXPECT_THAT(exr_notices(exr_file(std::vector{color, depth})),
              ElementsAre("only 'color' of its 2 parts is read, not 'other'"));
}

TEST(ExrParts, leading_part_of_one_channel_is_skipped) {
  for (const char* name : {"Z", "Depth.V", "mask"}) {
    ExrPart first = one_pixel({name}), color = one_pixel({"B", "G", "R"});
    first.name = "first", color.name = "color";
    const std::vector<std::byte> file = exr_file(std::vector{first, color});
    EXPECT_THAT(exr_samples(file), ElementsAre(3, 2, 1)) << name;
    EXPECT_THAT(exr_notices(file), ElementsAre("only 'color' of its 2 parts is read, not 'first'")) << name;
  }
}

// OpenEXR 3.4 reads zeros beyond the end of a truncated file, so check_exr_file() must find every truncation.
TEST(ExrFile, every_cut_is_found_by_the_chunks) {
  const ExrPart part{{0, 0, 3, 2}, {0, 0, 3, 2}, {{"Y", {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}}}};
  ExrPart named = part, second = part;
  named.name = "a", second.name = "b";
  for (const std::vector<std::byte>& file : {exr_file(part), exr_file(std::vector{named, second})}) {
    decode_picture(file, "a.exr");
    check_exr_file(file, "a.exr");
    for (std::size_t cut = 1; cut <= file.size(); ++cut)
      EXPECT_THROW(check_exr_file(std::span(file).first(file.size() - cut), "a.exr"), Error) << cut;
  }
}

TEST(ExrFile, chunk_beyond_the_file_is_an_error) {
  std::vector<std::byte> file = exr_file(ExrPart{{0, 0, 0, 1}, {0, 0, 0, 1}, {{"Y", {1, 2}}}});
  file[file.size() - 2 * 12 + 5] = std::byte{1};  // changes the size of the first chunk from 4 to 256 + 4
  EXPECT_THAT(error_message([&] { decode_picture(file, "a.exr"); }), HasSubstr("the file is truncated"));
}

// Two levels of one tile each: 2 x 2 pixels and their mean.
TEST(ExrFile, tiles_of_smaller_levels_are_counted) {
  using test::bytes_of_value;
  const std::vector<std::byte> scan_lines =
      exr_file(ExrPart{{0, 0, 1, 1},
                       {0, 0, 1, 1},
                       {{"Y", {1, 2, 3, 4}}},
                       1.0f,
                       test::exr_attribute("tiles", "tiledesc", bytes_of_value(2) + bytes_of_value(2) + '\x01')});
  std::string file(reinterpret_cast<const char*>(scan_lines.data()), scan_lines.size() - 2 * 8 - 2 * 16);
  file[5] = '\x02';  // flag of tiled files
  const auto tile = [](int level, const std::vector<float>& values) {
    std::string chunk;
    for (const int word : {0, 0, level, level, static_cast<int>(4 * values.size())}) chunk += bytes_of_value(word);
    for (const float value : values) chunk += bytes_of_value(value);
    return chunk;
  };
  const std::string fine = tile(0, {1, 2, 3, 4}), coarse = tile(1, {2.5f});
  const std::uint64_t places = file.size() + 16;
  file += bytes_of_value(places) + bytes_of_value(places + fine.size()) + fine + coarse;
  const auto bytes = std::as_bytes(std::span(file));
  EXPECT_THAT(exr_samples({bytes.begin(), bytes.end()}), ElementsAre(1, 2, 3, 4));
  EXPECT_THROW(check_exr_file(bytes.first(bytes.size() - 1), "a.exr"), Error);
}

}  // namespace
}  // namespace lippmann
