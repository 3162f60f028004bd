// Simulates jobs on failing machines. LIPPMANN_SEEDS=0-999999 selects the seeds. A single seed prints its log.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <iostream>

#include "core/frame_ranges.hpp"
#include "simulation/story.hpp"

namespace lippmann::test {
namespace {

TEST(Simulation, killed_jobs_lose_and_damage_no_frames) {
  const char* said = std::getenv("LIPPMANN_SEEDS");
  const FrameRanges seeds = read_frames(said ? said : "0-999", "LIPPMANN_SEEDS");
  std::uint64_t stories = 0, frames = 0, runs = 0, calls = 0, failed = 0;
  for (const FrameRange& range : seeds)
    for (int seed = range.first; seed <= range.last; seed += range.step) {
      const Story story = tell_story(static_cast<std::uint64_t>(seed));
      ++stories, frames += static_cast<std::uint64_t>(story.frames), runs += static_cast<std::uint64_t>(story.runs);
      calls += story.calls;
      if (story.problem.empty()) continue;
      EXPECT_EQ(story.problem, "") << "LIPPMANN_SEEDS=" << seed << "\n" << story.log;
      if (++failed == 1000) break;
    }
  std::cout << stories << " jobs of " << frames << " frames, " << runs << " runs, " << calls << " calls of the system; "
            << failed << " failed\n";
}

}  // namespace
}  // namespace lippmann::test
