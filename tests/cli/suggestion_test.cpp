#include <gmock/gmock.h>

#include <sstream>

#include "cli/tool.hpp"

namespace lippmann::test {
namespace {

using testing::SizeIs;

/// Returns the suggested commands by the labels printed before them.
std::map<std::string, std::string> commands_in(const std::string& summary) {
  std::map<std::string, std::string> commands;
  std::istringstream lines(summary);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t at = line.find(" " LIPPMANN_TOOL " ");
    if (at == std::string::npos) continue;
    const std::size_t first = line.find_first_not_of(' ');
    commands[line.substr(first, line.find("  ", first) - first)] = line.substr(at + 1);
  }
  return commands;
}

void expect_suggestions_run(const Words& flags, std::size_t count) {
  const TempDir dir;
  const Words render{"render", "teapot", "--frames", "3", "-o", "my pictures/it's"};
  const RunResult result = run_tool(dir, render + flags);
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const auto commands = commands_in(result.out);
  EXPECT_THAT(commands, SizeIs(count)) << result.out;
  for (const auto& [label, command] : commands) {
    // The command labelled "in 3D" serves a page until it is stopped. With --save, the command saves the page and ends.
    const bool serves = label == "in 3D";
    const RunResult suggested = run({"sh", "-c", command + (serves ? " --save page" : "")}, {dir.path().string(), 0});
    EXPECT_EQ(suggested.exit_code, 0) << label << ": " << command << "\n" << suggested.err;
  }
}

TEST(Suggestion, commands_run_for_optics_and_layouts) {
  const std::vector<Words> optics{{"--optics", "lenticular", "--size", "64x48", "--lenses", "8"},
                                  {"--optics", "microlens", "--size", "64x48", "--lenses", "16x12"},
                                  {"--optics", "multiview", "--size", "64x48", "--views", "4x2"},
                                  {"--optics", "multiview", "--size", "64x48", "--views", "4x2", "--camera-grid"}};
  for (const Words& kind : optics)
    for (const char* layout : {"integral", "views", "quilt"}) {
      SCOPED_TRACE(testing::Message() << kind[1] << " " << layout);
      expect_suggestions_run(kind + Words{"--layout", layout}, 3);
    }
}

TEST(Suggestion, commands_run_for_fractional_lenses) {
  expect_suggestions_run({"--size", "64x48", "--lens-pixels", "7.3", "--slant", "10"}, 3);
  expect_suggestions_run({"--optics", "microlens", "--packing", "hexagonal", "--size", "64x48", "--lens-pixels", "8"}, 3);
}

TEST(Suggestion, commands_run_for_displays) {
  expect_suggestions_run({"--display", "portrait", "--layout", "quilt", "--quilt", "6x8", "--size", "480x480"}, 3);
  expect_suggestions_run({"--display", "portrait", "--size", "480x480"}, 3);
  expect_suggestions_run({"--size", "64x48", "--lenses", "8", "--layout", "quilt", "--quilt", "2x4"}, 3);
}

TEST(Suggestion, eye_view_is_not_always_suggested) {
  expect_suggestions_run({"--optics", "single", "--size", "64x48"}, 1);
  const Words print{"--display", "lenticular-60lpi-720dpi", "--layout", "print", "--size", "480x480"};
  expect_suggestions_run(print, 3);
  expect_suggestions_run(print + Words{"--mirror"}, 1);
}

}  // namespace
}  // namespace lippmann::test
