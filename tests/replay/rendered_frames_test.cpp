#include "lippmann/replay/rendered_frames.hpp"

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "image/exr.hpp"
#include "image/png.hpp"
#include "lippmann/image/encode.hpp"
#include "optics/optics_json.hpp"
#include "support/error_message.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

using test::TempDir;
using testing::HasSubstr;

Optics small_sheet() {
  Optics optics;
  optics.panel = {16, 4, 0.125f};
  return optics;
}

void write_report(const TempDir& dir, const Optics& optics) {
  std::ofstream(dir / "report.json") << nlohmann::ordered_json{{"optics", optics_json(optics)}, {"settings", {{"fps", 24.0}}}};
}

template <class Code>
auto codes(int width, int height, Code value) {
  return std::vector<Code>(static_cast<std::size_t>(3 * width * height), value);
}

TEST(RenderedFrames, codes_are_srgb_and_floats_linear) {
  const TempDir dir;
  write_report(dir, small_sheet());
  write_png(dir / "frame_0000.png", Image8{16, 4, codes<unsigned char>(16, 4, 188)});
  write_png(dir / "frame_0001.png", Image16{16, 4, codes<std::uint16_t>(16, 4, 188 * 257)});
  Image film(16, 4, 3);
  std::fill(film.data.begin(), film.data.end(), 2.5f);
  film.data[1] = std::nanf(""), film.data[2] = kInfinity;
  write_exr(dir / "frame_0002.exr", std::array{film_layer(film, ExrSample::kFloat)});
  const RenderedFrames frames = find_rendered_frames(dir.path());
  ASSERT_EQ(frames.files.size(), 3u);
  EXPECT_EQ(frames.frames_per_second, 24.0);
  const auto linear = static_cast<float>(linear_from_srgb(188.0 / 255.0));
  EXPECT_FLOAT_EQ(read_rendered_panel(frames, 0).picture.data[7], linear);
  EXPECT_FLOAT_EQ(read_rendered_panel(frames, 1).picture.data[7], linear);
  const Image exr = read_rendered_panel(frames, 2).picture;
  EXPECT_EQ(std::vector<float>(exr.data.begin(), exr.data.begin() + 4), (std::vector<float>{2.5f, 0.0f, 0.0f, 2.5f}));
}

TEST(RenderedFrames, only_frames_in_order_of_their_numbers) {
  const TempDir dir;
  write_report(dir, small_sheet());
  for (const char* name : {"frame_9999.png", "frame_10000.png", "frame_0003.png", "aov_0003.png", "eye_0003.png"})
    write_png(dir / name, Image8{16, 4, codes<unsigned char>(16, 4, 1)});
  std::ofstream(dir / "frame_0003.json") << "{}";
  std::vector<std::string> labels;
  for (const auto& file : find_rendered_frames(dir.path()).files) labels.push_back(frame_label(file));
  EXPECT_EQ(labels, (std::vector<std::string>{"0003", "9999", "10000"}));
}

TEST(RenderedFrames, pictures_mirrored_for_print_are_refused) {
  const TempDir dir;
  const nlohmann::ordered_json report{{"optics", optics_json(small_sheet())}, {"settings", {{"mirror", true}}}};
  std::ofstream(dir / "report.json") << report;
  write_png(dir / "frame_0000.png", Image8{16, 4, codes<unsigned char>(16, 4, 1)});
  EXPECT_THAT(test::error_message([&] { find_rendered_frames(dir.path()); }), HasSubstr("mirrored"));
}

TEST(RenderedFrames, slanted_frames_have_three_sub_pixels_each) {
  const TempDir dir;
  Optics optics;
  optics.panel = {16, 5, 0.09f};
  SlantedPanel slanted;
  slanted.periods = 3.3;
  optics.model = slanted;
  write_report(dir, optics);
  write_png(dir / "frame_0000.png", Image8{16, 5, codes<unsigned char>(16, 5, 9)});
  write_png(dir / "frame_0001.png", Image8{48, 5, codes<unsigned char>(48, 5, 9)});
  const RenderedFrames frames = find_rendered_frames(dir.path());
  EXPECT_EQ(read_rendered_panel(frames, 0).picture.width, 16);
  EXPECT_THAT(test::error_message([&] { read_rendered_panel(frames, 1); }), HasSubstr("48x5"));
}

}  // namespace
}  // namespace lippmann
