// Kills renders with SIGKILL and resumes them, which must give the same files as an undisturbed render. LIPPMANN_KILLS
// sets the number of kills.
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <random>
#include <thread>

#include "cli/tool.hpp"

namespace lippmann::test {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

struct Mode {
  const char* name;
  Words flags;
  bool in_units = false;  ///< two processes render parts of the job, and one of them is killed
};

const std::vector<Mode>& modes() {
  static const std::vector<Mode> all{{"png and video", {"--video", "VIDEO"}},
                                     {"layers", {"--format", "png16", "--aov", "depth"}},
                                     {"exr", {"--format", "exr"}},
                                     {"views", {"--layout", "views"}},
                                     {"quilt", {"--optics", "multiview", "--views", "2x2", "--layout", "quilt"}},
                                     {"hci", {"--optics", "multiview", "--views", "2x2", "--camera-grid", "--to", "hci"}},
                                     {"paths", {"--integrator", "path", "--spp", "4"}},
                                     {"interpolated", {"--reuse", "interpolate", "--keyframes", "4"}},
                                     {"strips", {"--strips", "3", "--aov", "depth", "--spp", "4"}},
                                     {"units of strips", {"--strips", "4"}, true},
                                     {"units", {"--video", "VIDEO"}, true}};
  return all;
}

Words command(const Mode& mode, const std::string& folder) {
  Words words{"render", "primitives", "--size", "64x64", "--frames", "0-19", "-o", folder, "--quiet"};
  for (const std::string& word : mode.flags) words.push_back(word == "VIDEO" ? folder + "/video.mkv" : word);
  return words;
}

/// Returns the files whose bytes do not depend on how often the render was resumed.
Files lasting_files(const fs::path& folder) {
  Files files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = entry.path().lexically_relative(folder);
    const bool is_lasting = !name.starts_with(".") && name.find("/.") == std::string::npos && name != "report.json";
    if (entry.is_regular_file() && is_lasting && name != "job.toml") files[name] = bytes_of(entry.path());
  }
  return files;
}

void run_and_kill(const TempDir& dir, const Words& arguments, std::chrono::microseconds after) {
  Subprocess running(tool_command(arguments), {dir.path().string(), 0});
  std::this_thread::sleep_for(after);
  running.signal(SIGKILL);
  running.wait();
}

void expect_whole_after_a_kill(const Mode& mode, const Files& whole, std::chrono::microseconds after) {
  const TempDir dir;
  const Words first = command(mode, "a");
  if (mode.in_units) {
    std::thread other([&] { EXPECT_EQ(run_tool(dir, first + Words{"--unit", "2/2"}).exit_code, 0); });
    run_and_kill(dir, first + Words{"--unit", "1/2"}, after / 2);
    other.join();
    const RunResult resumed = run_tool(dir, first + Words{"--unit", "1/2", "--resume"});
    EXPECT_EQ(resumed.exit_code, 0) << resumed.err;
    EXPECT_EQ(run_tool(dir, {"finish", "a"}).exit_code, 0);
  } else {
    run_and_kill(dir, first, after);
    const RunResult resumed = run_tool(dir, first + Words{"--resume"});
    EXPECT_EQ(resumed.exit_code, 0) << resumed.err;
  }
  const RunResult check = run_tool(dir, {"check", "a"});
  EXPECT_EQ(check.exit_code, 0) << check.out << check.err;
  EXPECT_TRUE(lasting_files(dir / "a") == whole) << "files differ from those of an undisturbed render";
}

TEST(Kill, killed_render_resumes_to_the_same_files) {
  const char* kills_text = std::getenv("LIPPMANN_KILLS");
  const int kills = kills_text ? std::atoi(kills_text) : static_cast<int>(modes().size());
  std::mt19937 random(19);
  std::vector<Files> whole;
  std::vector<std::chrono::microseconds> lasts;
  for (const Mode& mode : modes()) {
    const TempDir dir;
    const auto begin = Clock::now();
    ASSERT_EQ(run_tool(dir, command(mode, "a")).exit_code, 0) << mode.name;
    lasts.push_back(std::chrono::duration_cast<std::chrono::microseconds>(Clock::now() - begin));
    whole.push_back(lasting_files(dir / "a"));
  }
  for (int i = 0; i < kills; ++i) {
    const std::size_t m = static_cast<std::size_t>(i) % modes().size();
    const auto after = std::chrono::microseconds(random() % static_cast<std::uint64_t>(lasts[m].count()));
    SCOPED_TRACE(std::string(modes()[m].name) + ", killed after " + std::to_string(after.count()) + " us");
    expect_whole_after_a_kill(modes()[m], whole[m], after);
  }
}

}  // namespace
}  // namespace lippmann::test
