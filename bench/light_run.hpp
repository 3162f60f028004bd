// Renders the frames of a LightCase (a row of the benchmark's table) with several samplings, and measures CPU time, error, mean
// light and flicker relative to converged frames.
//
// Each frame is rendered with all samplings before the next frame, so that changes in the machine's speed affect all samplings
// equally.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "bench/bench.hpp"
#include "bench/light_figures.hpp"
#include "bench/light_references.hpp"
#include "bench/light_rows.hpp"
#include "job/job_stage.hpp"
#include "lippmann/core/parallel.hpp"

namespace lippmann::bench {

struct LightFigures {
  double cpu_seconds = 0.0;
  double psnr_db = 0.0, block_psnr_db = 0.0, edge_psnr_db = 0.0;
  double mean_light = 1.0;
  double view_flicker = 0.0, frame_flicker = 0.0;  ///< flicker minus the flicker of the references, in codes
  std::vector<FrameReport> reports;
  std::vector<double> psnr_db_by_frame;
  Frames frames;
};

class LightBench {
 public:
  /// Renders the references that are not yet stored. `row`, `request` and `context` must outlive this object. Throws Error if
  /// the scene is invalid or a reference cannot be rendered.
  LightBench(const LightCase& row, const Request& request, const Context& context);

  /// Returns one result for each sampling. Samplings may differ from the row's sampling only in samples, denoising and seed.
  /// Throws Error if a frame contains a NaN, or if the context is cancelled.
  std::vector<LightFigures> measure(const std::vector<Sampling>& ways);

  Vec2i film_size() const;
  const References& references() const { return references_; }
  const LightReferences& reference_counts() const { return *reference_maker_; }

 private:
  void judge(LightFigures& figures) const;

  const LightCase& row_;
  const Request& request_;
  const Context& context_;
  ThreadPool pool_;
  JobStage stage_;
  ViewStack views_;
  std::optional<LightReferences> reference_maker_;
  References references_;
};

Sampling with_samples(Sampling sampling, int spp, Denoise denoise);

}  // namespace lippmann::bench
