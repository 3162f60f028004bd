#include <gmock/gmock.h>

#include <csignal>
#include <filesystem>

#include "cli/tool.hpp"

namespace lippmann::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

TEST(View, prints_only_the_address_until_interrupted) {
  const TempDir dir;
  ASSERT_EQ(run_tool(dir, small_teapot("0", "r")).exit_code, 0);
  Subprocess server(tool_command({"view", "r", "--port", "0"}), {.working_folder = dir.path().string()});
  server.wait_for_line();
  server.signal(SIGINT);
  const RunResult result = server.wait();
  EXPECT_EQ(result.exit_code, 128 + SIGINT);
  EXPECT_THAT(result.out, testing::MatchesRegex("http://127\\.0\\.0\\.1:[0-9]+/\n"));
  EXPECT_THAT(result.err, HasSubstr("Ctrl-C ends it"));
}

TEST(View, impossible_inputs_are_refused_first) {
  const TempDir dir;
  fs::create_directory(dir / "empty");
  expect_refusal(run_tool(dir, {"view", "missing"}), 1, "there is no such file or folder");
  expect_refusal(run_tool(dir, {"view", "empty"}), 1, "is an empty folder");
  expect_refusal(run_tool(dir, {"view", "empty", "--port", "70000"}), 2, "--port");
}

TEST(View, scene_has_an_address_with_token) {
  const TempDir dir;
  Subprocess server(tool_command({"view", "room", "--size", "64x64", "--lenses", "8", "--port", "0"}),
                    {.working_folder = dir.path().string()});
  server.wait_for_line();
  server.signal(SIGINT);
  const RunResult result = server.wait();
  EXPECT_EQ(result.exit_code, 128 + SIGINT);
  EXPECT_THAT(result.out, testing::MatchesRegex("http://127\\.0\\.0\\.1:[0-9]+/[0-9a-f]+/\n"));
  EXPECT_TRUE(fs::is_empty(dir.path()));
}

TEST(View, empty_page_has_a_token) {
  const TempDir dir;
  Subprocess server(tool_command({"view", "--port", "0"}), {.working_folder = dir.path().string()});
  server.wait_for_line();
  server.signal(SIGINT);
  const RunResult result = server.wait();
  EXPECT_EQ(result.exit_code, 128 + SIGINT);
  EXPECT_THAT(result.out, testing::MatchesRegex("http://127\\.0\\.0\\.1:[0-9]+/[0-9a-f]+/\n"));
  for (const Words& flag :
       {Words{"--save", "page"}, Words{"--from", "hci"}, Words{"--view-angle", "9"}, Words{"--zoom", "2"},
        Words{"--save-job", "x.toml"}, Words{"--display", "go"}, Words{"--cone-ends"}, Words{"--lpi", "60"}})
    expect_refusal(run_tool(dir, Words{"view"} + flag), 2, flag[0] + ": has no effect without IN");
}

// Only pages that can resume a render have a token in their address.
TEST(View, unfinished_render_has_a_token) {
  const TempDir dir;
  Subprocess render(tool_command(small_teapot("0-99", "r")), {dir.path().string(), 0});
  ASSERT_TRUE(appears(dir / "r/frame_0001.png"));
  render.signal(SIGKILL);
  render.wait();
  Subprocess server(tool_command({"view", "r", "--port", "0"}), {.working_folder = dir.path().string()});
  server.wait_for_line();
  server.signal(SIGINT);
  EXPECT_THAT(server.wait().out, testing::MatchesRegex("http://127\\.0\\.0\\.1:[0-9]+/[0-9a-f]+/\n"));
}

TEST(View, scene_and_light_field_flags_differ) {
  const TempDir dir;
  fs::create_directory(dir / "room");  // a folder is shown even if a built-in scene has the same name
  expect_refusal(run_tool(dir, {"view", "room"}), 1, "is an empty folder");
  expect_refusal(run_tool(dir, {"view", "room", "--zoom", "2"}), 2, "--zoom");
  expect_refusal(run_tool(dir, {"view", "room", "--save-job", "x.toml"}), 2, "--save-job");
  expect_refusal(run_tool(dir, {"view", "teapot", "--from", "hci"}), 2, "--from");
  expect_refusal(run_tool(dir, {"view", "teapot", "room"}), 2, "OTHER");
  expect_refusal(run_tool(dir, {"view", "teapot", "--save", "page"}), 2, "--save");
  expect_refusal(run_tool(dir, {"view", "missing.glb"}), 1, "there is no such file");
}

TEST(View, flags_describe_the_sheet_of_a_print) {
  const TempDir dir;
  const Words sheet{"--lpi", "20", "--dpi", "120", "--paper", "80x60px"};
  expect_done(dir, {"render", "teapot", "--optics", "multiview", "--views", "6x1", "--size", "96x12", "--frames", "0",
                    "--layout", "views", "-q", "-o", "made"});
  expect_done(dir, Words{"convert", "made", "print.png", "-q"} + sheet);
  fs::remove(dir / "print.report.json");
  expect_done(dir, Words{"view", "print.png", "--save", "page"} + sheet);
  const std::string fields = bytes_of(dir / "page/fields.js");
  EXPECT_THAT(fields, HasSubstr("\"across\":{\"views\":6"));
  expect_done(dir, Words{"replay", "print.png", "-o", "seen"} + sheet);
  expect_refusal(run_tool(dir, Words{"view", "print.png", "--display", "go"} + sheet), 2, "--lpi: cannot be combined");
  expect_refusal(run_tool(dir, {"view", "print.png", "--lpi", "20"}), 2, "without --dpi");
}

TEST(View, saving_shows_progress_and_the_file) {
  const TempDir dir;
  expect_done(dir, small_teapot("0-2", "r"));
  const RunResult folder = run_tool(dir, {"view", "r", "--save", "page"});
  EXPECT_EQ(folder.exit_code, 0);
  EXPECT_THAT(folder.err, testing::StartsWith("[1/3] frame 0000; "));
  EXPECT_THAT(folder.err, HasSubstr("[3/3] frame 0002; done\n"));
  EXPECT_THAT(folder.err, testing::EndsWith("\nOpen page/index.html in a browser.\n"));
  EXPECT_THAT(folder.out, testing::StartsWith("page/index.html: "));
  EXPECT_THAT(run_tool(dir, {"view", "r", "--save", "r.html"}).err, testing::EndsWith("\nOpen r.html in a browser.\n"));
}

TEST(View, render_writes_a_page_on_request) {
  const TempDir dir;
  ASSERT_EQ(run_tool(dir, small_teapot("0-1", "r") + Words{"--page"}).exit_code, 0);
  for (const char* file : {"index.html", "app.js", "app.css", "fields.js", "0/views/0.js", "0/views/1.js"})
    EXPECT_TRUE(fs::exists(dir / "r/page" / file)) << file;
  EXPECT_EQ(run_tool(dir, {"check", "r"}).exit_code, 0);
  expect_refusal(run_tool(dir, small_teapot("0", "m") + Words{"--page", "--mirror"}), 2, "--page");
  EXPECT_FALSE(fs::exists(dir / "m"));
}

}  // namespace
}  // namespace lippmann::test
