#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "cli/tool.hpp"
#include "core/text_pattern.hpp"

namespace lippmann::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// Returns a value other than the default for each flag.
const std::map<std::string, std::string>& values() {
  static const std::map<std::string, std::string> all{{"--animation", "0"},
                                                      {"--aperture", "4"},
                                                      {"--asset-root", "."},
                                                      {"--binary", ""},
                                                      {"--camera", "0"},
                                                      {"--camera-grid", ""},
                                                      {"--camera-path", "none.cam"},
                                                      {"--clamp-indirect", "0.1"},
                                                      {"--cone-ends", ""},
                                                      {"--crf", "40"},
                                                      {"--crosstalk", "0.4"},
                                                      {"--debug", "missed"},
                                                      {"--denoise", "auto"},
                                                      {"--depth-coding", "depth"},
                                                      {"--depth-range", "5:-5"},
                                                      {"--display", "portrait"},
                                                      {"--dpi", "90"},
                                                      {"--environment", "#ff8000"},
                                                      {"--environment-rotation", "90"},
                                                      {"--environment-strength", "2"},
                                                      {"--exposure", "1"},
                                                      {"--exr-pixels", "float"},
                                                      {"--eye-height", "30deg"},
                                                      {"--f-number", "2"},
                                                      {"--fill", "retrace"},
                                                      {"--fit-to", "nothing"},
                                                      {"--focal-length", "60"},
                                                      {"--focal-plane", "20"},
                                                      {"--focus", "900"},
                                                      {"--format", "png16"},
                                                      {"--gap", "30"},
                                                      {"--halving", ""},
                                                      {"--integrator", "path"},
                                                      {"--ipd", "20"},
                                                      {"--landscape", ""},
                                                      {"--layout", "views"},
                                                      {"--lens-focal-length", "20"},
                                                      {"--lens-pixels", "5"},
                                                      {"--lenses", "5"},
                                                      {"--lenses-per-mm", "1"},
                                                      {"--light-scale", "0.5"},
                                                      {"--lpi", "21"},
                                                      {"--max-depth", "1"},
                                                      {"--mirror", ""},
                                                      {"--near-black", ""},
                                                      {"--no-z-buffer", ""},
                                                      {"--optics", "single"},
                                                      {"--orbit", "20"},
                                                      {"--packing", "hexagonal"},
                                                      {"--paper", "A6"},
                                                      {"--phase", "3"},
                                                      {"--pitch-mm", "1"},
                                                      {"--points", "2"},
                                                      {"--precompensate", ""},
                                                      {"--pseudoscopic", ""},
                                                      {"--quilt", "2x3"},
                                                      {"--reuse", "interpolate"},
                                                      {"--right-first", ""},
                                                      {"--screen-width", "300"},
                                                      {"--seed", "7"},
                                                      {"--sensor-width", "24"},
                                                      {"--shutter", "0.7"},
                                                      {"--size", "23x17"},
                                                      {"--slant", "10"},
                                                      {"--splat", "lens"},
                                                      {"--spp", "3"},
                                                      {"--stereo", "over-under"},
                                                      {"--texture-memory", "10"},
                                                      {"--to", "miv"},
                                                      {"--points", "0.1"},
                                                      {"--tone", "agx"},
                                                      {"--transparent", ""},
                                                      {"--up", "z"},
                                                      {"--variant", "0"},
                                                      {"--video-codec", "ffv1"},
                                                      {"--view-angle", "50"},
                                                      {"--viewing-distance", "200"},
                                                      {"--views", "3x2"},
                                                      {"--visual-lpi", "21"},
                                                      {"--zoom", "2"}};
  return all;
}

