// Makes the tables of the paper on which this project is based.
#include <fmt/core.h>

#include <cmath>
#include <filesystem>
#include <span>

#include "bench/benchmarks.hpp"
#include "bench/paper_plots.hpp"
#include "bench/paper_summary.hpp"
#include "bench/paper_tables.hpp"
#include "bench/reuse_run.hpp"
#include "bench/rounded_json.hpp"
#include "bench/timing.hpp"
#include "core/atomic_file.hpp"
#include "core/folder.hpp"
#include "frames/frame.hpp"
#include "job/job_stage.hpp"
#include "trace/trace_pixels.hpp"

namespace lippmann::bench {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kPaperRepetitions = 5;

std::vector<ReuseMethod> forward_methods(RenderParams params) {
  params.reuse.choice = ReuseChoice::kInterpolate;
  std::vector<ReuseMethod> methods;
  for (const bool halving : {false, true})
    for (const int interval : {2, 4, 8}) {
      if (halving && interval == 2) continue;  // with an interval of 2, halving changes nothing
      params.reuse.halving = halving;
      params.reuse.keyframes = interval;
      methods.push_back({halving ? "forward, halving" : "forward", params});
    }
  return methods;
}

Json row_of(const ReuseRun& run) {
  const double frames = static_cast<double>(run.frames.size());
  return {{"scene", run.scene},
          {"method", run.method},
          {"keyframes", run.keyframes},
          {"frames", run.frames.size()},
          {"traced_ms", rounded(1e3 * run.traced_seconds() / frames)},
          {"saving_in_between", rounded(run.saving_in_between())},
          {"saving_total", rounded(run.saving())},
          {"psnr_db", rounded_or_null(run.mean_psnr())},
          {"moving_psnr_db", rounded_or_null(run.mean_moving_psnr())},
          {"blend_psnr_db", rounded_or_null(run.mean_blend_psnr())},
          {"ssim", rounded(run.mean_ssim())},
          {"missed", rounded(run.missed_share())}};
}

Json errors(const ChannelErrors& e) {
  return {{"r", rounded(e.r)}, {"g", rounded(e.g)}, {"b", rounded(e.b)}, {"mean", rounded(e.mean)}};
}

Json frames_of(const ReuseRun& run) {
  Json frames = Json::array();
  for (const ReuseFrame& frame : run.frames)
    if (!frame.key)
      frames.push_back({{"scene", run.scene},
                        {"method", run.method},
                        {"keyframes", run.keyframes},
                        {"frame", frame.frame},
                        {"mse", errors(frame.likeness.mse)},
                        {"rmse", errors(frame.likeness.rmse)},
                        {"psnr_db", rounded_or_null(frame.likeness.psnr_db)},
                        {"moving_psnr_db", rounded_or_null(frame.moving_psnr)},
                        {"blend_psnr_db", rounded_or_null(frame.blend_psnr)},
                        {"missed_pixels", frame.missed_pixels}});
  return frames;
}

class StyleTimer {
 public:
  StyleTimer(const BenchScene& scene, const ThreadPool& pool, const Context& context)
      : stage_(ResolvedJob(scene.params), pool, context),
        params_(scene.params),
        frame_(scene.frame),
        pool_(pool),
        context_(context) {
    const Panel& panel = stage_.placed.optics.panel;
    const auto width = static_cast<std::uint32_t>(panel.width), lens = static_cast<std::uint32_t>(lens_width());
    for (std::uint32_t y = 0; y < static_cast<std::uint32_t>(panel.height); ++y)
      for (std::uint32_t x = 0; x < lens; ++x) first_lens_.push_back(y * width + x);
    const ResolvedScene resolved = evaluate(stage_.scene, stage_.scene.timeline.time(frame_));
    world_from_display_ = world_from_display(stage_.array, stage_.placed.units_per_mm, resolved);
    stage_.device.update(resolved, pool_);
    film_ = Image(panel.width, panel.height, 3);
  }

  double lens_ms(RayOrder order) {
    return milliseconds(order, [&](const TraceParams& trace) {
      trace_pixels({stage_.device, stage_.placed.optics, world_from_display_}, trace, first_lens_, {pool_, context_}, film_);
    });
  }

  double frame_ms(RayOrder order) {
    return milliseconds(order, [&](const TraceParams& trace) {
      trace_frame({stage_.device, stage_.placed.optics, world_from_display_}, trace, {pool_, context_}, {film_});
    });
  }

