#include <gmock/gmock.h>
#include <sys/stat.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "bench/bench.hpp"
#include "support/file_bytes.hpp"
#include "support/subprocess.hpp"
#include "support/temp_dir.hpp"

namespace lippmann::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

RunResult run_program(const TempDir& dir, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), LIPPMANN_BENCH_PROGRAM);
  return run(arguments, {dir.path().string(), 0});
}

void expect_wrong_usage(const std::vector<std::string>& arguments, const std::string& pattern) {
  const TempDir dir;
  const RunResult result = run_program(dir, arguments);
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.out, "");
  EXPECT_THAT(result.err, testing::MatchesRegex("lippmann-bench: " + pattern + "\n"));
}

std::set<std::string> benchmarks_named_in(const fs::path& page) {
  static const std::regex kNamed("lippmann-bench ([a-z]+)");
  const std::string text = file_bytes(page);
  std::set<std::string> names;
  for (std::sregex_iterator match(text.begin(), text.end(), kNamed), end; match != end; ++match) names.insert((*match)[1]);
  return names;
}

TEST(BenchProgram, help_lists_every_benchmark) {
  const TempDir dir;
  const RunResult help = run_program(dir, {"--help"}), bare = run_program(dir, {});
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_EQ(bare.exit_code, 2);
  EXPECT_EQ(bare.err, help.out);
  for (const bench::Benchmark& benchmark : bench::benchmarks())
    EXPECT_THAT(help.out, HasSubstr("  " + std::string(benchmark.name) + " "));
  EXPECT_THAT(help.out, Not(HasSubstr("--scene")));
}

TEST(BenchProgram, help_of_a_benchmark_lists_its_own_options) {
  const TempDir dir;
  const RunResult help = run_program(dir, {"lamps", "--help"});
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_THAT(help.out, HasSubstr("--reference-spp"));
  EXPECT_THAT(help.out, Not(HasSubstr("--scene")));
}

TEST(BenchProgram, version_is_one_line) {
  const TempDir dir;
  EXPECT_THAT(run_program(dir, {"--version"}).out, testing::MatchesRegex("lippmann-bench [0-9]+\\.[0-9]+\\.[0-9]+\n"));
}

TEST(BenchProgram, foreign_options_are_refused_with_the_accepted_ones) {
  expect_wrong_usage({"png", "--frames", "3"}, "--frames: is not an option of png; accepted: --help, --threads, --json");
  expect_wrong_usage({"rays", "--csv", "a"}, "--csv: is not an option of rays; accepted: --help, --scene, --threads, --json");
}

TEST(BenchProgram, bad_values_are_refused) {
  expect_wrong_usage({"lamps", "--reference-spp", "0"},
                     "lamps: --reference-spp: Value 0 not in range [^\n]*1 [^\n]*1048576\\]?");
}

TEST(BenchProgram, unknown_benchmarks_suggest_the_nearest) {
  const TempDir dir;
  const RunResult result = run_program(dir, {"papr"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr("papr: there is no such benchmark, did you mean 'paper'?; accepted: denoise, estimates"));
}

TEST(BenchProgram, json_holds_the_machine_and_the_rows) {
  const TempDir dir;
  const RunResult result =
      run_program(dir, {"light", "--quick", "turntable", "--frames", "1", "--references", "references", "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const nlohmann::json report = nlohmann::json::parse(result.out);
  EXPECT_EQ(report["bench"], "light");
  EXPECT_GT(report["machine"]["threads"], 0);
  EXPECT_EQ(report["rows"].size(), 1u);
  EXPECT_EQ(report["passed_checks"], 3);
}

TEST(BenchProgram, list_names_rows_and_measures_none) {
  const TempDir dir;
  EXPECT_THAT(run_program(dir, {"light", "--list"}).out, HasSubstr("bar-sun"));
}

TEST(BenchProgram, interruption_is_one_line_and_an_exit_code) {
  const TempDir dir;
  ASSERT_EQ(mkfifo((dir / "log").c_str(), 0600), 0);
  Subprocess stopped({"sh", "-c", "exec " LIPPMANN_BENCH_PROGRAM " paper teapot --tachyon-scenes nowhere 2>log"},
                     {dir.path().string(), 0});
  std::ifstream log(dir / "log");
  std::string line;
  while (std::getline(log, line) && line != "teapot: frames 0 to 7") continue;
  ASSERT_EQ(line, "teapot: frames 0 to 7");
  stopped.signal(SIGINT);
  std::vector<std::string> rest;
  while (std::getline(log, line)) rest.push_back(line);
  EXPECT_THAT(rest, testing::ElementsAre("lippmann-bench: interrupted: the benchmark was stopped before its end"));
  EXPECT_EQ(stopped.wait().exit_code, 128 + SIGINT);
}

TEST(BenchProgram, docs_name_all_benchmarks) {
  std::set<std::string> known;
  for (const bench::Benchmark& benchmark : bench::benchmarks()) known.emplace(benchmark.name);
  const fs::path source(LIPPMANN_SOURCE);
  EXPECT_THAT(benchmarks_named_in(source / "docs/lab/benchmarks.md"), testing::ContainerEq(known));
  for (const auto& page : fs::recursive_directory_iterator(source / "docs"))
    if (page.path().extension() == ".md") {
      EXPECT_THAT(benchmarks_named_in(page.path()), testing::IsSubsetOf(known)) << page.path();
    }
}

}  // namespace
}  // namespace lippmann::test
