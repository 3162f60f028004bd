#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <sstream>

#include "cli/tool.hpp"
#include "core/text_pattern.hpp"
#include "lippmann/image/picture_file.hpp"

namespace lippmann::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

const Words kSmall{"--lpi", "62.5", "--dpi", "600", "--paper", "A7"};

Words sheet(const std::string& kind, const Words& flags) { return Words{"sheet", kind, "-o", "o/out.png"} + flags; }

TEST(Sheet, pitch_test_of_21_blocks) {
  const TempDir dir;
  const RunResult run = run_tool(dir, sheet("pitch", kSmall));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("9.600 pixels below each lens, a print pitch of 62.500 lpi"));
  EXPECT_THAT(run.out, HasSubstr("21 blocks: 8.6 to 10.6 pixels below a lens, 69.767 to 56.604 lpi: o/out.png"));
  EXPECT_EQ(std::get<Image8>(read_picture(dir / "o/out.png")).width, 1748);
  EXPECT_THAT(bytes_of(dir / "o/out.png"), HasSubstr(std::string("pHYs\0\0\x5c\x46\0\0\x5c\x46\x01", 13))) << "23622 per metre";
  const nlohmann::json report = report_of(dir, sheet("pitch", kSmall));
  ASSERT_EQ(report["blocks"].size(), 21u);
  EXPECT_NEAR(report["blocks"][20]["pitch_px"].get<double>(), 10.6, 1e-9);
  expect_done(dir, Words{"sheet", "pitch", "-o", "o/out.tiff"} + kSmall);
  EXPECT_EQ(std::get<Image8>(read_picture(dir / "o/out.tiff")).rgb, std::get<Image8>(read_picture(dir / "o/out.png")).rgb);
}

TEST(Sheet, lens_heights_are_16_bit_png) {
  const TempDir dir;
  const Words flags{"--lpi", "60", "--dpi", "1440", "--paper", "2x1mm", "--thickness-mm", "0.9"};
  const RunResult run = run_tool(dir, sheet("lens", flags));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("radius 0.3000 mm"));
  const Image16 heights = std::get<Image16>(read_picture(dir / "o/out.png"));
  EXPECT_EQ(heights.width, 113);
  EXPECT_GT(*std::max_element(heights.rgb.begin(), heights.rgb.end()), 65000);
  EXPECT_LT(*std::min_element(heights.rgb.begin(), heights.rgb.end()), 6000);
  expect_done(dir, Words{"sheet", "lens", "-o", "o/again.png", "--to", "height"} + flags);
  EXPECT_EQ(bytes_of(dir / "o/again.png"), bytes_of(dir / "o/out.png"));
}

TEST(Sheet, test_prints_are_a4_by_default) {
  const TempDir dir;
  const nlohmann::json report = report_of(dir, sheet("viewing-zone", {"--lpi", "20", "--dpi", "100"}));
  EXPECT_EQ(report["size"], json_of("[827, 1169]"));
  EXPECT_EQ(report["angles_deg"].size(), 3u);
}

TEST(Sheet, left_eye_sees_a_red_zone) {
  const TempDir dir;
  const std::string line = "lpi=40 dpi=400 paper=60x40mm viewing-distance=400";
  expect_done(dir, {"sheet", "viewing-zone", "-o", "o/out.png", "--display", line});
  const auto colours_from = [&](const std::string& eye) {
    expect_done(dir, {"replay", "o/out.png", "--display", line, "--eye", eye, "-o", "eye"});
    const Image8 seen = std::get<Image8>(read_picture(dir / "eye/eye_out.png"));
    const std::size_t corner = 3 * (4 * static_cast<std::size_t>(seen.width) + static_cast<std::size_t>(seen.width) / 2);
    return std::array<int, 3>{seen.rgb[corner], seen.rgb[corner + 1], seen.rgb[corner + 2]};
  };
  // The five views divide the slopes from -tan(25 degrees) to tan(25 degrees) into equal parts. The centres of the
  // outer views are at -+4/5 of the largest slope, at 400 mm thus at x = -+4/5 * 400 mm * tan(25 degrees) = -+149 mm.
  const auto left = colours_from("-149,0,400"), right = colours_from("149,0,400"), middle = colours_from("0,0,400");
  EXPECT_GT(left[0], left[2] + 100);
  EXPECT_GT(right[2], right[0] + 100);
  EXPECT_EQ(middle[0], middle[2]);
}

