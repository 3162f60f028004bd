#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tiffio.h>

#include <array>
#include <fstream>

#include "image/print_file.hpp"
#include "support/error_message.hpp"
#include "support/icc_profile.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;
using test::error_message;
using testing::ElementsAre, testing::HasSubstr;

const Image8 kCodes{2, 2, {255, 255, 255, 0, 0, 0, 119, 119, 119, 100, 150, 120}};

class PrintFile : public testing::Test {
 protected:
  fs::path file_with(const std::string& name, const std::string& bytes) {
    std::ofstream(dir_ / name, std::ios::binary) << bytes;
    return dir_ / name;
  }

  test::TempDir dir_;
};

TEST_F(PrintFile, tiff_keeps_16_bits) {
  const Image16 words{2, 1, {0, 1, 65535, 300, 40000, 257}};
  write_print(dir_ / "a.tiff", words, 300.0);
  EXPECT_EQ(std::get<Image16>(read_picture(dir_ / "a.tiff")).rgb, words.rgb);
}

TEST_F(PrintFile, floats_cannot_be_written_as_tiff) {
  EXPECT_THAT(error_message([&] { write_print(dir_ / "a.tiff", Image(1, 1, 3), 300.0); }), HasSubstr("a.tiff"));
  EXPECT_FALSE(fs::exists(dir_ / "a.tiff"));
}

#ifdef LIPPMANN_HAS_LCMS

TEST_F(PrintFile, colours_are_converted_to_the_profile) {
  const OutputProfile p3(file_with("p3.icc", test::profile_with(test::kP3Primaries, 2.2)));
  for (const char* name : {"a.png", "a.tiff"}) {
    write_print(dir_ / name, kCodes, 300.0, &p3);
    const auto read = std::get<Image8>(read_picture(dir_ / name));
    for (std::size_t i = 0; i < kCodes.rgb.size(); ++i) EXPECT_NEAR(read.rgb[i], kCodes.rgb[i], 1) << name << " " << i;
    std::vector<std::string> notices;
    read_picture(dir_ / name, [&](std::string_view text) { notices.emplace_back(text); });
    EXPECT_THAT(notices, testing::IsEmpty());
  }
}

TEST_F(PrintFile, inks_of_a_press) {
  const OutputProfile press(file_with("press.icc", test::press_profile()));
  write_print(dir_ / "a.tiff", kCodes, 720.0, &press);
  TIFF* tiff = TIFFOpen((dir_ / "a.tiff").c_str(), "r");
  std::uint16_t photometric = 0;
  float dpi = 0.0f;
  TIFFGetField(tiff, TIFFTAG_PHOTOMETRIC, &photometric);
  TIFFGetField(tiff, TIFFTAG_XRESOLUTION, &dpi);
  std::array<unsigned char, 16> inks{};
  EXPECT_EQ(TIFFReadEncodedStrip(tiff, 0, inks.data(), inks.size()), 16);
  TIFFClose(tiff);
  EXPECT_EQ(photometric, PHOTOMETRIC_SEPARATED);
  EXPECT_EQ(dpi, 720.0f);
  EXPECT_THAT(std::vector(inks.begin(), inks.begin() + 8), ElementsAre(0, 0, 0, 0, 0, 0, 0, 255)) << "white, black";
  EXPECT_NEAR(inks[11], 127, 2) << "119 is L* = 50";
  EXPECT_NEAR(std::get<Image8>(read_picture(dir_ / "a.tiff")).rgb[6], 119, 2);
}

TEST_F(PrintFile, refusals_leave_nothing_behind) {
  const OutputProfile press(file_with("press.icc", test::press_profile()));
  EXPECT_THAT(error_message([&] { write_print(dir_ / "a.png", kCodes, 300.0, &press); }),
              HasSubstr("only TIFF files can store the inks"));
  EXPECT_FALSE(fs::exists(dir_ / "a.png"));
  EXPECT_THAT(error_message([&] { OutputProfile(dir_ / "none.icc"); }), HasSubstr("none.icc"));
  const std::string whole = test::press_profile();
  for (const std::size_t size : {std::size_t{0}, std::size_t{127}, std::size_t{140}}) {
    const fs::path cut = file_with("cut.icc", whole.substr(0, size));
    EXPECT_THAT(error_message([&] { OutputProfile{cut}; }), HasSubstr("is not an ICC output profile")) << size;
  }
}

#endif

}  // namespace
}  // namespace lippmann
