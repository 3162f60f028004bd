#include <gmock/gmock.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "cli/tool.hpp"
#include "core/platform.hpp"

namespace lippmann::test {
namespace {

using testing::HasSubstr;
using Json = nlohmann::json;

Words temporaries_in(const std::filesystem::path& folder) {
  Words names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (const std::string name = entry.path().filename().string(); name.find(".tmp-") != std::string::npos)
      names.push_back(name);
  return names;
}

TEST(Interruption, killed_render_resumes_to_the_same_files) {
  const TempDir dir;
  const Words whole = small_teapot("0-9", "whole") + Words{"--video", "whole.mkv"};
  ASSERT_EQ(run_tool(dir, whole).exit_code, 0);

  const Words parts = small_teapot("0-9", "parts") + Words{"--video", "parts.mkv"};
  Subprocess killed(tool_command(parts), {dir.path().string(), 0});
  ASSERT_TRUE(appears(dir / "parts/frame_0003.png"));
  killed.signal(SIGKILL);
  EXPECT_EQ(killed.wait().exit_code, 128 + SIGKILL);
  EXPECT_FALSE(std::filesystem::exists(dir / "parts.mkv"));
  EXPECT_EQ(json_of(bytes_of(dir / "parts/report.json"))["interrupted"], true);
  EXPECT_EQ(run_tool(dir, {"replay", "parts", "-o", "eye"}).exit_code, 0) << "the first report has the optics";

  const RunResult resumed = run_tool(dir, parts + Words{"--resume", "--json", "--verbose"});
  ASSERT_EQ(resumed.exit_code, 0) << resumed.err;
  EXPECT_LE(reported_frames(resumed.err), 7u) << "at least three of ten frames were kept";
  EXPECT_EQ(files_in(dir / "parts", ".png"), files_in(dir / "whole", ".png"));
  EXPECT_EQ(bytes_of(dir / "parts.mkv"), bytes_of(dir / "whole.mkv"));
  const nlohmann::json frames = json_of(resumed.out)["frames"];
  ASSERT_EQ(frames.size(), 10u);
  EXPECT_EQ(frames[0]["kept"], true);
  EXPECT_EQ(frames[9]["kept"], false);
}

TEST(Interruption, temporary_files_of_killed_renders_are_removed) {
  const TempDir dir;
  const int ended = 1 << 30;  // process ids on Linux are smaller
  std::filesystem::create_directory(dir / "a");
  for (const char* name : {"a/.frame_0001.tmp-", ".film.tmp-"})
    std::ofstream(dir / (name + std::to_string(ended) + "-" + platform::host_name() + "-0123abcd.mkv")) << "half";
  ASSERT_EQ(run_tool(dir, small_teapot("0", "a") + Words{"--video", "film.mkv"}).exit_code, 0);
  EXPECT_EQ(temporaries_in(dir / "a"), Words());
  EXPECT_EQ(temporaries_in(dir.path()), Words());
}

TEST(Interruption, resume_of_a_finished_render_traces_nothing) {
  const TempDir dir;
  ASSERT_EQ(run_tool(dir, small_teapot("0-2", "a")).exit_code, 0);
  const RunResult again = run_tool(dir, small_teapot("0-2", "a") + Words{"--resume"});
  EXPECT_EQ(again.exit_code, 0);
  EXPECT_EQ(again.err, "");
  EXPECT_THAT(again.out, HasSubstr("3 kept"));
}

TEST(Interruption, ctrl_c_keeps_finished_frames) {
  const TempDir dir;
  const Words arguments = small_teapot("0-479", "a") + Words{"--video", "a/a.mp4", "--json"};
  Subprocess running(tool_command(arguments), {dir.path().string(), 0});
  ASSERT_TRUE(appears(dir / "a/frame_0002.png"));
  running.signal(SIGINT);
  const RunResult result = running.wait();
  EXPECT_EQ(result.exit_code, 128 + SIGINT);
  const Json report = json_of(result.out);
  EXPECT_TRUE(report["interrupted"].get<bool>());
  const auto pictures = files_in(dir / "a", ".png");
  EXPECT_EQ(pictures.size(), report["frames"].size());
  EXPECT_GE(pictures.size(), 3u);
  EXPECT_LT(pictures.size(), 480u);
  EXPECT_FALSE(std::filesystem::exists(dir / "a/a.mp4")) << "a video of some of the frames is not the video";
  EXPECT_EQ(temporaries_in(dir / "a"), Words{});
}

TEST(Interruption, ctrl_c_ends_a_replay_quickly) {
  const TempDir dir;
  ASSERT_EQ(run_tool(dir, {"render", "room", "--frames", "0-1", "--optics", "multiview", "--views", "4x1", "--size", "128x32",
                           "-o", "room"})
                .exit_code,
            0);
  ASSERT_EQ(run_tool(dir, {"replay", "room", "-o", "eye", "--refocus", "3", "--size", "16x16"}).exit_code, 0);
  const auto before = files_in(dir / "eye", ".png");
  ASSERT_EQ(before.size(), 2u);
  for (const Words& what :
       {Words{"--pupil", "30"}, Words{"--ipd", "60", "--pupil", "30"}, Words{"--sweep", "3", "--pupil", "30"}}) {
    Subprocess running(tool_command(Words{"replay", "room", "-o", "eye", "--size", "4000x4000"} + what),
                       {dir.path().string(), 0});
    // The pause lets rendering begin, because nothing reports when it does. A picture takes a minute.
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    running.signal(SIGINT);
    EXPECT_EQ(running.wait().exit_code, 128 + SIGINT) << what.front();
    EXPECT_EQ(files_in(dir / "eye", ".png"), before) << what.front();
    EXPECT_EQ(temporaries_in(dir / "eye"), Words{});
  }
}

}  // namespace
}  // namespace lippmann::test
