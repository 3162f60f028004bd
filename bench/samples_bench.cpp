// What keeping samples over time could save at most: the share of a frame's samples, and of their rays, that meet nothing that
// moves to the next frame (sample_survey.hpp), by what their segments are for. Nothing is timed.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "bench/benchmarks.hpp"
#include "bench/light_rows.hpp"
#include "bench/sample_survey.hpp"
#include "bench/timing.hpp"
#include "job/job_stage.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/scene/load.hpp"
#include "reuse/swept_boxes.hpp"

namespace lippmann::bench {
namespace {

constexpr int kSurveyViewPixels = 96, kQuickSurveyViewPixels = 16, kSurveyedPairs = 3, kLongKept = 8;
/// Rows of `bench light`, but for those that repeat others in other sizes. walker is a character on a still stage, flight moves
/// the array through still things.
const std::vector<std::string> kSurveyedRows{
    "turntable",  "walker",    "flight", "teapot",  "room",  "small-balls", "tree", "bar-sun",  "bar-lamp", "fast-lamp",
    "fast-point", "tiny-lamp", "flash",  "mirrors", "glass", "gloss",       "thin", "textured", "furnished"};

LightCase survey_case(const std::string& name, Request request, const Context& context) {
  if (request.view_pixels == 0) request.view_pixels = request.quick ? kQuickSurveyViewPixels : kSurveyViewPixels;
  request.quick = false;  // it means fewer frames, too
  request.scenes = {name};
  return light_cases(request, context).front();
}

void add(const SegmentCount& more, SegmentCount& sum) { sum.all += more.all, sum.untouched += more.untouched; }

void add(const SampleSurvey& more, SampleSurvey& sum) {
  for (std::size_t c = 0; c < kSegmentClasses; ++c) add(more.segments[c], sum.segments[c]);
  add(more.samples, sum.samples), add(more.rays, sum.rays);
  sum.seen_alike += more.seen_alike, sum.rays_seen_alike += more.rays_seen_alike;
}

struct SurveyedRow {
  SampleSurvey gather, gather_long, paths;
  bool display_moves = false;
};

class SurveyedStage {
 public:
  SurveyedStage(const LightCase& wanted, const ThreadPool& pool, const Context& context)
      : wanted_(wanted),
        pool_(pool),
        stage_(wanted.build ? wanted.build() : wanted_scene(wanted.params, context), wanted.params, pool),
        boxes_(stage_.scene, -1) {}

  SurveyedRow survey() {
    SurveyedRow row;
    for (int pair = 1; pair <= kSurveyedPairs; ++pair)
      survey_frame(wanted_.first + pair * (wanted_.count - 1) / (kSurveyedPairs + 1), row);
    return row;
  }

 private:
  void survey_frame(int frame, SurveyedRow& row) {
    const Moment moment = stage_.moment_at(frame), next = stage_.moment_at(frame + 1);
    stage_.device.update(moment.resolved, pool_);
    row.display_moves |= !(moment.world_from_display == next.world_from_display);
    const int long_kept[] = {kLongKept}, once[] = {2};
    const std::vector<HorizonBox> boxes = boxes_.around(frame, once, frame + 1);
    const std::vector<HorizonBox> long_boxes =
        boxes_.around(frame, long_kept, std::max(frame + 1, wanted_.first + wanted_.count - 1));
    const Shot shot = stage_.shot(moment);
    const SurveyParams params{SampleKind::kGather, 2, stage_.scene.max_depth, static_cast<std::uint32_t>(frame)};
    add(survey_samples(shot, boxes, params), row.gather);
    add(survey_samples(shot, long_boxes, params), row.gather_long);
    SurveyParams of_paths = params;
    of_paths.kind = SampleKind::kPaths;
    add(survey_samples(shot, boxes, of_paths), row.paths);
  }

  const LightCase& wanted_;
  const ThreadPool& pool_;
  JobStage stage_;
  SweptBoxes boxes_;
};

/// Per cent that is untouched; null where there is none.
nlohmann::ordered_json percent(const SegmentCount& count) {
  if (count.all == 0) return nullptr;
  return std::round(1000.0 * static_cast<double>(count.untouched) / static_cast<double>(count.all)) / 10.0;
}

/// The rays that need not be traced: of a still display those of untouched samples; where it moves, a sample that any eye would
/// see has to be seen anew, by one ray.
SegmentCount saved_rays(const SampleSurvey& survey, bool display_moves) {
  if (!display_moves) return survey.rays;
  return {survey.rays.all, survey.rays_seen_alike - survey.seen_alike};
}

nlohmann::ordered_json row_of(const std::string& scene, const SurveyedRow& row, SampleKind kind) {
  const bool gathers = kind == SampleKind::kGather;
  const SampleSurvey& survey = gathers ? row.gather : row.paths;
  const auto of = [&](SegmentClass segment) { return percent(survey.of(segment)); };
  return {{"scene", scene},
          {"samples_of", gathers ? "gather" : "paths"},
          {"display_moves", row.display_moves},
          {"rays_per_sample", rounded(static_cast<double>(survey.rays.all) / static_cast<double>(survey.samples.all))},
          {"camera", of(SegmentClass::kCamera)},
          {"mirror", of(SegmentClass::kMirror)},
          {"bounce", of(SegmentClass::kBounce)},
          {"to_point", of(SegmentClass::kToPoint)},
          {"to_round", of(SegmentClass::kToRound)},
          {"to_sun", of(SegmentClass::kToSun)},
          {"to_lamp", of(SegmentClass::kToLamp)},
          {"to_sky", of(SegmentClass::kToSky)},
          {"samples", percent(survey.samples)},
          {"samples_8_frames", gathers ? percent(row.gather_long.samples) : nlohmann::ordered_json(nullptr)},
          {"rays", percent(survey.rays)},
          {"rays_saved", percent(saved_rays(survey, row.display_moves))}};
}

void check(const std::string& scene, const SampleSurvey& survey) {
  std::uint64_t rays = 0;
  for (const SegmentCount& segment : survey.segments) rays += segment.all;
  if (rays != survey.rays.all)
    throw Error("bench samples", fmt::format("{}: {} segments, but {} rays of samples", scene, rays, survey.rays.all));
}

}  // namespace

Report measure_samples(const Request& request, const Context& context) {
  Report report;
  const ThreadPool pool(1);
  for (const std::string& name : request.scenes.empty() ? kSurveyedRows : request.scenes) {
    begin_step(request, context, "samples: " + name);
    const LightCase wanted = survey_case(name, request, context);
    if (wanted.count < 2) throw Error("bench samples", name + " is a still", "an animation");
    SurveyedRow row;
    pool.run([&] { row = SurveyedStage(wanted, pool, context).survey(); });
    for (const SampleSurvey* survey : {&row.gather, &row.gather_long, &row.paths}) check(name, *survey), ++report.passed_checks;
    for (const SampleKind kind : {SampleKind::kGather, SampleKind::kPaths}) report.rows.push_back(row_of(name, row, kind));
  }
  return report;
}

}  // namespace lippmann::bench
