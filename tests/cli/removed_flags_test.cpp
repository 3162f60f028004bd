#include <gmock/gmock.h>

#include <fstream>

#include "cli/tool.hpp"

namespace lippmann::test {
namespace {

struct Removed {
  std::string name, value, replacement;
};

class RemovedFlags : public testing::TestWithParam<Removed> {};

TEST_P(RemovedFlags, name_their_replacement) {
  const auto& [name, value, replacement] = GetParam();
  const TempDir dir;
  for (const Words& flag : {Words{"--" + name, value}, Words{"--" + name + "=" + value}}) {
    const RunResult result = run_tool(dir, Words{"render", "teapot", "--integrator", "path", "--frames", "0"} + flag);
    expect_refusal(result, 2, "--" + name + ": ");
    EXPECT_THAT(result.err, testing::HasSubstr("was removed"));
    EXPECT_THAT(result.err, testing::HasSubstr(replacement));
  }
  EXPECT_TRUE(std::filesystem::is_empty(dir.path()));
  const bool is_number = name == "time-budget";
  std::ofstream(dir / "job.toml") << "scene = \"teapot\"\nframes = \"0\"\nintegrator = \"path\"\n"
                                  << name << " = " << (is_number ? value : '"' + value + '"') << "\n";
  const RunResult result = run_tool(dir, {"render", "job.toml"});
  expect_refusal(result, 2, name + ": ");
  EXPECT_THAT(result.err, testing::HasSubstr("job.toml"));
  EXPECT_THAT(result.err, testing::HasSubstr("was removed"));
  EXPECT_THAT(result.err, testing::HasSubstr(replacement));
  EXPECT_FALSE(std::filesystem::exists(dir / "out"));
}

INSTANTIATE_TEST_SUITE_P(Each, RemovedFlags,
                         testing::Values(Removed{"reuse", "light", "--denoise auto (the default)"},
                                         Removed{"time-budget", "2.5", "--spp, to which the time of a frame is proportional"},
                                         Removed{"quality-at", "eye", "lippmann replay or compare"},
                                         Removed{"debug", "provenance", "--aov provenance"}),
                         [](const auto& removed) {
                           std::string name = removed.param.name;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace lippmann::test
