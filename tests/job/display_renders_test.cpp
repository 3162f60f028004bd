#include <gmock/gmock.h>

#include <cmath>
#include <cstdint>
#include <fstream>
#include <nlohmann/json.hpp>

#include "compare/compare.hpp"
#include "job/renders.hpp"
#include "job/report.hpp"
#include "replay/precompensated_frames.hpp"
#include "replay/replay.hpp"
#include "support/small_panel.hpp"

namespace lippmann::test {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using Json = nlohmann::ordered_json;

class DisplayRenders : public Renders {
 protected:
  DisplayRenders() {
    write_small_panel(dir_ / "panel.toml");
    std::ofstream(dir_ / "sheet.toml") << R"(description = "print"
kind = "lenticular-sheet"
pixels = [240, 120]
dpi = 120
view_cone_deg = 40
[lenses]
lenses_per_inch = 20
)";
  }

  RenderParams teapot_on(const std::string& display, const Settings& more, const std::string& folder = "out") const {
    const std::string file = display.ends_with(".toml") ? (dir_ / display).string() : display;
    return job("teapot", folder, Settings{{"frames", "3"}, {"display", file}} + more);
  }

  Json report_of(const RenderParams& params) { return to_json(render(params)); }

  bool are_identical(const std::string& a, const std::string& b) const {
    return compare(dir_ / a, dir_ / b, context_).identical;
  }
};

TEST_F(DisplayRenders, slanted_panel_gets_its_quilt) {
  const Json optics = report_of(teapot_on("panel.toml", {}))["optics"];
  EXPECT_TRUE(exists("out/frame_0003_qs4x2a0.75.png"));
  EXPECT_EQ(optics["kind"], "multiview");
  EXPECT_EQ(optics["width"], 129);
  EXPECT_NEAR(optics["view_cone_deg"].get<double>(), 40.0, 1e-4);
  // Tiles of 32 x 64 pixels on 48 x 64 display pixels: the pixels of a tile are 1.5 display pixels wide and 1 high.
  EXPECT_NEAR(optics["pixel_height"].get<double>(), 2.0 / 3.0, 1e-6);
}

TEST_F(DisplayRenders, native_frame_has_the_panels_pixels) {
  const Json optics = report_of(teapot_on("panel.toml", {{"layout", "native"}, {"video", dir_ / "a.mkv"}}))["optics"];
  EXPECT_EQ(optics["kind"], "slanted");
  EXPECT_EQ(optics["width"], 3 * 48);
  EXPECT_TRUE(are_identical("out", "a.mkv"));
}

/// Numerator and denominator of a TIFF file's XResolution (tag 282 = 0x011a, type 5 = rational).
std::pair<std::uint32_t, std::uint32_t> resolution_of(const std::string& tiff) {
  const std::size_t at = tiff.find(std::string("\x1a\x01\x05\x00\x01\x00\x00\x00", 8));
  const auto word = [&](std::size_t i) {
    std::uint32_t value = 0;
    for (std::size_t b = 0; b < 4; ++b)
      value |= static_cast<std::uint32_t>(static_cast<unsigned char>(tiff.at(i + b))) << (8 * b);
    return value;
  };
  const std::uint32_t rational = word(at + 8);
  return {word(rational), word(rational + 4)};
}

TEST_F(DisplayRenders, print_is_a_tiff_with_resolution) {
  render(teapot_on("sheet.toml", {{"layout", "print"}}));
  const auto [dots, inches] = resolution_of(bytes("out/frame_0003.tif"));
  EXPECT_EQ(dots, 120u * inches);
  render(teapot_on("sheet.toml", {{"layout", "print"}, {"mirror", "true"}}, "mirror"));
  render(teapot_on("sheet.toml", {}, "plain"));
  EXPECT_FALSE(are_identical("plain/frame_0003.png", "mirror/frame_0003.tif"));
  EXPECT_TRUE(are_identical("plain/frame_0003.png", "out/frame_0003.tif"));
}

TEST_F(DisplayRenders, test_pattern_is_one_quilt_without_layers) {
  EXPECT_EQ(rendered(job("test-pattern", "out", {{"display", dir_ / "panel.toml"}})).size(), 1u);
  EXPECT_THAT(refusal(job("test-pattern", "none", {{"aov", "depth"}})), HasSubstr("no extra layers"));
}

TEST_F(DisplayRenders, pictures_that_cannot_be_played_give_warnings) {
  std::ofstream(dir_ / "panel.toml", std::ios::app) << "[video]\ncodec = \"h264\"\nlongest_side = 100\nquilts = false\n";
  render(teapot_on("panel.toml", {{"video", dir_ / "a.mkv"}}));
  EXPECT_THAT(warnings_, HasSubstr("pictures of quilts only"));
  EXPECT_THAT(warnings_, HasSubstr("up to 100 pixels a side"));
}

TEST_F(DisplayRenders, job_and_resume_know_the_display) {
  render(teapot_on("panel.toml", {}));
  EXPECT_EQ(kept(resume(job_of("out"))), 1u);
  std::ofstream(dir_ / "panel.toml", std::ios::app) << "[video]\ncodec = \"h264\"\nlongest_side = 4096\nquilts = true\n";
  RenderParams params = job_of("out");
  params.resume = true;
  EXPECT_THAT(refusal(params), HasSubstr("holds another render")) << "of a display that was changed";
}

