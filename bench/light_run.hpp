// Renders the frames of a row in several ways, and compares them with converged references: CPU time, error, mean light,
// flicker.
//
// CPU seconds are those of rendering, of all threads together. Every frame is rendered in all ways before the next frame is, so
// that all ways find the machine in the same state.
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

/// What one way to render the frames of a row takes and gives.
struct LightFigures {
  double cpu_seconds = 0.0;
  double psnr_db = 0.0, block_psnr_db = 0.0, edge_psnr_db = 0.0;  ///< from the mean squared errors of all frames
  double mean_light = 1.0;                                        ///< over that of the references
  double view_flicker = 0.0, frame_flicker = 0.0;                 ///< less those of the references, in codes
  std::vector<FrameReport> reports;                               ///< by frame
  std::vector<double> psnr_db_by_frame;
  Frames frames;
};

class LightBench {
 public:
  /// Makes the scene, and the references that are not kept. `row`, `request` and `context` outlive this. Throws Error.
  LightBench(const LightCase& row, const Request& request, const Context& context);

  /// One result per sampling, which differ in samples, denoising and seed from that of the row. Throws Error where a frame has
  /// a sample that is NaN, or when the context is cancelled.
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

/// The row's sampling with other samples per pixel, denoised or not.
Sampling with_samples(Sampling sampling, int spp, Denoise denoise);

}  // namespace lippmann::bench
