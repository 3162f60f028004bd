#include "job/submission.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/json_text.hpp"
#include "core/printable.hpp"

namespace lippmann {
namespace {

using Json = nlohmann::ordered_json;

/// `unit` is shell text that expands to the number of the unit.
std::string render_command(const Submission& submission, const std::string& unit) {
  return fmt::format("{} render {} --unit {}/{} --threads {} --resume --quiet", shell_word(submission.program.string()),
                     shell_word(submission.job.string()), unit, submission.units, submission.threads);
}

std::string finish_command(const Submission& submission) {
  return fmt::format("{} finish {}", shell_word(submission.program.string()), shell_word(submission.folder.string()));
}

std::string limits(const Submission& submission, const std::optional<std::uint64_t>& memory_bytes) {
  std::string text;
  if (submission.minutes) text += fmt::format(" --time={}", *submission.minutes);
  if (memory_bytes) text += fmt::format(" --mem={}M", (*memory_bytes + 999'999) / 1'000'000);
  return text;
}

std::optional<std::uint64_t> finish_memory(const Submission& submission) {
  if (!submission.memory_bytes) return {};
  return std::max(*submission.memory_bytes, submission.finish_memory_bytes.value_or(0));
}

Json action(const Submission& submission, const Json& arguments) {
  return {{"actions", {{"onRun", {{"command", submission.program.string()}, {"args", arguments}}}}}};
}

Json unit_parameter(const Submission& submission) {
  Json parameter{{"name", "Unit"}, {"type", "INT"}, {"range", fmt::format("1-{}", submission.units)}};
  if (submission.chunk <= 1) return parameter;
  parameter["type"] = "CHUNK[INT]";
  parameter["chunks"] = {{"defaultTaskCount", submission.chunk}, {"rangeConstraint", "NONCONTIGUOUS"}};
  return parameter;
}

}  // namespace

int minutes_for(double cpu_seconds, int threads) { return 5 + static_cast<int>(std::ceil(3.0 * cpu_seconds / threads / 60.0)); }

std::uint64_t memory_for(std::uint64_t peak_memory_bytes) { return peak_memory_bytes + peak_memory_bytes / 2; }

std::string slurm_script(const Submission& submission) {
  const std::string partition =
      submission.partition.empty() ? "" : fmt::format(" --partition={}", shell_word(submission.partition));
  const std::string name = shell_word(submission.name), folder = shell_word(submission.folder.string());
  return fmt::format(R"(#!/usr/bin/env bash
# Submits {units} tasks that render {job}, and one that finishes it once all have succeeded.
# Run it on a machine of the cluster; the output of tasks goes to {folder}/slurm.
set -euo pipefail
mkdir -p {folder}/slurm
render=$(sbatch --parsable --job-name={name}{partition} --array=1-{units} --cpus-per-task={threads}{limits} --requeue \
  --open-mode=append --output={folder}/slurm/%A_%a.log <<'TASK'
#!/usr/bin/env bash
exec {render}
TASK
)
finish=$(sbatch --parsable --job-name={name}-finish{partition} --dependency=afterok:"$render" --kill-on-invalid-dep=yes \
  --cpus-per-task={threads}{finish_limits} --requeue --open-mode=append --output={folder}/slurm/%j.log <<'TASK'
#!/usr/bin/env bash
exec {finish}
TASK
)
echo "submitted: array job $render, then $finish"
)",
                     fmt::arg("units", submission.units), fmt::arg("job", printable(submission.job.string())),
                     fmt::arg("folder", folder), fmt::arg("name", name), fmt::arg("partition", partition),
                     fmt::arg("threads", submission.threads), fmt::arg("limits", limits(submission, submission.memory_bytes)),
                     fmt::arg("finish_limits", limits(submission, finish_memory(submission))),
                     fmt::arg("render", render_command(submission, "\"$SLURM_ARRAY_TASK_ID\"")),
                     fmt::arg("finish", finish_command(submission)));
}

std::string openjd_template(const Submission& submission) {
  const std::string unit = fmt::format("{{{{Task.Param.Unit}}}}/{}", submission.units);
  Json json{{"specificationVersion", "jobtemplate-2023-09"}};
  if (submission.chunk > 1) json["extensions"] = {"TASK_CHUNKING"};
  json["name"] = submission.name;
  json["steps"] = {{{"name", "Render"},
                    {"parameterSpace", {{"taskParameterDefinitions", {unit_parameter(submission)}}}},
                    {"script", action(submission, {"render", submission.job.string(), "--unit", unit, "--threads",
                                                   std::to_string(submission.threads), "--resume", "--quiet"})}},
                   {{"name", "Finish"},
                    {"dependencies", {{{"dependsOn", "Render"}}}},
                    {"script", action(submission, {"finish", submission.folder.string()})}}};
  return json_to_text(json) + '\n';
}

std::string shell_commands(const Submission& submission) {
  std::string text =
      "# One unit per line, in any order, on any machines that share the folder. Run the last line after all units.\n";
  for (int unit = 1; unit <= submission.units; ++unit) text += render_command(submission, std::to_string(unit)) + '\n';
  return text + finish_command(submission) + '\n';
}

}  // namespace lippmann
