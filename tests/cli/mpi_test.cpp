#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <thread>

#include "cli/tool.hpp"

namespace lippmann::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

bool is_mpi_there() {
  const fs::path module = fs::path(LIPPMANN_TOOL).parent_path() / "liblippmann_mpi.so";
  return fs::exists(module) && std::system("command -v mpirun > /dev/null") == 0;
}

#define SKIP_WITHOUT_MPI()                                          \
  if (!is_mpi_there() || std::string_view(LIPPMANN_SANITIZE) != "") \
  GTEST_SKIP() << "no Open MPI (packages libopenmpi-dev, openmpi-bin), or a sanitizer"

Words mpirun(int ranks) {
  return {"/usr/bin/env",
          "OMPI_ALLOW_RUN_AS_ROOT=1",
          "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1",
          "mpirun",
          "--oversubscribe",
          "--mca",
          "btl",
          "self,vader",
          "-n",
          std::to_string(ranks)};
}

RunResult run_ranks(const TempDir& dir, int ranks, const Words& arguments) {
  return run(mpirun(ranks) + tool_command(arguments), {dir.path().string(), 0});
}

const Words kPaths{"--integrator", "path", "--spp", "4"};

Words teapot(const std::string& folder, const Words& more = {}) {
  return Words{"render", "teapot", "--size", "64x16", "--lenses", "8x2", "--frames", "0-39", "-o", folder} + more;
}

TEST(Mpi, ranks_have_the_bytes_of_one_process) {
  SKIP_WITHOUT_MPI();
  for (const Words& how : {Words{}, kPaths}) {
    const TempDir dir;
    ASSERT_EQ(run_tool(dir, teapot("whole", how + Words{"--video", "whole.mp4"})).exit_code, 0);
    for (const int ranks : {1, 2, 5}) {
      const std::string folder = "ranks-" + std::to_string(ranks);
      const RunResult result = run_ranks(dir, ranks, teapot(folder, how + Words{"--video", folder + ".mp4"}));
      EXPECT_EQ(result.exit_code, 0) << result.err;
      EXPECT_THAT(result.out, HasSubstr("40 frames of 64x16 pixels"));
      EXPECT_EQ(files_in(dir / folder, ".png"), files_in(dir / "whole", ".png")) << ranks;
      EXPECT_EQ(bytes_of(dir / (folder + ".mp4")), bytes_of(dir / "whole.mp4")) << ranks;
      EXPECT_EQ(run_tool(dir, {"check", folder}).exit_code, 0);
      const nlohmann::json report = json_of(bytes_of(dir / folder / "report.json"));
      EXPECT_EQ(report["frames"].size(), 40u);
      EXPECT_EQ(report["runs"].size(), static_cast<std::size_t>(ranks));
      EXPECT_EQ(report["interrupted"], false);
    }
  }
}

TEST(Mpi, ranks_share_strips_of_a_still) {
  SKIP_WITHOUT_MPI();
  const TempDir dir;
  const Words still{"render", "teapot", "--size", "64x160", "--lenses", "8x20", "--frames", "3"};
  ASSERT_EQ(run_tool(dir, still + Words{"-o", "whole", "--video", "whole.mkv"}).exit_code, 0);
  const Words strips = still + Words{"--strips", "7", "-o", "a", "--video", "a.mkv", "--verbose"};
  const RunResult result = run_ranks(dir, 2, strips);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(reported_frames(result.err), 7u) << result.err;
  EXPECT_TRUE(pictures_below(dir / "a") == pictures_below(dir / "whole"));
  EXPECT_EQ(bytes_of(dir / "a.mkv"), bytes_of(dir / "whole.mkv"));
  EXPECT_EQ(run_tool(dir, {"check", "a"}).exit_code, 0);
  fs::resize_file(dir / "a/frame_0003.png", 10);
  EXPECT_EQ(run_ranks(dir, 2, strips + Words{"--resume"}).exit_code, 0);
  EXPECT_TRUE(pictures_below(dir / "a") == pictures_below(dir / "whole"));
}

TEST(Mpi, first_rank_reports_all_progress) {
  SKIP_WITHOUT_MPI();
  const TempDir dir;
  const RunResult result = run_ranks(dir, 3, teapot("a", {"--verbose"}));
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(reported_frames(result.err), 40u) << result.err;
}

TEST(Mpi, resuming_renders_only_missing_frames) {
  SKIP_WITHOUT_MPI();
  const TempDir dir;
  ASSERT_EQ(run_ranks(dir, 2, teapot("a")).exit_code, 0);
  const Files whole = files_in(dir / "a", ".png");
  for (const char* name : {"frame_0003.png", "frame_0033.png"}) fs::remove(dir / "a" / name);
  const RunResult resumed = run_ranks(dir, 2, teapot("a", {"--resume", "--verbose"}));
  EXPECT_EQ(resumed.exit_code, 0) << resumed.err;
  EXPECT_EQ(reported_frames(resumed.err), 2u) << resumed.err;
  EXPECT_EQ(files_in(dir / "a", ".png"), whole);
}

TEST(Mpi, wrong_usage_ends_all_ranks) {
  SKIP_WITHOUT_MPI();
  const TempDir dir;
  const RunResult result = run_ranks(dir, 2, {"render", "teapot", "--frames", "9999", "-o", "a"});
  EXPECT_NE(result.exit_code, 0);
  EXPECT_THAT(result.err, HasSubstr("--frames: 9999 is outside the animation"));
  EXPECT_FALSE(fs::exists(dir / "a"));
  EXPECT_THAT(run_ranks(dir, 2, teapot("a", {"--unit", "1/2"})).err, HasSubstr("--unit: cannot be combined with mpirun"));
}

TEST(Mpi, ranks_without_connection_are_refused) {
  SKIP_WITHOUT_MPI();
  const TempDir dir;
  const RunResult result = run(Words{"/usr/bin/env", "PMI_SIZE=4"} + tool_command(teapot("a")), {dir.path().string(), 0});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("the launcher started 4 processes, but MPI connects only 1 of them"));
}

}  // namespace
}  // namespace lippmann::test