 private:
  int lens_width() const { return whole_pixels_per_lens(stage_.placed.optics).x; }

  template <class Fn>
  double milliseconds(RayOrder order, const Fn& work) {
    TraceParams trace = trace_params(params_.sampling, stage_);
    trace.order = order;
    std::vector<double> all;
    for (int i = 0; i < kPaperRepetitions; ++i) all.push_back(1e3 * second_run([&] { work(trace); }));
    return median(all);
  }

  JobStage stage_;
  RenderParams params_;
  int frame_;
  const ThreadPool& pool_;
  const Context& context_;
  std::vector<std::uint32_t> first_lens_;
  Affine3f world_from_display_;
  Image film_;
};

std::vector<StyleRow> measure_styles(const Request& request, const Context& context) {
  const ThreadPool pool(1);
  std::vector<StyleRow> rows;
  for (const BenchScene& scene : bench_scenes(request, context)) {
    begin_step(request, context, fmt::format("{}: pixel-tracing styles", scene.name));
    StyleTimer timer(scene, pool, context);
    rows.push_back({scene.name, timer.lens_ms(RayOrder::kRows), timer.lens_ms(RayOrder::kColumns),
                    timer.frame_ms(RayOrder::kRows), timer.frame_ms(RayOrder::kColumns), timer.frame_ms(RayOrder::kViewTiles)});
  }
  return rows;
}

Json reproduced_json(const std::vector<Reproduced>& rows) {
  Json all = Json::array();
  for (const Reproduced& row : rows)
    all.push_back({{"scene", row.scene},
                   {"keyframes", row.keyframes},
                   {"saving_total", rounded(row.saving)},
                   {"paper_saving", rounded_or_null(row.paper_saving)},
                   {"psnr_db", rounded_or_null(row.psnr_db)},
                   {"paper_psnr_db", rounded_or_null(row.paper_psnr_db)},
                   {"reproduced", row.verdict()}});
  return all;
}

void write_text(const std::string& path, const std::string& text) {
  write_file_atomically(path, std::as_bytes(std::span(text)));
}

Json styles_json(const std::vector<StyleRow>& rows) {
  Json all = Json::array();
  for (const StyleRow& row : rows)
    all.push_back({{"scene", row.scene},
                   {"horizontal_lens_ms", rounded(row.horizontal_lens_ms)},
                   {"vertical_lens_ms", rounded(row.vertical_lens_ms)},
                   {"horizontal_ms", rounded(row.horizontal_ms)},
                   {"vertical_ms", rounded(row.vertical_ms)},
                   {"view_ms", rounded(row.view_ms)}});
  return all;
}

}  // namespace

Report measure_paper(const Request& request, const Context& context) {
  const NewFolder csv_folder(std::filesystem::path(request.csv).parent_path()), plot_folder(request.plot);
  // throws now if the file cannot be written, instead of after the measurement
  if (!request.csv.empty()) AtomicFile{request.csv};
  std::vector<ReuseRun> runs;
  Report report;
  report.details = {{"frames", Json::array()}};
  for (const BenchAnimation& animation : bench_animations(request, context))
    for (ReuseRun& run : run_reuse(animation, forward_methods(animation.params), request, context)) {
      report.rows.push_back(row_of(run));
      for (const Json& frame : frames_of(run)) report.details["frames"].push_back(frame);
      for (const ReuseFrame& frame : run.frames) report.passed_checks += frame.key;
      runs.push_back(std::move(run));
    }
  Request builtin = request;
  std::erase_if(builtin.scenes, [](const std::string& name) { return !is_builtin_scene(name); });
  std::vector<StyleRow> styles;
  if (request.scenes.empty() || !builtin.scenes.empty()) styles = measure_styles(builtin, context);
  report.details["styles"] = styles_json(styles);
  const std::vector<Reproduced> reproduced = reproduced_figures(runs);
  report.details["reproduced"] = reproduced_json(reproduced);
  report.text = reproduced_text(reproduced) + '\n' + table_1(runs) + '\n' + table_2(runs) + '\n' + table_3(styles);
  if (!request.csv.empty()) write_text(request.csv, reproduced_csv(reproduced));
  if (!request.plot.empty()) plot_reuse(runs, request.plot);
  return report;
}

}  // namespace lippmann::bench
