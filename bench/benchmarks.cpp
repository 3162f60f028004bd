#include "bench/benchmarks.hpp"

#include "lippmann/core/error.hpp"

namespace lippmann::bench {

void begin_step(const Request& request, const Context& context, std::string_view what) {
  if (context.cancelled) throw Error("bench", "was stopped before its end");
  if (request.say) request.say(what);
}

const std::vector<Benchmark>& benchmarks() {
  static const std::vector<Benchmark> all{
      {"denoise",
       "path-traced frames as traced and denoised: PSNR, flicker from view to view, time",
       measure_denoise,
       {"--scene", "--quick", "--reference-spp", "--references"}},
      {"estimates",
       "how often the PSNR interval that path-traced frames report contains the true PSNR",
       measure_estimates,
       {"--scene", "--frames", "--views", "--view-pixels", "--quick", "--reference-spp", "--references"}},
      {"lamps",
       "path-traced frames below 10 to 10,000 lamps: CPU time, PSNR, and CPU time at equal PSNR",
       measure_lamps,
       {"--quick", "--reference-spp"}},
      {"light",
       "denoised frames of 16 samples a pixel beside plain paths of 64: time, error, mean light, flicker",
       measure_light,
       {"--scene", "--list", "--frames", "--views", "--view-pixels", "--quick", "--pictures", "--reference-spp",
        "--references"}},
      {"native",
       "the own frame of a slanted panel beside one interlaced from 48 views, against 512 views",
       measure_native,
       {"--scene"}},
      {"paper",
       "the tables of the paper: interpolated animations beside traced ones, pixel-tracing styles",
       measure_paper,
       {"--scene", "--tachyon-scenes", "--frames", "--large", "--plot", "--csv"}},
      {"png", "CPU time and size of a PNG by strategy, filter and level", measure_png},
      {"rays", "rays per second of our passes beside bare Embree, by ray order and scene", measure_rays, {"--scene"}},
      {"replay",
       "eye views through the arrays beside direct views, by depth; whether depth is the right way round",
       measure_replay,
       {"--scene"}},
      {"reuse",
       "what reuse between frames saves of full tracing, and how near the pictures are",
       measure_reuse,
       {"--scene", "--tachyon-scenes", "--frames", "--large"}},
      {"spheres", "rays per second against our spheres beside Embree's own sphere points", measure_spheres, {"--scene"}},
      {"splats",
       "a quilt of 48 views of 100,000 and of a million splats: CPU time, and beside nearest hits of triangles",
       measure_splats,
       {"--view-pixels", "--quick"}},
      {"tachyon",
       "CPU time per pixel beside the program tachyon, on its own scenes",
       measure_tachyon,
       {"--scene", "--tachyon-scenes"}},
  };
  return all;
}

}  // namespace lippmann::bench
