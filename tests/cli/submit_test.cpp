#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <thread>

#include "cli/tool.hpp"

namespace lippmann::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

void write_job(const TempDir& dir, const std::string& size = "64x16") {
  std::ofstream(dir / "film.toml") << "scene = \"teapot\"\nframes = \"0-11\"\nlenses = \"8x2\"\nsize = \"" << size
                                   << "\"\noutput = \"film\"\nvideo = [\"film.mkv\"]\n";
}

Files whole_film(const TempDir& dir) {
  EXPECT_EQ(run_tool(dir, {"render", "film.toml", "-o", "whole", "--video", "whole.mkv", "-q"}).exit_code, 0);
  Files files = files_in(dir / "whole", ".png");
  files["film.mkv"] = bytes_of(dir / "whole.mkv");
  return files;
}

Files film(const TempDir& dir) {
  Files files = files_in(dir / "film", ".png");
  files["film.mkv"] = fs::exists(dir / "film.mkv") ? bytes_of(dir / "film.mkv") : "";
  return files;
}

TEST(Submit, shell_commands_render_the_whole_job) {
  const TempDir dir;
  write_job(dir);
  ASSERT_EQ(run_tool(dir, {"submit", "film.toml", "--units", "3", "--shell", "film.sh", "--threads", "1"}).exit_code, 0);
  std::ifstream script(dir / "film.sh");
  Words lines;
  for (std::string line; std::getline(script, line);)
    if (!line.starts_with("#")) lines.push_back(line);
  ASSERT_EQ(lines.size(), 4u);
  for (const int i : {2, 0, 1, 3})
    EXPECT_EQ(run({"sh", "-c", lines[static_cast<std::size_t>(i)]}, {"/", 0}).exit_code, 0)
        << lines[static_cast<std::size_t>(i)];
  EXPECT_EQ(film(dir), whole_film(dir));
}

/// Returns the numbers of an OpenJD range such as "1-3,5,7-10:2".
std::vector<int> expanded(const std::string& range) {
  std::vector<int> numbers;
  std::stringstream parts(range);
  for (std::string part; std::getline(parts, part, ',');) {
    int first = 0, last = 0, step = 1;
    const int read = std::sscanf(part.c_str(), "%d-%d:%d", &first, &last, &step);
    for (int i = first; i <= (read == 1 ? first : last); i += step) numbers.push_back(i);
  }
  return numbers;
}

/// Returns the command of the OpenJD action "onRun", with `value` for the task parameter Unit.
Words command_of(const nlohmann::json& script, const std::string& value) {
  const nlohmann::json& action = script["actions"]["onRun"];
  Words words{action["command"]};
  for (std::string word : action["args"]) {
    const std::string place = "{{Task.Param.Unit}}";
    if (const std::size_t at = word.find(place); at != std::string::npos) word.replace(at, place.size(), value);
    words.push_back(word);
  }
  return words;
}

TEST(Submit, open_job_description_renders_the_whole_job) {
  for (const bool in_chunks : {false, true}) {
    const TempDir dir;
    write_job(dir);
    Words submit{"submit", "film.toml", "--units", "4", "--openjd", "film.json"};
    if (in_chunks) submit = submit + Words{"--chunk", "3"};
    ASSERT_EQ(run_tool(dir, submit).exit_code, 0);
    const nlohmann::json job = json_of(bytes_of(dir / "film.json"));
    EXPECT_EQ(job["specificationVersion"], "jobtemplate-2023-09");
    EXPECT_EQ(job["name"], "film");
    EXPECT_EQ(job.contains("extensions"), in_chunks);
    const nlohmann::json& render = job["steps"][0];
    const nlohmann::json& unit = render["parameterSpace"]["taskParameterDefinitions"][0];
    EXPECT_EQ(unit["type"], in_chunks ? "CHUNK[INT]" : "INT");
    EXPECT_EQ(unit["range"], "1-4");
    const Words tasks = in_chunks ? Words{"1,3-4", "2"} : Words{"4", "1", "2", "3"};
    std::size_t units = 0;
    for (const std::string& value : tasks) {
      units += expanded(value).size();
      const RunResult result = run(command_of(render["script"], value), {"/", 0});
      EXPECT_EQ(result.exit_code, 0) << result.err;
    }
    EXPECT_EQ(units, expanded(unit["range"]).size());
    EXPECT_EQ(job["steps"][1]["dependencies"][0]["dependsOn"], render["name"]);
    EXPECT_EQ(run(command_of(job["steps"][1]["script"], ""), {"/", 0}).exit_code, 0);
    EXPECT_EQ(film(dir), whole_film(dir));
  }
}