TEST_F(DisplayRenders, unsupported_parameters_are_refused) {
  const auto refused = [&](const std::string& display, const Settings& settings, const std::string& message) {
    EXPECT_THAT(refusal(teapot_on(display, settings)), HasSubstr(message));
  };
  refused("portait", {}, "did you mean 'portrait'?");
  refused("panel.toml", {{"lenses", "20"}}, "lenses");
  refused("panel.toml", {{"layout", "native"}, {"size", "99x99"}}, "a native frame has the size of its panel");
  refused("sheet.toml", {{"optics", "multiview"}}, "has no quilt");
  refused("panel.toml", {{"optics", "microlens"}}, "is a slanted-panel");
  refused("sheet.toml", {{"mirror", "true"}}, "print");
  EXPECT_THAT(refusal(teapot("out", "0", {{"layout", "native"}})), HasSubstr("display"));
}

// With 9 pixels below each lens, the centre of a pixel is in the middle below the lens.
TEST_F(DisplayRenders, precompensated_picture_looks_plain_through_crosstalk) {
  const Settings sheet{{"lenses", "24"}, {"lens-pixels", "9"}, {"format", "exr"}};
  render(teapot("plain", "3", sheet));
  const Json report = report_of(teapot("shown", "3", sheet + Settings{{"precompensate", "true"}, {"crosstalk", "8%"}}));
  EXPECT_NEAR(report["precompensation"]["neighbour_share"].get<double>(), 0.08, 1e-6);
  EXPECT_EQ(report["frames"][0]["precompensation"]["clipped_share"], report["precompensation"]["clipped_share"]);
  const double sigma_px = report["precompensation"]["crosstalk_px"];
  const auto seen = [&](const std::string& folder, const std::string& name, double crosstalk_px) {
    ReplayParams params{.in = dir_ / folder, .folder = dir_ / name, .one_per_lens = true};
    params.view.crosstalk_px = crosstalk_px;
    return replay(params, context_).written.at(0);
  };
  const fs::path wanted = seen("plain", "a", 0.0), leaking = seen("plain", "b", sigma_px),
                 undone = seen("shown", "c", sigma_px);
  const auto rmse = [&](const fs::path& picture) { return compare(wanted, picture, context_).mean_rmse.mean; };
  EXPECT_GE(rmse(leaking), 0.5);
  EXPECT_LE(rmse(undone), 0.5 * rmse(leaking));  // clipped values cannot be corrected exactly
}

TEST_F(DisplayRenders, crosstalk_has_pixels_or_views_as_unit) {
  std::string leaky = bytes("panel.toml");
  leaky.replace(leaky.find("[calibration]"), 0, "crosstalk = 0.2\n");
  leaky.replace(leaky.find("129, 128"), 3, "128");
  std::ofstream(dir_ / "leaky.toml") << leaky;
  const Json quilt = report_of(teapot_on("leaky.toml", {{"precompensate", "true"}}));
  // Lenses are 324 dpi / 52 lpi = 6.23 pixels wide, or 6.29 along a row, for 8 views. A leak of 0.2 views is 0.2 / 8 of
  // 6.29 pixels.
  EXPECT_NEAR(quilt["precompensation"]["crosstalk_px"].get<double>(), 0.2 * 8 / (324 / 52.0 / std::cos(std::atan(1 / 7.0))),
              1e-6);
  const Json native = report_of(teapot_on("leaky.toml", {{"precompensate", "true"}, {"layout", "native"}}, "native"));
  EXPECT_EQ(native["precompensation"]["crosstalk_px"], 0.2);
}

TEST_F(DisplayRenders, finished_pictures_are_precompensated_equally) {
  const Settings sheet{{"lenses", "24"}, {"format", "png16"}};
  render(teapot("plain", "3", sheet));
  render(teapot("shown", "3", sheet + Settings{{"precompensate", "true"}, {"crosstalk", "0.35"}}));
  precompensate_frames({dir_ / "plain", dir_ / "made", 0.35}, context_);
  // The folder `shown` has a picture corrected from floats, and `made` has one corrected from 16-bit codes.
  EXPECT_LE(compare(dir_ / "shown/frame_0003.png", dir_ / "made/frame_0003.png", context_).mean_rmse.mean, 0.05);
  EXPECT_EQ(replay({.in = dir_ / "made"}, context_).written.size(), 1u);
}

TEST_F(DisplayRenders, unknown_or_strong_crosstalk_is_refused) {
  const auto refused = [&](const Settings& settings, const std::string& message) {
    EXPECT_THAT(refusal(teapot("out", "0", settings)), HasSubstr(message));
  };
  refused({{"precompensate", "true"}}, "crosstalk of the display is unknown");
  refused({{"precompensate", "true"}, {"crosstalk", "2"}}, "too strong to be compensated");
  EXPECT_THAT(refusal(job("teapot", "out", {{"precompensate", "true"}, {"crosstalk", "0.3"}, {"optics", "single"}})),
              HasSubstr("single view"));
}

}  // namespace
}  // namespace lippmann::test
