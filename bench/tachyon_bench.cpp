// Compares the CPU time per pixel of our Whitted frames with that of the program tachyon, for tachyon's own scenes and
// cameras on one thread. The time of tachyon is the difference between a large and a tiny picture, which excludes
// reading the scene. Two of our frames are measured: a single view of the same size, and the integral image around the
// same camera.
#include <fmt/core.h>

#include <filesystem>
#include <string>

#include "bench/benchmarks.hpp"
#include "bench/program.hpp"
#include "bench/scenes.hpp"
#include "bench/timing.hpp"
#include "frames/frame.hpp"
#include "job/job_stage.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann::bench {
namespace {

constexpr int kTachyonRepetitions = 5;
constexpr int kTachyonSize = 512, kTachyonTinySize = 8;

double tachyon_seconds(const std::filesystem::path& scene, int size) {
  const std::string pixels = std::to_string(size);
  return cpu_seconds_of(
      {"tachyon", scene.filename().string(), "-res", pixels, pixels, "-aasamples", "0", "-numthreads", "1", "-nosave"},
      scene.parent_path());
}

class OurFrame {
 public:
  OurFrame(RenderParams params, OpticsKind optics, const ThreadPool& pool, const Context& context)
      : params_(with_optics(std::move(params), optics)),
        stage_(ResolvedJob(params_), pool, context),
        pool_(pool),
        context_(context) {}

  double seconds() {
    return second_run([&] { render_frame(stage_, params_.sampling, 0, pool_, context_); });
  }

 private:
  static RenderParams with_optics(RenderParams params, OpticsKind optics) {
    params.optics.kind = optics;
    if (optics == OpticsKind::kSingle) params.optics.size = {kTachyonSize, kTachyonSize};
    return params;
  }

  RenderParams params_;
  JobStage stage_;
  const ThreadPool& pool_;
  const Context& context_;
};

nlohmann::ordered_json measure_scene(const BenchScene& setup, const ThreadPool& pool, const Context& context) {
  OurFrame single(setup.params, OpticsKind::kSingle, pool, context);
  OurFrame integral(setup.params, OpticsKind::kLenticular, pool, context);
  std::vector<double> theirs, ours_single, ours_integral, single_ratios, integral_ratios;
  for (int repetition = 0; repetition < kTachyonRepetitions; ++repetition) {
    theirs.push_back(tachyon_seconds(setup.params.scene.name, kTachyonSize) -
                     tachyon_seconds(setup.params.scene.name, kTachyonTinySize));
    ours_single.push_back(single.seconds());
    ours_integral.push_back(integral.seconds());
    single_ratios.push_back(theirs.back() / ours_single.back());
    integral_ratios.push_back(theirs.back() / ours_integral.back());
  }
  const auto ns_per_pixel = [](const std::vector<double>& times) {
    return rounded(1e9 * median(times) / (kTachyonSize * kTachyonSize));
  };
  return {{"scene", setup.name},
          {"tachyon_ns_per_pixel", ns_per_pixel(theirs)},
          {"single_ns_per_pixel", ns_per_pixel(ours_single)},
          {"integral_ns_per_pixel", ns_per_pixel(ours_integral)},
          {"single_ratio", rounded(median(single_ratios))},
          {"integral_ratio", rounded(median(integral_ratios))}};
}

}  // namespace

Report measure_tachyon(const Request& request, const Context& context) {
  const std::vector<BenchScene> scenes = tachyon_scenes(request);
  if (scenes.empty())
    throw Error(request.tachyon_scenes, "contains none of teapot.dat, room.dat and smallballs.dat",
                "a folder with Tachyon's scenes (--tachyon-scenes DIR); Debian has them in the package tachyon-doc");
  Report report;
  const ThreadPool pool(1);
  pool.run([&] {
    for (const BenchScene& setup : scenes) {
      begin_step(request, context, fmt::format("tachyon: {}", setup.name));
      report.rows.push_back(measure_scene(setup, pool, context));
    }
  });
  return report;
}

}  // namespace lippmann::bench