TEST(Submit, limits_of_tasks_are_measured_or_given) {
  const TempDir dir;
  write_job(dir);
  const Words submit{"submit", "film.toml", "--units", "3", "--slurm", "film.sh", "--json"};
  const nlohmann::json measured = json_of(run_tool(dir, submit).out);
  EXPECT_GE(measured["minutes"], 6);
  EXPECT_GT(measured["memory_bytes"], 10'000'000);
  EXPECT_THAT(bytes_of(dir / "film.sh"), HasSubstr("--array=1-3 "));
  const nlohmann::json given = json_of(run_tool(dir, submit + Words{"--time", "90", "--memory", "4000", "--only-list"}).out);
  EXPECT_EQ(given["minutes"], 90);
  EXPECT_THAT(bytes_of(dir / "film.sh"), HasSubstr("--time=90 --mem=4000M"));
  EXPECT_TRUE(json_of(run_tool(dir, submit + Words{"--only-list"}).out)["minutes"].is_null());
}

TEST(Submit, missing_jobs_and_targets_are_refused) {
  const TempDir dir;
  write_job(dir);
  expect_refusal(run_tool(dir, {"submit", "film.toml", "--units", "3"}), 2, "--slurm FILE, --openjd FILE or --shell FILE");
  expect_refusal(run_tool(dir, {"submit", "teapot", "--units", "3", "--shell", "a"}), 2, "--dump-job");
  expect_refusal(run_tool(dir, {"submit", "none.toml", "--units", "3", "--shell", "a"}), 1, "none.toml");
}

class SlurmCluster {
 public:
  SlurmCluster() : folder_(dir_ / "cluster") {
    is_there_ = geteuid() == 0 && std::system("command -v slurmctld slurmd sbatch munged > /dev/null") == 0;
    if (is_there_) is_there_ = run({script(), "start", folder_}).exit_code == 0;
  }
  ~SlurmCluster() {
    if (is_there_) run({script(), "stop", folder_});
  }
  SlurmCluster(const SlurmCluster&) = delete;
  SlurmCluster& operator=(const SlurmCluster&) = delete;

  bool is_there() const { return is_there_; }

  RunResult shell(const std::string& command, const fs::path& where = "/") const {
    return run({"/usr/bin/env", "SLURM_CONF=" + folder_ + "/slurm.conf", "bash", "-c", command}, {where.string(), 0});
  }

  bool prints_within_two_minutes(const std::string& command, const std::string& text) const {
    for (int i = 0; i < 1200; ++i, std::this_thread::sleep_for(std::chrono::milliseconds(100)))
      if (shell(command).out == text) return true;
    return false;
  }

  bool ends() const { return prints_within_two_minutes("squeue -h", ""); }

 private:
  static std::string script() { return LIPPMANN_SOURCE "/tests/cli/slurm/cluster.sh"; }

  TempDir dir_;
  std::string folder_;
  bool is_there_ = false;
};

TEST(Submit, slurm_survives_requeues_drains_and_kills) {
  const SlurmCluster cluster;
  if (!cluster.is_there()) GTEST_SKIP() << "no Slurm (packages slurmctld, slurmd, slurm-client, munge; as root)";
  const TempDir dir;
  write_job(dir, "512x256");
  const Files whole = whole_film(dir);
  ASSERT_EQ(run_tool(dir, {"submit", "film.toml", "--units", "4", "--threads", "1", "--slurm", "film.sh"}).exit_code, 0);

  ASSERT_THAT(cluster.shell("bash film.sh", dir.path()).out, HasSubstr("submitted: array job"));
  ASSERT_TRUE(appears(dir / "film/frame_0000.png"));
  const std::string task = cluster.shell("squeue -h -t running -o %A | head -1").out;
  EXPECT_EQ(cluster.shell("scontrol requeue " + task).exit_code, 0);
  EXPECT_EQ(cluster.shell("scontrol update nodename=$(hostname -s) state=drain reason=test").exit_code, 0);
  ASSERT_TRUE(cluster.prints_within_two_minutes("sinfo -h -o %T", "drained\n")) << cluster.shell("sinfo").out;
  EXPECT_EQ(cluster.shell("scontrol update nodename=$(hostname -s) state=resume").exit_code, 0);
  ASSERT_TRUE(cluster.ends()) << cluster.shell("squeue").out;
  EXPECT_EQ(film(dir), whole);
  EXPECT_EQ(run_tool(dir, {"check", "film"}).exit_code, 0);

  // A killed task fails and its dependent task does not run. Submitting the script again continues the job.
  fs::remove_all(dir / "film"), fs::remove(dir / "film.mkv");
  cluster.shell("bash film.sh", dir.path());
  ASSERT_TRUE(appears(dir / "film/frame_0000.png"));
  cluster.shell("scancel --signal=KILL --full $(squeue -h -t running -o %A | head -1)");
  ASSERT_TRUE(cluster.ends()) << cluster.shell("squeue").out;
  EXPECT_FALSE(fs::exists(dir / "film.mkv"));
  cluster.shell("bash film.sh", dir.path());
  ASSERT_TRUE(cluster.ends()) << cluster.shell("squeue").out;
  EXPECT_EQ(film(dir), whole);
}

}  // namespace
}  // namespace lippmann::test
