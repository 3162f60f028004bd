// Measures path-traced frames at 4, 16 and 64 samples per pixel, with and without denoising: PSNR against converged frames,
// flicker between views, and CPU time.
#include <fmt/core.h>

#include "bench/benchmarks.hpp"
#include "bench/light_run.hpp"
#include "bench/scenes.hpp"
#include "bench/timing.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann::bench {
namespace {

constexpr int kDenoiseSamples[] = {4, 16, 64};
constexpr int kQuickDenoiseReferenceSamples = 64;

LightCase denoise_case(const BenchScene& scene, bool quilt, const Request& request) {
  LightCase row{scene.name, scene.params, {}, scene.frame};
  row.params.sampling.integrator = Integrator::kPath;
  OpticsParams& optics = row.params.optics;
  const int view = request.quick ? 16 : 128;
  if (quilt) {
    optics.kind = OpticsKind::kMultiview;
    optics.views = {8, 1}, optics.size = {8 * view, view};
    optics.view_angle_deg = 20.0f;
  } else if (request.quick) {
    optics.lenses = {16, 16};
  }
  if (request.quick) row.reference_spp = kQuickDenoiseReferenceSamples;
  if (request.reference_spp > 0) row.reference_spp = request.reference_spp;
  return row;
}

}  // namespace

Report measure_denoise(const Request& request, const Context& context) {
  Report report;
  Request wanted = request;
  if (wanted.scenes.empty()) wanted.scenes = {"teapot", "room", "tree"};
  for (const BenchScene& scene : bench_scenes(wanted, context))
    for (const bool quilt : {false, true}) {
      const LightCase row = denoise_case(scene, quilt, request);
      std::vector<Sampling> ways;
      for (const int spp : kDenoiseSamples)
        for (const Denoise denoise : {Denoise::kNone, Denoise::kAuto})
          ways.push_back(with_samples(row.params.sampling, spp, denoise));
      const std::vector<LightFigures> measured = LightBench(row, request, context).measure(ways);
      for (std::size_t w = 0; w < ways.size(); w += 2) {
        const LightFigures &noisy = measured[w], &denoised = measured[w + 1];
        const int spp = ways[w].spp;
        if (spp <= 16 && !request.quick && !(denoised.psnr_db > noisy.psnr_db))
          throw Error("denoise", fmt::format("denoising {} at {} samples lowers the PSNR", scene.name, spp));
        ++report.passed_checks;
        report.rows.push_back({{"scene", scene.name},
                               {"picture", quilt ? "quilt" : "integral"},
                               {"spp", spp},
                               {"noisy_psnr_db", rounded(noisy.psnr_db)},
                               {"psnr_db", rounded(denoised.psnr_db)},
                               {"noisy_flicker", rounded(noisy.view_flicker)},
                               {"flicker", rounded(denoised.view_flicker)},
                               {"noisy_cpu_seconds", rounded(noisy.cpu_seconds)},
                               {"cpu_seconds", rounded(denoised.cpu_seconds)}});
      }
    }
  return report;
}

}  // namespace lippmann::bench
