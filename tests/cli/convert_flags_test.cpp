#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "cli/tool.hpp"
#include "core/text_pattern.hpp"
#include "lippmann/image/picture_file.hpp"
#include "support/icc_profile.hpp"

namespace lippmann::test {
namespace {

namespace fs = std::filesystem;
using testing::AnyOf;
using testing::HasSubstr;

/// Returns a value other than the default for each flag.
const std::map<std::string, std::string>& values() {
  static const std::map<std::string, std::string> all{{"--views", "2x4"},
                                                      {"--quilt", "2x4"},
                                                      {"--aspect", "3.5"},
                                                      {"--keep", "0"},
                                                      {"--crop", "5x5+1+1"},
                                                      {"--bits", "12"},
                                                      {"--display", "d.toml"},
                                                      {"--filter", "linear"},
                                                      {"--sigma", "0.7"},
                                                      {"--rotate-elemental", ""},
                                                      {"--spoc", "3"},
                                                      {"--gap", "2"},
                                                      {"--reference-plane", "1"},
                                                      {"--lens-pitch", "2"},
                                                      {"--lens-pixels", "4"},
                                                      {"--precompensate", ""},
                                                      {"--crosstalk", "0.3"},
                                                      {"--stereo", "over-under"},
                                                      {"--right-first", ""},
                                                      {"--ipd", "20"},
                                                      {"--viewing-distance", "900"},
                                                      {"--screen-width", "300"},
                                                      {"--view-angle", "9"},
                                                      {"--depth", "d/depth.png"},
                                                      {"--depth-range", "7:-9"},
                                                      {"--depth-coding", "depth"},
                                                      {"--near-black", ""},
                                                      {"--depth-scale", "0.5"},
                                                      {"--fit", "pad"},
                                                      {"--view-shift", "0.5"},
                                                      {"--flip", ""},
                                                      {"--shares", "1,2"},
                                                      {"--blend", "0.5"},
                                                      {"--mirror", ""},
                                                      {"--rotate", "90"},
                                                      {"--icc", "printer.icc"},
                                                      {"--bleed-mm", "2"},
                                                      {"--marks", ""},
                                                      {"--proof", ""},
                                                      {"--lpi", "21"},
                                                      {"--lenses-per-mm", "1"},
                                                      {"--pitch-mm", "1"},
                                                      {"--visual-lpi", "21"},
                                                      {"--dpi", "90"},
                                                      {"--paper", "A6"},
                                                      {"--landscape", ""},
                                                      {"--phase", "3"},
                                                      {"--baseline", "7"},
                                                      {"--focal-length", "30"},
                                                      {"--sensor-width", "20"},
                                                      {"--focus-distance", "900"},
                                                      {"--png", ""},
                                                      {"--binary", ""},
                                                      {"--white", "d/colours.png"},
                                                      {"--lens-pitch-px", "7.5"},
                                                      {"--lens-row-pitch-px", "7"},
                                                      {"--lens-rotation", "1"},
                                                      {"--lens-offset", "1,1"},
                                                      {"--lens-arrangement", "hexagonal"},
                                                      {"--sampling", "lanczos"},
                                                      {"--inverted", ""}};
  return all;
}

std::map<std::string, std::string> files_below(const fs::path& folder) {
  std::map<std::string, std::string> files;
  if (fs::exists(folder))
    for (const auto& entry : fs::recursive_directory_iterator(folder))
      if (entry.is_regular_file()) files[fs::relative(entry.path(), folder).string()] = bytes_of(entry.path());
  return files;
}

std::set<std::string> flags_of_help(const TempDir& dir) {
  const std::string help = run_tool(dir, {"convert", "--help"}).out;
  static const TextPattern flag("--[a-z][a-z-]*");
  std::set<std::string> flags;
  // CLI11 indents flags by 2 to 10 columns, and descriptions by 28.
  std::istringstream lines(help);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t begin = line.find_first_not_of(' ');
    if (begin == std::string::npos || begin > 10 || line[begin] != '-') continue;
    if (const auto found = flag.search(line)) flags.insert(found->groups[0]);
  }
  for (const char* other : {"--from", "--to", "--help", "--help-all", "--json", "--quiet"}) flags.erase(other);
  return flags;
}

class ConvertFlags : public testing::Test {
 protected:
  void SetUp() override {
    std::ofstream(dir_ / "d.toml") << "kind = \"slanted-panel\"\npixels = [40, 30]\ndpi = 60\nview_cone_deg = 40\n"
                                      "crosstalk = 0.3\n[calibration]\npitch = 8.1\nslope = -5\ncenter = 0.3\n"
                                      "[quilt]\ntiles = [4, 2]\nsize = [64, 24]\n";
    std::ofstream(dir_ / "sheet.toml") << "kind = \"lenticular-sheet\"\npixels = [90, 40]\ndpi = 90\nview_cone_deg = 40\n"
                                          "[lenses]\nlenses_per_inch = 9.3\n";
    std::ofstream(dir_ / "printer.icc", std::ios::binary) << profile_with(kP3Primaries, 2.2);
    expect_done(dir_, {"render", "room", "--optics", "multiview", "--views", "8x1", "--size", "96x12", "--frames", "0",
                       "--layout", "views", "-o", "r"});
    fs::create_directories(dir_ / "in");
    fs::copy(dir_ / "r/frame_0000", dir_ / "in/views", fs::copy_options::recursive);
    expect_done(dir_, {"convert", "in/views", "in/q.png", "--from", "views", "--to", "quilt", "--quilt", "8x1"});
    expect_done(dir_, {"convert", "in/views", "in/pair.png", "--from", "views", "--to", "stereo", "--keep", "2-3"});
    expect_done(dir_, {"convert", "in/pair_2x1.png", "in/two", "--to", "views"});
    expect_done(dir_, {"render", "room", "--size", "30x20", "--frames", "0", "--layout", "rgbd", "-o", "d"});
    Image8 colours{30, 20, {}}, depth{15, 10, {}};
    for (int i = 0; i < 3 * 30 * 20; ++i) colours.rgb.push_back(static_cast<unsigned char>(i * 37 % 251));
    for (int i = 0; i < 3 * 15 * 10; ++i) depth.rgb.push_back(static_cast<unsigned char>(i / 3 % 15 * 17));
    write_picture(dir_ / "d/colours.png", colours);
    write_picture(dir_ / "d/depth.png", depth);
  }

