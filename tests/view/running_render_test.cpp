#include "view/running_render.hpp"

#include <gmock/gmock.h>

#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "core/file_checksum.hpp"
#include "folder/render_folder.hpp"
#include "lippmann/core/error.hpp"
#include "support/error_message.hpp"
#include "support/temp_dir.hpp"
#include "view/answers.hpp"
#include "view/light_fields.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr std::chrono::milliseconds kAlways{0};

/// A folder of three frames, two of which exist. According to its journal, this process is rendering them.
class RunningRenderTest : public testing::Test {
 protected:
  RunningRenderTest() : pictures_(test::write_sheet_frames(dir_.path(), 2)), folder_(std::in_place, dir_.path(), "job") {
    folder_->begin({0, 1, 2});
    folder_->write("job.toml", [](const FolderJournal&) { return std::string("scene = \"room\"\n"); });
    add(0);
  }

  void add(int frame) {
    FrameReport report;
    report.frame = frame, report.kind = "key";
    const std::string name = "frame_000" + std::to_string(frame) + ".png";
    folder_->add(report, {{name, file_checksum(dir_ / name).value_or(FileChecksum{1, "0123456789abcdef"})}});
  }
  /// Writes a shell script in place of the tool, which writes its arguments to the file `words` and then executes
  /// `does`.
  fs::path tool_running(const std::string& does) {
    const fs::path path = dir_ / "tool.sh";
    std::ofstream(path) << "#!/bin/sh\necho \"$@\" > '" << (dir_ / "words").string() << "'\n" << does << "\n";
    fs::permissions(path, fs::perms::owner_all);
    return path;
  }
  static nlohmann::ordered_json state_once(RunningRender& render, const std::string& word) {
    for (int i = 0; i < 500; ++i, std::this_thread::sleep_for(std::chrono::milliseconds(20)))
      if (auto state = render.state_after(0); state["state"] == word) return state;
    return {};
  }

  test::TempDir dir_;
  std::vector<Image8> pictures_;
  std::optional<RenderFolder> folder_;
};

TEST_F(RunningRenderTest, finished_frames_are_reported_once) {
  RunningRender render(dir_.path(), {"/bin/false", {}}, kAlways);
  nlohmann::ordered_json state = render.state_after(0);
  EXPECT_EQ(state["state"], "running");
  EXPECT_EQ(state["frames"], 3);
  ASSERT_EQ(state["finished"].size(), 1u);
  EXPECT_EQ(state["finished"][0]["kind"], "key");
  add(1);
  state = render.state_after(1);
  ASSERT_EQ(state["finished"].size(), 1u);
  EXPECT_EQ(state["finished"][0]["index"], 1);
  EXPECT_EQ(state["done"], 2);
}

TEST_F(RunningRenderTest, picture_exists_once_its_frame_is_finished) {
  auto render = std::make_shared<RunningRender>(dir_.path(), ToolCommand{"/bin/false", {}}, kAlways);
  const PageField field(dir_.path(), render, Context());
  ASSERT_EQ(field.facts().frames.size(), 3u);
  EXPECT_EQ(field.facts().frames[2].label, "0002");
  EXPECT_EQ(field.panel(0).rgb, pictures_[0].rgb);
  EXPECT_THAT(test::error_message([&] { field.panel(1); }), HasSubstr("Frame 0001: is not rendered yet"));
  add(1);
  render->state_after(0);
  EXPECT_EQ(field.panel(1).rgb, pictures_[1].rgb);
}

TEST_F(RunningRenderTest, stopped_render_is_resumed_by_the_command) {
  folder_.reset();
  RunningRender render(dir_.path(), {tool_running("echo 'no such scene' >&2; exit 1"), {"render", "a b/job.toml", "--resume"}},
                       kAlways);
  EXPECT_EQ(render.state_after(0)["state"], "stopped");
  EXPECT_THROW(render.stop(), Error);
  render.resume();
  EXPECT_EQ(state_once(render, "stopped")["error"], "no such scene");
  std::ifstream words(dir_ / "words");
  std::string line;
  std::getline(words, line);
  EXPECT_EQ(line, "render a b/job.toml --resume");
}

TEST_F(RunningRenderTest, resumed_render_can_be_stopped_early) {
  folder_.reset();
  RunningRender render(dir_.path(), {tool_running("exec sleep 60"), {}}, kAlways);
  render.resume();
  EXPECT_EQ(render.state_after(0)["state"], "starting");
  EXPECT_THROW(render.resume(), Error);
  render.stop();
  EXPECT_EQ(state_once(render, "stopped")["error"], "");
}

TEST_F(RunningRenderTest, running_render_or_changed_job_is_refused) {
  RunningRender render(dir_.path(), {"/bin/false", {}});
  EXPECT_THAT(test::error_message([&] { render.resume(); }), HasSubstr("a render is running"));
  folder_.reset();
  std::ofstream(dir_ / "job.toml") << "scene = \"teapot\"\n";
  EXPECT_THAT(test::error_message([&] { render.resume(); }), HasSubstr("job.toml: was changed after the render wrote it"));
}

TEST_F(RunningRenderTest, only_unfinished_renders_are_reported) {
  EXPECT_TRUE(is_unfinished_render(dir_.path()));
  for (const int frame : {1, 2}) add(frame);
  EXPECT_TRUE(is_unfinished_render(dir_.path()));  // the journal is still open, so its process counts as running
  folder_.reset();
  EXPECT_FALSE(is_unfinished_render(dir_.path()));
  EXPECT_FALSE(is_unfinished_render(dir_ / "missing"));
}

TEST_F(RunningRenderTest, orders_need_the_page_and_token) {
  auto render = std::make_shared<RunningRender>(dir_.path(), ToolCommand{"/bin/false", {}});
  folder_.reset();
  PageAnswers answers(std::make_unique<PageField>(dir_.path(), render, Context()), render, {{"127.0.0.1:1"}, "secret"});
  PageRequest request{.method = "POST", .path = "/secret/run/stop", .host = "127.0.0.1:1", .origin = "http://127.0.0.1:1"};
  EXPECT_EQ(answers.answer(request).status, 422);
  request.origin = "";
  EXPECT_EQ(answers.answer(request).status, 403);
  request.origin = "http://evil.example";
  EXPECT_EQ(answers.answer(request).status, 403);
  request.origin = "http://127.0.0.1:1", request.path = "/run/stop";
  EXPECT_EQ(answers.answer(request).status, 403);
  request.path = "/secret/run/remove";
  EXPECT_EQ(answers.answer(request).status, 404);
  request.method = "GET", request.path = "/secret/run/state/0";
  EXPECT_EQ(answers.answer(request).status, 200);
  request.path = "/secret/run/state/x";
  EXPECT_EQ(answers.answer(request).status, 404);
}

TEST_F(RunningRenderTest, finished_frames_can_be_saved_as_a_page) {
  auto render = std::make_shared<RunningRender>(dir_.path(), ToolCommand{"/bin/false", {}});
  PageAnswers answers(std::make_unique<PageField>(dir_.path(), render, Context()), render, {{"127.0.0.1:1"}, "secret"});
  const PageAnswer page = answers.answer({.path = "/secret/page.html", .host = "127.0.0.1:1"});
  EXPECT_EQ(page.status, 200);
  EXPECT_THAT(*page.body, HasSubstr("id=\"data:0/views/0\""));
  EXPECT_THAT(*page.body, testing::Not(HasSubstr("id=\"data:0/views/2\"")));
  EXPECT_EQ(answers.answer({.path = "/page.html", .host = "127.0.0.1:1"}).status, 403);
}

}  // namespace
}  // namespace lippmann
