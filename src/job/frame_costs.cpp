#include "job/frame_costs.hpp"

#include <algorithm>
#include <iterator>
#include <set>

#include "distribute/units.hpp"

namespace lippmann {
namespace {

/// Assumed number of frames per key frame, if the renderer chooses the key frames itself (frames/exact_frames.cpp). A key frame
/// from which blocks are copied serves about 16 frames. If copying does not pay off, no key frame follows for at least 16
/// frames. Trial renders cannot measure this number, because their first frame is always a key frame.
constexpr double kFramesPerFreeKey = 16.0;

double mean_cost(const std::vector<double>& costs) {
  double sum = 0.0;
  for (const double cost : costs) sum += cost;
  return costs.empty() ? 0.0 : sum / static_cast<double>(costs.size());
}

double sum_of_cpu(const std::vector<FrameReport>& frames) {
  double sum = 0.0;
  for (const FrameReport& frame : frames) sum += frame.cpu_seconds;
  return sum;
}

std::map<int, double> costs_by_place(const std::vector<FrameReport>& frames, int segment) {
  std::map<int, std::vector<double>> costs;
  std::vector<double> free_keys;
  for (const FrameReport& frame : frames) {
    const bool is_free_key = segment == 1 && frame.kind == "key";
    (is_free_key ? free_keys : costs[frame.frame % segment]).push_back(frame.cpu_seconds);
  }
  std::map<int, double> means;
  for (const auto& [place, some] : costs) means[place] = mean_cost(some);
  if (free_keys.empty()) return means;
  const double key = mean_cost(free_keys), most = means.empty() ? key : means[0];
  means[0] = most + (key - most) / kFramesPerFreeKey;
  return means;
}

double cost_at(int place, const std::map<int, double>& costs) {
  if (costs.empty()) return 0.0;
  const auto next = costs.upper_bound(place);
  return next == costs.begin() ? next->second : std::prev(next)->second;
}

std::set<int> segments_of(const std::vector<FrameReport>& frames, int segment) {
  std::set<int> segments;
  for (const FrameReport& frame : frames) segments.insert(frame.frame / segment);
  return segments;
}

/// Returns the mean CPU time that a unit spends on source frames. These are frames of other units, from which frames of the
/// unit are made. Source frames in measured segments are not counted, because units render them as their own frames.
double source_cost(const MeasuredRun& run, const std::vector<int>& of_job, int segment) {
  const std::set<int> measured = segments_of(run.frames, segment);
  double sum = 0.0;
  for (const FrameReport& source : run.sources) {
    const bool is_own =
        measured.contains(source.frame / segment) && std::binary_search(of_job.begin(), of_job.end(), source.frame);
    if (!is_own) sum += source.cpu_seconds;
  }
  return measured.empty() ? 0.0 : sum / static_cast<double>(measured.size());
}

}  // namespace

std::vector<int> frames_to_measure(const std::vector<int>& of_job, int segment, Neighbours neighbours) {
  const int together = neighbours == Neighbours::kCopied ? std::max(2, segment) : segment;
  const std::vector<std::vector<int>> segments = units_of(of_job, together, static_cast<int>(of_job.size()));
  std::set<int> frames;
  const auto measure = [&](std::size_t i, std::ptrdiff_t count) {
    frames.insert(segments[i].begin(), segments[i].begin() + std::min(count, std::ssize(segments[i])));
  };
  measure(0, 2);
  measure(segments.size() / 2, 2);
  measure(segments.size() - 1, 2);
  return {frames.begin(), frames.end()};
}

JobCosts frame_costs(const MeasuredRun& run, const std::vector<int>& of_job, int segment) {
  JobCosts costs;
  costs.setup_cpu_seconds = run.setup_cpu_seconds;
  costs.at = costs_by_place(run.frames, segment);
  costs.source_cpu_seconds = source_cost(run, of_job, segment);
  const double written = run.cpu_seconds - run.setup_cpu_seconds - sum_of_cpu(run.frames) - sum_of_cpu(run.sources);
  costs.write_cpu_seconds = std::max(0.0, written) / static_cast<double>(std::max<std::size_t>(1, run.frames.size()));
  costs.peak_memory_bytes = run.peak_memory_bytes;
  for (const FrameReport& frame : run.frames)
    if (costs.frames.empty() || costs.frames.back() != frame.frame) costs.frames.push_back(frame.frame);
  return costs;
}

double cpu_seconds_of(const std::vector<int>& frames, int segment, const JobCosts& costs) {
  double sum = costs.setup_cpu_seconds + costs.source_cpu_seconds;
  for (const int frame : frames) sum += costs.write_cpu_seconds + cost_at(frame % segment, costs.at);
  return sum;
}

}  // namespace lippmann