  void walk(const std::string& in, const std::string& to, const Words& needed) {
    const Words base = Words{"convert", in, "o/x"} + needed + Words{"--to", to};
    const RunResult plain = run_tool(dir_, base);
    ASSERT_EQ(plain.exit_code, 0) << plain.err;
    const auto without = files_below(dir_ / "o");
    fs::remove_all(dir_ / "o");
    for (const auto& [flag, value] : values()) {
      if (std::find(base.begin(), base.end(), flag) != base.end()) continue;
      const RunResult run = run_tool(dir_, base + (value.empty() ? Words{flag} : Words{flag, value}));
      if (run.exit_code == 0)
        EXPECT_NE(files_below(dir_ / "o"), without) << in << " to " << to << ": " << flag << " changes nothing";
      else
        EXPECT_THAT(run.err, AnyOf(HasSubstr(flag), HasSubstr("--to: a stereo picture has"), HasSubstr("Little CMS"),
                                   HasSubstr("too few to find their depth"), HasSubstr("liblippmann_align.so")))
            << in << " to " << to;
      fs::remove_all(dir_ / "o");
    }
  }

  TempDir dir_;
};

TEST_F(ConvertFlags, each_changes_the_result_or_is_refused) {
  std::set<std::string> known;
  for (const auto& [flag, value] : values()) known.insert(flag);
  EXPECT_EQ(known, flags_of_help(dir_)) << "a flag that this test does not try";
  const std::string quilt = "in/q_qs8x1a1.png";
  walk("in/views", "integral", {"--from", "views"});
  walk("in/views", "native", {"--display", "d.toml"});
  walk("in/views", "integral", {"--display", "sheet.toml"});
  walk("in/views", "integral", {"--lpi", "20", "--dpi", "100", "--paper", "4x5in"});
  walk("in/views", "jpeg-pleno", {});
  walk("in/pair_2x1.png", "views", {});
  walk("d/frame_0000_rgbd.png", "quilt", {});
  walk("d/frame_0000_rgbd.png", "stereo", {});
  walk("d/colours.png", "quilt", {"--depth", "d/depth.png"});
  walk("in/views", "stereo", {});
  walk("in/two", "stereo", {});
  walk(quilt, "quilt", {});
}

TEST_F(ConvertFlags, refusals_name_the_accepted_formats) {
  expect_refusal(run_tool(dir_, {"convert", "in/views", "s", "--to", "hci", "--display", "d.toml"}), 2,
                 "--display: has no effect on a conversion from views to hci; accepted: --from native, --to native");
  expect_refusal(run_tool(dir_, {"convert", "in/views", "s", "--to", "hci", "--dpi", "300"}), 2,
                 "--dpi: has no effect on a conversion from views to hci; accepted: --to integral");
  expect_refusal(run_tool(dir_, {"convert", "r", "o", "--rotate-elemental", "--gap", "2"}), 2,
                 "--gap: has no effect with --rotate-elemental; accepted: --spoc");
  expect_refusal(run_tool(dir_, {"convert", "in/views", "n.png", "--to", "native", "--display", "d.toml", "--sigma", "1"}), 2,
                 "--sigma");
  std::ofstream(dir_ / "clip.mp4") << "no video";
  expect_refusal(run_tool(dir_, {"convert", "clip.mp4", "o", "--to", "views"}), 1, "clip.mp4");
  expect_refusal(run_tool(dir_, {"convert", "clip_qs8x6a0.75.mp4", "o", "--to", "views"}), 1,
                 "each frame of this video holds several views");
  EXPECT_FALSE(fs::exists(dir_ / "o"));
}

}  // namespace
}  // namespace lippmann::test
