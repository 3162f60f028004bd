#include "bench/light_run.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>

#include "bench/light_pictures.hpp"
#include "bench/light_references.hpp"
#include "frames/frame_maker.hpp"
#include "job/job_stage.hpp"
#include "job/reuse_params.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/image/encode.hpp"
#include "lippmann/image/metrics.hpp"
#include "lippmann/scene/load.hpp"

namespace lippmann::bench {
namespace {

double resident_bytes() {
  std::ifstream statm("/proc/self/statm");
  double all = 0.0, resident = 0.0;
  statm >> all >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

RenderParams with_reuse(RenderParams params, ReuseChoice reuse, bool denoise) {
  params.reuse.choice = reuse, params.sampling.denoise = denoise;
  return params;
}

RenderParams reference_params(RenderParams params, int spp) {
  params.sampling.spp = spp;
  params.sampling.denoise = false;
  params.sampling.seed += 1;  // references must not share the noise of what is held against them
  return params;
}

/// What one way to render has made so far.
struct Made {
  LightFigures figures;
  Frames frames;                                    ///< compared ones
  std::vector<std::optional<double>> estimates_db;  ///< what the program estimates their PSNR to be
  std::vector<std::optional<double>> at_least_db;   ///< and the bounds below it
};

Scene scene_of(const LightCase& wanted, const Context& context) {
  if (!wanted.build) return wanted_scene(wanted.params, context);
  Scene scene = wanted.build();
  validate(scene, wanted.name);
  return scene;
}

double least(const std::vector<double>& values) { return *std::min_element(values.begin(), values.end()); }

class LightBench {
 public:
  LightBench(const LightCase& wanted, const LightSettings& settings, const Context& context)
      : wanted_(wanted),
        settings_(settings),
        context_(context),
        pool_(resolved_threads(context)),
        full_params_(with_reuse(wanted.params, ReuseChoice::kNone, settings.denoise)),
        reuse_params_(with_reuse(wanted.params, ReuseChoice::kAuto, settings.denoise)),
        stage_(scene_of(wanted, context), full_params_, pool_),
        rows_(rows_to_compare(stage_.placed.optics, wanted.row_share)),
        views_(neighbouring_views(stage_.placed.optics, rows_)),
        blocks_(view_blocks(stage_.placed.optics, rows_)) {
    if (settings.seed) reuse_params_.sampling.seed = *settings.seed;
    frame_params(reuse_params_);  // refuses contradictions
    run_.width = stage_.placed.optics.panel.width, run_.height = stage_.placed.optics.panel.height;
    run_.compared_pixels = rows_.size() * static_cast<std::size_t>(run_.width);
  }

  LightRun run() {
    prepare_references();
    if (!context_.cancelled) render_in_turn();
    run_.equal_time_psnr_db = std::nan("");
    if (!context_.cancelled && wanted_.equal_time && !settings_.without_full) measure_equal_time();
    return run_;
  }

 private:
  int end() const { return wanted_.first + wanted_.count; }
  bool is_compared(int frame) const { return (frame - wanted_.first) % wanted_.reference_step == 0; }

  void say(const std::string& line) const {
    if (settings_.say) settings_.say(line);
  }

  void prepare_references() {
    const RenderParams params = reference_params(full_params_, wanted_.reference_spp);
    LightReferences references(stage_, params, rows_, settings_.references, pool_, context_, settings_.say);
    for (int frame = wanted_.first; frame < end() && !context_.cancelled; ++frame)
      if (is_compared(frame)) references_.push_back(references.frame(frame));
    run_.references_rendered = references.rendered(), run_.references_kept = references.kept();
    run_.compared_frames = static_cast<int>(references_.size());
  }

  void add(const RenderedFrame& frame, Made& made) {
    std::size_t nan_count = 0;
    Image8 codes = to_codes(frame.pictures.film, stage_.scene.encoding, &nan_count);
    if (nan_count > 0)
      throw Error("bench light",
                  fmt::format("{}, frame {}: {} samples are not numbers", wanted_.name, frame.report.frame, nan_count));
    ++run_.passed_checks;
    if (is_compared(frame.report.frame)) {
      made.frames.push_back(take_rows(codes, rows_));
      made.estimates_db.push_back(frame.report.estimated_psnr_db);
      made.at_least_db.push_back(frame.report.psnr_at_least_db);
    }
    LightFigures& figures = made.figures;
    if (figures.seconds_by_frame.empty()) figures.first_seconds = frame.report.cpu_seconds;
    figures.seconds_by_frame.push_back(frame.report.cpu_seconds);
    figures.rays += static_cast<double>(frame.report.rays.total());
  }

  /// Sums of the frames that were rendered become those of all, errors those of the compared ones.
  void judge(Made& made) const {
    LightFigures& figures = made.figures;
    const double rendered = static_cast<double>(figures.seconds_by_frame.size()), all = wanted_.count;
    const std::vector<double>& seconds = figures.seconds_by_frame;
    figures.seconds = std::accumulate(seconds.begin(), seconds.end(), 0.0) * all / rendered;
    figures.rays *= all / rendered;
    figures.psnr_db = psnr_db(mean_squared_error(references_, made.frames));
    figures.block_psnr_db = psnr_db(block_squared_error(references_, made.frames, blocks_));
    figures.worst_blocks_psnr_db = psnr_db(worst_block_squared_error(references_, made.frames, blocks_));
    figures.edge_psnr_db = psnr_db(edge_squared_error(references_, made.frames, blocks_));
    figures.mean_light = mean_light_ratio(references_, made.frames);
    for (std::size_t f = 0; f < made.frames.size(); ++f) {
      const References reference{references_[f]};
      const Frames frame{made.frames[f]};
      figures.psnr_db_by_frame.push_back(psnr_db(mean_squared_error(reference, frame)));
      figures.block_psnr_db_by_frame.push_back(psnr_db(block_squared_error(reference, frame, blocks_)));
      figures.mean_light_by_frame.push_back(mean_light_ratio(reference, frame));
    }
    figures.worst_psnr_db = least(figures.psnr_db_by_frame);
    figures.worst_block_psnr_db = least(figures.block_psnr_db_by_frame);
    const Frames converged = converged_frames();
    figures.view_flicker = view_flicker(made.frames, views_) - view_flicker(converged, views_);
    figures.frame_flicker = wanted_.reference_step == 1 ? frame_flicker(made.frames) - frame_flicker(converged) : std::nan("");
  }

  Frames converged_frames() const {
    Frames frames;
    for (const Reference& reference : references_) frames.push_back(mean_of(reference));
    return frames;
  }

  void render_in_turn() {
    const RenderParams quick = reference_params(full_params_, 1);
    render_frame(stage_, quick.sampling, wanted_.first, pool_, context_);  // warms up
    const double before = resident_bytes();
    const std::unique_ptr<FrameMaker> maker = make_frame_maker(stage_, frame_params(reuse_params_), pool_, context_),
                                      full_maker = make_frame_maker(stage_, frame_params(full_params_), pool_, context_);
    Made full, reuse;
    for (int frame = wanted_.first; frame < end() && !context_.cancelled; ++frame) {
      const bool in_full = is_compared(frame) && !settings_.without_full;
      say(fmt::format("{}, frame {}: rendering with reuse{}", wanted_.name, frame, in_full ? " and in full" : ""));
      RenderedFrame made = maker->make(frame);
      run_.grown_bytes = std::max(run_.grown_bytes, resident_bytes() - before);
      add(made, reuse);
      maker->recycle(std::move(made.pictures.film));
      if (in_full) add(full_maker->make(frame), full);
    }
    if (context_.cancelled) return;
    judge(reuse);
    run_.reuse = reuse.figures;
    run_.estimates_db = reuse.estimates_db, run_.at_least_db = reuse.at_least_db;
    run_.estimate = judge_estimates(reuse.estimates_db, reuse.figures.psnr_db_by_frame);
    const Workload work{stage_.scene.timeline.frame_count, wanted_.count};
    run_.stated_bytes = working_bytes_per_pixel(frame_params(reuse_params_), work) * run_.width * run_.height;
    if (settings_.without_full) return;
    judge(full);
    run_.full = full.figures;
    run_.full_by_spp.push_back({samples_per_pixel(full_params_.sampling), run_.full.seconds, run_.full.psnr_db});
    if (!settings_.pictures.empty()) write_pictures(full.frames, reuse.frames);
  }

  void write_pictures(const Frames& full, const Frames& reuse) const {
    const Frames converged = converged_frames();
    for (std::size_t f = 0; f < converged.size(); ++f) {
      const int frame = wanted_.first + static_cast<int>(f) * wanted_.reference_step;
      write_light_pictures(settings_.pictures, fmt::format("{}_{:04}", wanted_.name, frame), converged[f], full[f], reuse[f],
                           blocks_);
    }
  }

  /// Full renders at two powers of 2, of which one takes less time than the reuse did, if any does, and one more.
  void measure_equal_time() {
    const double all = samples_per_pixel(full_params_.sampling);
    int spp = 1;
    while (2 * spp <= all * std::min(0.5, run_.reuse.seconds / run_.full.seconds)) spp *= 2;
    if (2 * spp < all) measure_full(2 * spp);
    for (; spp >= 1 && spp < all && !context_.cancelled; spp /= 2) {
      measure_full(spp);
      if (run_.full_by_spp.back().seconds <= run_.reuse.seconds) break;
    }
    std::sort(run_.full_by_spp.begin(), run_.full_by_spp.end(), [](const auto& a, const auto& b) { return a.spp < b.spp; });
    run_.equal_time_psnr_db = psnr_at_time(run_.full_by_spp, run_.reuse.seconds);
  }

  void measure_full(int spp) {
    say(fmt::format("{}: rendering in full at {} samples", wanted_.name, spp));
    RenderParams params = full_params_;
    params.sampling.spp = spp;
    const std::unique_ptr<FrameMaker> maker = make_frame_maker(stage_, frame_params(params), pool_, context_);
    Made made;
    for (int frame = wanted_.first; frame < end() && !context_.cancelled; ++frame)
      if (is_compared(frame)) add(maker->make(frame), made);
    if (context_.cancelled) return;
    judge(made);
    run_.full_by_spp.push_back({spp, made.figures.seconds, made.figures.psnr_db});
  }

  const LightCase& wanted_;
  const LightSettings& settings_;
  const Context& context_;
  ThreadPool pool_;
  RenderParams full_params_, reuse_params_;
  JobStage stage_;
  std::vector<int> rows_;
  std::vector<ViewTriple> views_;
  std::vector<Block> blocks_;
  References references_;
  LightRun run_;
};

}  // namespace

LightRun run_light(const LightCase& wanted, const LightSettings& settings, const Context& context) {
  return LightBench(wanted, settings, context).run();
}

}  // namespace lippmann::bench