TEST(Sheet, mistakes_leave_nothing_behind) {
  const TempDir dir;
  const auto refuse = [&](const std::string& kind, const Words& flags, const std::string& message) {
    expect_refusal(run_tool(dir, sheet(kind, flags)), 2, message);
    EXPECT_FALSE(fs::exists(dir / "o")) << message;
  };
  refuse("pitch", {"--lpi", "0", "--dpi", "600"}, "--lpi");
  refuse("pitch", {"--lpi", "60"}, "without --dpi");
  refuse("pitch", {"--dpi", "600"}, "without --lpi");
  refuse("pitch", {}, "--lpi: is missing");
  refuse("pitch", {"--lpi", "400", "--dpi", "600"}, "lenses 1.500 pixels wide");
  refuse("pitch", {"--lpi", "1", "--dpi", "600", "--paper", "10x10mm"}, "lenses 600.000 pixels wide");
  refuse("pitch", Words{"--step", "0.1"} + kSmall, "--step");
  refuse("pitch", Words{"--step", "1px"} + kSmall, "--step: gives block 1 of 21 a pitch of -0.4 pixels");
  refuse("phase", Words{"--blocks", "180"} + kSmall, "--blocks: 180 labelled blocks do not fit");
  refuse("viewing-zone", Words{"--views", "10"} + kSmall, "--views: 10 views do not fit in 9 pixels");
  refuse("lens", kSmall, "--thickness-mm, --radius-mm and --height-mm");
  refuse("lens", {"--lpi", "60", "--dpi", "1440", "--radius-mm", "1"}, "without --paper");
  refuse("lens", Words{"--radius-mm", "0.1"} + kSmall, "--radius-mm: with 0.1 mm, lenses");
  refuse("pitch", {"--display", "portrait"}, "portrait is not a lenticular sheet");
  expect_refusal(run_tool(dir, Words{"sheet", "lens", "-o", "o/out.tiff", "--radius-mm", "1"} + kSmall), 2, "ends in .png");
  EXPECT_FALSE(fs::exists(dir / "o"));
}

TEST(Sheet, full_disk_leaves_nothing_behind) {
  const TempDir dir;
  expect_refusal(run_tool(dir, sheet("phase", kSmall), 4096), 1, "o/out.png");
  EXPECT_FALSE(fs::exists(dir / "o"));
}

/// Returns a value other than the default for each flag.
const std::map<std::string, std::string>& flag_values() {
  static const std::map<std::string, std::string> all{
      {"--lenses-per-mm", "2"},  {"--pitch-mm", "0.5"},   {"--visual-lpi", "40"},        {"--landscape", ""},
      {"--phase", "3"},          {"--display", "s.toml"}, {"--viewing-distance", "150"}, {"--view-angle", "20"},
      {"--blocks", "5"},         {"--step", "0.2lpi"},    {"--bars", "horizontal"},      {"--views", "4"},
      {"--thickness-mm", "1.7"}, {"--radius-mm", "0.7"},  {"--height-mm", "0.08"},       {"--refractive-index", "1.6"}};
  return all;
}

std::set<std::string> flags_of_sheet_help(const TempDir& dir) {
  static const TextPattern flag("--[a-z][a-z-]*");
  std::set<std::string> flags;
  std::istringstream lines(run_tool(dir, {"sheet", "--help"}).out);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t begin = line.find_first_not_of(' ');
    if (begin == std::string::npos || begin > 10 || line[begin] != '-') continue;
    if (const auto found = flag.search(line)) flags.insert(found->groups[0]);
  }
  for (const char* other : {"--lpi", "--dpi", "--paper", "--to", "--output", "--help", "--json", "--quiet"}) flags.erase(other);
  return flags;
}

TEST(Sheet, flags_change_the_result_or_fail) {
  const TempDir dir;
  std::set<std::string> known;
  for (const auto& [flag, value] : flag_values()) known.insert(flag);
  EXPECT_EQ(known, flags_of_sheet_help(dir)) << "a flag that this test does not try";
  const auto result_of = [&](const Words& words) {
    fs::remove_all(dir / "o");
    const RunResult run = run_tool(dir, words);
    return run.exit_code == 0 ? run.out + bytes_of(dir / "o/out.png") : std::string();
  };
  for (const std::string kind : {"pitch", "phase", "viewing-zone", "lens"}) {
    Words base = sheet(kind, {"--lpi", "50", "--dpi", "500", "--paper", "90x170mm"});
    if (kind == "lens") base = base + Words{"--thickness-mm", "0.9"};
    const std::string without = result_of(base);
    ASSERT_NE(without, "") << kind;
    for (const auto& [flag, value] : flag_values()) {
      if (std::find(base.begin(), base.end(), flag) != base.end()) continue;
      const Words words = base + (value.empty() ? Words{flag} : Words{flag, value});
      const std::string with = result_of(words);
      if (with.empty())
        EXPECT_THAT(run_tool(dir, words).err, HasSubstr(flag)) << kind;
      else
        EXPECT_NE(with, without) << kind << ": " << flag << " changes nothing";
    }
  }
}

}  // namespace
}  // namespace lippmann::test
