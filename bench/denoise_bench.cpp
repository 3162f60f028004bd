// Path-traced frames with and without --denoise at few samples, against converged ones: PSNR, flicker from view to view, time.
//
// A frame of each scene through 64 lenses of 8 pixels, and one as a quilt; its neighbours are traced too, as in an animation,
// but their time is not its own. References at another seed, on some rows (bench/light_figures.hpp).
#include <fmt/core.h>

#include "bench/benchmarks.hpp"
#include "bench/light_figures.hpp"
#include "bench/light_references.hpp"
#include "bench/scenes.hpp"
#include "bench/timing.hpp"
#include "frames/frame_maker.hpp"
#include "job/job_stage.hpp"
#include "job/reuse_params.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/image/encode.hpp"
#include "lippmann/image/metrics.hpp"

namespace lippmann::bench {
namespace {

constexpr int kDenoiseReferenceSamples = 2048, kQuickDenoiseReferenceSamples = 64, kDenoiseRowShare = 16,
              kQuickDenoiseRowShare = 4;
constexpr std::uint32_t kReferenceSeed = 77;

struct MeasuredNoise {
  double psnr_db, flicker, cpu_seconds;
};

class DenoiseCase {
 public:
  DenoiseCase(RenderParams params, int frame, const Request& request, const ThreadPool& pool, const Context& context)
      : params_(std::move(params)), frame_(frame), pool_(pool), context_(context), stage_(params_, pool, context) {
    const Optics& optics = stage_.placed.optics;
    rows_ = rows_to_compare(optics, request.quick ? kQuickDenoiseRowShare : kDenoiseRowShare);
    triples_ = neighbouring_views(optics, rows_);
    RenderParams converged = params_;
    converged.sampling.seed = kReferenceSeed;
    converged.sampling.spp = request.reference_spp > 0 ? request.reference_spp
                             : request.quick           ? kQuickDenoiseReferenceSamples
                                                       : kDenoiseReferenceSamples;
    LightReferences references(
        stage_, converged, rows_,
        request.references.empty() ? default_reference_folder() : std::filesystem::path(request.references), pool, context,
        request.say);
    reference_ = {references.frame(frame)};
  }

  /// Beyond that of the reference.
  double flicker_of(const Frames& frames) const {
    return view_flicker(frames, triples_) - view_flicker({mean_of(reference_[0])}, triples_);
  }

  MeasuredNoise measure(int spp, bool denoise) {
    RenderParams params = params_;
    params.sampling.spp = spp, params.sampling.denoise = denoise;
    const std::unique_ptr<FrameMaker> maker = make_frame_maker(stage_, frame_params(params), pool_, context_);
    const RenderedFrame made = maker->make(frame_);
    const Frames frames{take_rows(to_codes(made.pictures.film, stage_.scene.encoding), rows_)};
    return {psnr_db(mean_squared_error(reference_, frames)), flicker_of(frames), made.report.cpu_seconds};
  }

 private:
  RenderParams params_;
  int frame_;
  const ThreadPool& pool_;
  const Context& context_;
  JobStage stage_;
  std::vector<int> rows_;
  std::vector<ViewTriple> triples_;
  References reference_;
};

/// Eight views of 128 x 128 pixels.
RenderParams quilt_of(RenderParams params) {
  params.optics.kind = OpticsKind::kMultiview;
  params.optics.views = {8, 1};
  params.optics.size = {8 * 128, 128};
  params.optics.view_angle_deg = 20.0f;
  return params;
}

}  // namespace

Report measure_denoise(const Request& request, const Context& context) {
  Report report;
  const ThreadPool pool(resolved_threads(context));
  Request wanted = request;
  if (wanted.scenes.empty()) wanted.scenes = {"teapot", "room", "tree"};
  for (const BenchScene& scene : bench_scenes(wanted, context))
    for (const bool quilt : {false, true}) {
      RenderParams params = quilt ? quilt_of(scene.params) : scene.params;
      params.sampling.integrator = Integrator::kPath;
      params.sampling.spp = 4;
      if (request.quick)
        (quilt ? params.optics.size : params.optics.lenses) = quilt ? Extent<int>{8 * 16, 16} : Extent<int>{16, 16};
      DenoiseCase bench(params, scene.frame, request, pool, context);
      for (const int spp : {4, 16, 64}) {
        begin_step(request, context, fmt::format("denoise: {} {}, {} spp", scene.name, quilt ? "quilt" : "integral", spp));
        const MeasuredNoise noisy = bench.measure(spp, false), denoised = bench.measure(spp, true);
        if (spp <= 16 && !request.quick && !(denoised.psnr_db > noisy.psnr_db))
          throw Error("bench denoise", fmt::format("{} at {} samples is farther from the truth than before", scene.name, spp));
        ++report.passed_checks;
        report.rows.push_back({{"scene", scene.name},
                               {"picture", quilt ? "quilt" : "integral"},
                               {"spp", spp},
                               {"noisy_psnr_db", rounded(noisy.psnr_db)},
                               {"psnr_db", rounded(denoised.psnr_db)},
                               {"noisy_flicker", rounded(noisy.flicker)},
                               {"flicker", rounded(denoised.flicker)},
                               {"noisy_cpu_seconds", rounded(noisy.cpu_seconds)},
                               {"cpu_seconds", rounded(denoised.cpu_seconds)}});
      }
    }
  return report;
}

}  // namespace lippmann::bench