/// Flags that may leave the pictures unchanged, each with the reason.
const std::map<std::string, std::string>& others() {
  static const std::map<std::string, std::string> all{
      {"--also", "more files"},
      {"--aov", "more files"},
      {"--angular-filter", "'none' and 'box' are compared where there are several samples: tests of frames"},
      {"--cameras", "chooses the optics: tests of data sets"},
      {"--dry-run", "makes nothing"},
      {"--dump-job", "another file"},
      {"--fit-depth", "the default for lens arrays"},
      {"--force", "of a folder that is there"},
      {"--fps", "frame 0 is that of any rate"},
      {"--frames", "given"},
      {"--full-depth", "the depth of the room fits"},
      {"--job", "a file of flags"},
      {"--keyframes", "speed, where pixels are copied"},
      {"--min-psnr", "Whitted frames that are traced keep to any floor"},
      {"--only-frames", "of a job in parts"},
      {"--order", "speed"},
      {"--output", "given"},
      {"--page", "more files"},
      {"--progress", "what is printed"},
      {"--resume", "of a folder that is there"},
      {"--strips", "how a picture is cut for machines"},
      {"--threads", "speed"},
      {"--unit", "of a job in parts"},
      {"--verbose", "what is printed"},
      {"--video", "another file"}};
  return all;
}

std::map<std::string, std::string> frames_in(const fs::path& folder) {
  std::map<std::string, std::string> files;
  if (fs::exists(folder))
    for (const auto& entry : fs::recursive_directory_iterator(folder))
      if (const std::string name = fs::relative(entry.path(), folder).string();
          entry.is_regular_file() && name.starts_with("frame_"))
        files[name] = bytes_of(entry.path());
  return files;
}

std::set<std::string> flags_of_help(const TempDir& dir) {
  static const TextPattern flag("--[a-z][a-z-]*");
  std::set<std::string> flags;
  std::istringstream lines(run_tool(dir, {"render", "--help-all"}).out);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t begin = line.find_first_not_of(' ');  // CLI11 indents flags by 2 to 10 columns, and descriptions by more
    if (begin == std::string::npos || begin > 10 || line[begin] != '-') continue;
    if (const auto found = flag.search(line)) flags.insert(found->groups[0]);
  }
  for (const char* other : {"--help", "--help-all", "--json", "--quiet"}) flags.erase(other);
  return flags;
}

class RenderFlags : public testing::Test {
 protected:
  /// Renders with the flags `render`, then again with each other flag. Flags in `may_stay` may leave the files
  /// unchanged.
  void walk(const Words& render, const std::set<std::string>& may_stay) {
    const Words base = Words{"render"} + render + Words{"--quiet", "--output", "o"};
    const RunResult plain = run_tool(dir_, base);
    ASSERT_EQ(plain.exit_code, 0) << plain.err;
    const auto without = frames_in(dir_ / "o");
    ASSERT_FALSE(without.empty());
    fs::remove_all(dir_ / "o");
    for (const auto& [flag, value] : values()) {
      if (std::find(base.begin(), base.end(), flag) != base.end()) continue;
      const RunResult run = run_tool(dir_, base + (value.empty() ? Words{flag} : Words{flag, value}));
      if (run.exit_code != 0) {
        EXPECT_THAT(run.err, testing::AnyOf(HasSubstr(flag), HasSubstr("is decided by the display"))) << render[0];
      } else {
        EXPECT_TRUE(may_stay.contains(flag) || frames_in(dir_ / "o") != without)
            << render[0] << ": " << flag << " changes nothing";
      }
      fs::remove_all(dir_ / "o");
    }
  }

  TempDir dir_;
};

TEST_F(RenderFlags, each_changes_the_pictures_or_is_refused) {
  std::set<std::string> known;
  for (const auto& [flag, value] : values()) known.insert(flag);
  for (const auto& [flag, why] : others()) known.insert(flag);
  EXPECT_EQ(known, flags_of_help(dir_)) << "a flag that this test does not try";
  // --camera has no effect because the scene has one camera, and --reuse because there is only one frame.
  walk({"primitives", "--frames", "0", "--lenses", "5x5", "--lens-pixels", "4"}, {"--camera", "--reuse"});
  walk({"primitives", "--frames", "0", "--optics", "multiview", "--views", "3x2", "--size", "24x16", "--integrator", "path",
        "--spp", "2", "--denoise", "none"},
       {"--camera"});
  walk({"primitives", "--frames", "0", "--optics", "plenoptic", "--lenses", "6x5", "--lens-pixels", "5", "--f-number", "4"},
       {"--camera", "--reuse"});
  walk({"primitives", "--frames", "0", "--layout", "stereo", "--viewing-distance", "600", "--size", "32x18"}, {"--reuse"});
}

}  // namespace
}  // namespace lippmann::test
