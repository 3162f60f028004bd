#include <gmock/gmock.h>

#include <string_view>

#include "tool.hpp"

namespace lippmann::test {
namespace {

/// Memory of a render in bytes. The difference between two picture sizes excludes the program and the scene.
struct Memory {
  double estimated = 0.0, measured = 0.0;
};

Memory memory_of(const TempDir& dir, const Words& flags, const std::string& size) {
  const Words render = Words{"render"} + flags + Words{"--size", size, "--threads", "2"};
  const nlohmann::json plan = report_of(dir, render + Words{"--dry-run", "-o", "planned"});
  const nlohmann::json report = report_of(dir, render + Words{"-o", "rendered_" + size});
  return {plan["estimated_memory_bytes"], report["totals"]["peak_memory_bytes"]};
}

/// Returns the ratio of the estimated to the measured increase of memory from the size `small` to `large`.
double ratio(const Words& flags, const std::string& small, const std::string& large) {
  const TempDir dir;
  const Memory a = memory_of(dir, flags, small), b = memory_of(dir, flags, large);
  return (b.estimated - a.estimated) / (b.measured - a.measured);
}

void expect_near_one(const std::string& what, double ratio) {
  EXPECT_GT(ratio, 1.0 / 1.5) << what;
  EXPECT_LT(ratio, 1.5) << what;
}

const Words kWhitted{"room", "--integrator", "whitted", "--frames", "0"};

class Memories : public testing::Test {
 protected:
  void SetUp() override {
    if (std::string_view(LIPPMANN_SANITIZE) != "") GTEST_SKIP() << "sanitizers use additional memory";
  }
};

TEST_F(Memories, traced_frames_are_near_the_estimate) {
  const std::pair<const char*, Words> cases[] = {
      {"png", {}},
      {"exr", {"--format", "exr"}},
      {"layers", {"--aov", "depth,normal,position"}},
      {"views", {"--layout", "views"}},
  };
  for (const auto& [what, flags] : cases) expect_near_one(what, ratio(kWhitted + flags, "128x128", "640x640"));
}

TEST_F(Memories, interpolated_frames_are_near_the_estimate) {
  const Words flags{"room", "--integrator", "whitted", "--frames", "0-4", "--reuse", "interpolate", "--keyframes", "4"};
  expect_near_one("interpolate", ratio(flags, "128x128", "512x512"));
}

TEST_F(Memories, paths_are_near_the_estimate) {
  const Words flags{"room", "--integrator", "path", "--spp", "2", "--frames", "0"};
  expect_near_one("denoised", ratio(flags, "128x128", "320x320"));
  expect_near_one("as traced", ratio(flags + Words{"--denoise", "none"}, "128x128", "640x640"));
}

}  // namespace
}  // namespace lippmann::test
