// Compares two ways to make the native frame of a calibrated slanted panel: one ray per sub-pixel, and interlacing a quilt of
// 48 views. The reference frame is interlaced from 512 views, each with as many pixels as the panel.
//
// The panel is an eighth of a Looking Glass Portrait in width and height.
#include <fmt/core.h>

#include "bench/benchmarks.hpp"
#include "bench/scenes.hpp"
#include "bench/timing.hpp"
#include "frames/frame.hpp"
#include "job/job_stage.hpp"
#include "layout/sub_pixels.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/display/load_display.hpp"
#include "lippmann/image/encode.hpp"
#include "lippmann/image/metrics.hpp"
#include "lippmann/layout/arrangement.hpp"
#include "lippmann/layout/interlace.hpp"

namespace lippmann::bench {
namespace {

constexpr int kShrink = 8;
constexpr double kLeastGain = 3.0;

Display small_portrait() {
  Display display = load_display("looking-glass-portrait");
  display.pixels /= kShrink;
  display.quilt->width /= kShrink, display.quilt->height /= kShrink;
  return display;
}

Display with_many_views(Display display) {
  display.quilt->columns = 32, display.quilt->rows = 16;
  display.quilt->width = 32 * display.pixels.x, display.quilt->height = 16 * display.pixels.y;
  return display;
}

class NativeBench {
 public:
  NativeBench(const BenchScene& scene, const ThreadPool& pool, const Context& context)
      : scene_(scene), pool_(pool), context_(context), stage_(ResolvedJob(scene.params), pool, context) {}

  Image render(const Optics& optics, double& seconds) {
    stage_.placed.optics = optics;
    stage_.placed.units_per_mm = scene_units_per_mm(stage_.array, window_size_mm(optics).y);
    stage_.placed.optics.z_front_mm = stage_.array.viewing_distance / stage_.placed.units_per_mm;
    RenderedFrame frame = render_frame(stage_, scene_.params.sampling, scene_.frame, pool_, context_);
    seconds += frame.report.cpu_seconds;
    return std::move(frame.pictures.film);
  }

  Image8 native(const Display& display, double& seconds) {
    return to_codes(join_sub_pixels(render(native_optics(display), seconds)), stage_.scene.encoding);
  }

  Image8 interlaced(const Display& display, ViewFilter filter, double& seconds) {
    const DisplayQuilt& quilt = *display.quilt;
    const ViewGrid tiles{quilt.columns, quilt.rows}, views{tiles.count(), 1};
    const Arrangement to_stack({LayoutKind::kQuilt, views, tiles}, {LayoutKind::kStack, views, {}}, {quilt.width, quilt.height},
                               "quilt");
    LightField field;
    field.stack = to_codes(to_stack.apply(render(*quilt_optics(display), seconds)), stage_.scene.encoding);
    field.grid = views;
    field.view_size = to_stack.view_size();
    return std::get<Image8>(interlace(field, display, {filter}, pool_));
  }

 private:
  const BenchScene& scene_;
  const ThreadPool& pool_;
  const Context& context_;
  JobStage stage_;
};

}  // namespace

Report measure_native(const Request& request, const Context& context) {
  Report report;
  const ThreadPool pool(resolved_threads(context));
  const Display display = small_portrait(), reference_display = with_many_views(display);
  Request wanted = request;
  if (wanted.scenes.empty()) wanted.scenes = {"teapot", "room"};
  for (const BenchScene& scene : bench_scenes(wanted, context)) {
    begin_step(request, context, fmt::format("native: {}", scene.name));
    NativeBench bench(scene, pool, context);
    double ignored = 0.0, native_seconds = 0.0, quilt_seconds = 0.0;
    const Image8 reference = bench.interlaced(reference_display, ViewFilter::kLinear, ignored);
    const double native = measure_difference(reference, bench.native(display, native_seconds)).psnr_db;
    const double nearest =
        measure_difference(reference, bench.interlaced(display, ViewFilter::kNearest, quilt_seconds)).psnr_db;
    const double linear = measure_difference(reference, bench.interlaced(display, ViewFilter::kLinear, ignored)).psnr_db;
    const double gain = native - std::max(nearest, linear);
    if (gain < kLeastGain) throw Error("native", scene.name + ": the native frame is not sharper than the interlaced one");
    ++report.passed_checks;
    report.rows.push_back({{"scene", scene.name},
                           {"native_psnr_db", rounded(native)},
                           {"interlaced_nearest_psnr_db", rounded(nearest)},
                           {"interlaced_linear_psnr_db", rounded(linear)},
                           {"gain_db", rounded(gain)},
                           {"time_ratio", rounded(native_seconds / quilt_seconds)}});
  }
  return report;
}

}  // namespace lippmann::bench
