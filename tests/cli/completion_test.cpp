#include <gmock/gmock.h>

#include <fstream>

#include "cli/tool.hpp"

namespace lippmann::test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> found;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) found.push_back(line);
  return found;
}

std::vector<std::string> completions(const Words& words) {
  const TempDir dir;
  const RunResult result = run_tool(dir, Words{"complete", "--"} + words);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  return lines(result.out);
}

TEST(Completion, commands_are_those_of_help) {
  EXPECT_THAT(completions({"ren"}), ElementsAre("render"));
  EXPECT_THAT(completions({""}), Contains("displays"));
  EXPECT_THAT(completions({""}), Not(Contains("complete")));
  EXPECT_THAT(completions({"help", "rep"}), ElementsAre("replay", "report"));
}

TEST(Completion, flags_and_values_come_from_declarations) {
  EXPECT_THAT(completions({"render", "--integ"}), ElementsAre("--integrator"));
  EXPECT_THAT(completions({"render", "room", "--integrator", ""}), ElementsAre("whitted", "path"));
  EXPECT_THAT(completions({"render", "--also", ""}), ElementsAre("single"));
  EXPECT_THAT(completions({"render", "--display", "looking-glass-por"}), Contains("looking-glass-portrait"));
  EXPECT_THAT(completions({"convert", "a", "b", "--to", "jp"}), ElementsAre("jpeg-pleno"));
  EXPECT_THAT(completions({"sheet", "p"}), ElementsAre("pitch", "phase", ":files"));
}

TEST(Completion, arguments_are_scenes_and_files) {
  EXPECT_THAT(completions({"render", "gea"}), ElementsAre("gears", ":files"));
  EXPECT_THAT(completions({"render", "room", "--output", ""}), ElementsAre(":files"));
  EXPECT_TRUE(completions({"rendre", "--"}).empty());
}

TEST(Completion, bash_keeps_file_names_with_spaces) {
  const TempDir dir;
  std::ofstream(dir / "my scene.glb") << "";
  const std::string script = "source '" LIPPMANN_COMPLETIONS "/lippmann.bash'; COMP_WORDS=('" LIPPMANN_TOOL
                             "' \"$@\"); COMP_CWORD=$#; _lippmann; printf '%s\\n' \"${COMPREPLY[@]}\"";
  const auto offered = [&](const Words& words) {
    return lines(run(Words{"bash", "-c", script, "bash"} + words, {.working_folder = dir.path().string()}).out);
  };
  EXPECT_THAT(offered({"render", "--integrator", "p"}), ElementsAre("path"));
  EXPECT_THAT(offered({"render", "my"}), ElementsAre("my scene.glb"));
}

TEST(Manual, manual_has_every_commands_flags) {
  const TempDir dir;
  const std::string page = run_tool(dir, {"manual"}).out;
  EXPECT_EQ(page.rfind(".TH LIPPMANN 1", 0), 0u);
  EXPECT_THAT(page, HasSubstr(".SS lippmann replay"));
  EXPECT_THAT(page, HasSubstr("\\-\\-min\\-psnr"));
  EXPECT_LT(page.find("\\-\\-version"), page.find(".SH COMMANDS"));
  EXPECT_THAT(page, Not(HasSubstr(".SS lippmann complete")));
  for (const std::string& line : lines(page)) EXPECT_FALSE(line.starts_with("'")) << line;
}

}  // namespace
}  // namespace lippmann::test
