// Compares two pictures for each of 25 eyes inside the viewing zone: what the eye sees of the built-in room through a lens
// array, and a pinhole view rendered for this eye. PSNR is computed for all pixels and for four ranges of depth. The ranges are
// fractions of the depth budget, which is the gap times the number of pixels per lens. Beyond this depth, a pixel is wider than
// a lens.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "bench/benchmarks.hpp"
#include "bench/rounded_json.hpp"
#include "bench/scenes.hpp"
#include "bench/timing.hpp"
#include "frames/frame.hpp"
#include "job/job_stage.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/image/encode.hpp"
#include "lippmann/image/metrics.hpp"
#include "lippmann/optics/viewing.hpp"
#include "lippmann/replay/eye_view.hpp"
#include "replay/depth_order.hpp"
#include "replay/rotate_elemental.hpp"
#include "trace/first_hits.hpp"
#include "trace/trace_frame.hpp"

namespace lippmann::bench {
namespace {

/// number of eyes along each axis of the zone; with parallax along one axis only, kEyes * kEyes eyes lie along it
constexpr int kEyes = 5;
constexpr double kBaseline = 1.0 / 5;  ///< distance between two eyes as a fraction of the zone

/// One value for each range of depth: up to 1/4, up to 1/2, up to 1 of the depth budget, and beyond it.
using Layers = std::array<double, 4>;
constexpr Layers kLayerEnds{0.25, 0.5, 1.0, kInfinity};

/// The pinhole view of an eye. If n pixel columns are traced per lens, only every n-th column is kept.
struct DirectView {
  Image film, depth;
};

Image every_column(const Image& picture, int step) {
  Image columns(picture.width / step, picture.height, picture.channels);
  for (int y = 0; y < columns.height; ++y)
    for (int x = 0; x < columns.width; ++x)
      std::copy_n(picture.pixel(x * step + step / 2, y), picture.channels, columns.pixel(x, y));
  return columns;
}

class ReplayBench {
 public:
  ReplayBench(const RenderParams& params, int frame, const ThreadPool& pool, const Context& context)
      : pool_(pool), context_(context), stage_(ResolvedJob(params), pool, context), params_(params) {
    recorded_ = {stage_.placed.optics, render_frame(stage_, params.sampling, frame, pool, context).pictures.film};
    world_from_display_ = stage_.moment_at(frame).world_from_display;
    grid_ = lens_grid(optics());
    view_.size = grid_;
    eye_z_mm_ = default_eye_mm(optics()).z;
  }

  const Optics& optics() const { return recorded_.optics; }

  /// `across` and `along` are positions in the zone from 0 to 1, counted from the left and from the lower end.
  Vec3d eye_at(double across, double along) const {
    const double up = parallax_of(optics()).along ? zone_x_mm(optics(), along, eye_z_mm_) : 0.0;
    return {zone_x_mm(optics(), across, eye_z_mm_), up, eye_z_mm_};
  }

  Image replayed(const RenderedPanel& panel, Vec3d eye_mm) const {
    EyeView view = view_;
    view.eye_mm = eye_mm;
    return eye_view(panel, view, pool_);
  }

  /// Returns the pinhole view with one sample at the centre of each lens. If a lens has an even number of pixels, its centre is
  /// between two pixels, so the samples are moved by half a pixel.
  DirectView direct(Vec3d eye_mm) const {
    const int per_lens =
        std::max(1, static_cast<int>(std::lround(static_cast<double>(grid_.y) / grid_.x * display_window(optics()).size.x /
                                                 display_window(optics()).size.y)));
    const Vec2i size(grid_.x * per_lens, grid_.y);
    Window window = display_window(optics());
    if (per_lens % 2 == 0) window.centre.x -= 0.5 * window.size.x / size.x;
    const Optics pinhole = pinhole_through_window(window, size, eye_mm);
    const Affine3f moved{Mat3f(1.0f), Vec3f(static_cast<float>(eye_mm.x), static_cast<float>(eye_mm.y), 0.0f)};
    Image film;
    FrameAovs aovs;
    aovs.want(Aov::kDepth);
    const TraceParams trace = trace_params(params_.sampling, stage_);
    trace_frame({stage_.device, pinhole, world_from_display_ * moved}, trace, {pool_, context_}, {film});
    find_first_hits({stage_.device, pinhole, world_from_display_ * moved}, trace.order, nullptr, pool_, aovs);
    return {every_column(film, per_lens), every_column(aovs[Aov::kDepth], per_lens)};
  }

  DepthOrder depth_order(const RenderedPanel& panel, const DirectView& truth, Vec3d eye_mm) const {
    const double step = zone_x_mm(optics(), 0.5 + kBaseline, eye_z_mm_);
    const double baseline = eye_mm.x > 0.0 ? -step : step;  // towards the middle, so that the second eye is inside the zone
    const Image view = replayed(panel, eye_mm), other = replayed(panel, eye_mm + Vec3d(baseline, 0.0, 0.0));
    return measure_depth_order(view, other, truth.depth, eye_z_mm_, baseline, display_window(optics()).size.x / grid_.x);
  }

  const RenderedPanel& recorded() const { return recorded_; }
  RenderedPanel pseudoscopic() const {
    return {optics(), apply(rotated_elemental_images(optics(), "replay"), recorded_.picture)};
  }

 private:
  const ThreadPool& pool_;
  const Context& context_;
  JobStage stage_;
  RenderParams params_;
  RenderedPanel recorded_;
  Affine3f world_from_display_;
  Vec2i grid_{0, 0};
  EyeView view_;
  double eye_z_mm_ = 0.0;
};

/// Returns the PSNR of codes over the pixels selected by `wanted`, or infinity if no pixel is selected.
template <class Wanted>
double psnr_where(const Image8& a, const Image8& b, const Wanted& wanted) {
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) {
    if (!wanted(i / 3)) continue;
    const double d = a.rgb[i] - b.rgb[i];
    sum += d * d, ++count;
  }
  return count > 0 ? psnr_db(sum / static_cast<double>(count)) : kInfinity;
}

nlohmann::ordered_json row_of(const std::string& name, const ReplayBench& bench, Vec3d eye, const DirectView& truth,
                              const DepthOrder& order) {
  const Image8 seen = to_codes(bench.replayed(bench.recorded(), eye), Encoding::kSrgb);
  const Image8 direct = to_codes(truth.film, Encoding::kSrgb);
  nlohmann::ordered_json row{{"optics", name}, {"eye_x_mm", rounded(eye.x)}, {"eye_y_mm", rounded(eye.y)}};
  row["psnr_db"] = rounded_or_null(psnr_where(seen, direct, [](std::size_t) { return true; }));
  const double budget = depth_budget_mm(bench.optics());
  const std::array<const char*, 4> names{"quarter_db", "half_db", "budget_db", "beyond_db"};
  double begin = 0.0;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const double first = begin * budget, last = kLayerEnds[i] * budget;
    row[names[i]] = rounded_or_null(psnr_where(seen, direct, [&](std::size_t pixel) {
      const double z = std::abs(truth.depth.data[pixel]);
      return z >= first && z < last;
    }));
    begin = kLayerEnds[i];
  }
  row["behind_order_db"] = rounded_or_null(order.behind_db), row["front_order_db"] = rounded_or_null(order.front_db);
  return row;
}

void check(bool holds, const std::string& what, Vec3d eye, Report& report) {
  if (!holds)
    throw Error("replay", what + " from the eye at x = " + std::to_string(eye.x) + ", y = " + std::to_string(eye.y) + " mm");
  ++report.passed_checks;
}

void measure(const std::string& name, const ReplayBench& bench, Report& report) {
  const RenderedPanel pseudoscopic = bench.pseudoscopic();
  const bool full = parallax_of(bench.optics()).along;
  for (int i = 0; i < kEyes * kEyes; ++i) {
    const double across = full ? (i % kEyes + 0.5) / kEyes : (i + 0.5) / (kEyes * kEyes);
    const double along = full ? (i / kEyes + 0.5) / kEyes : 0.5;
    const Vec3d eye = bench.eye_at(across, along);
    const DirectView truth = bench.direct(eye);
    const DepthOrder order = bench.depth_order(bench.recorded(), truth, eye);
    check(order.behind_db > 0.0 && order.front_db > 0.0, name + ": depth is inverted", eye, report);
    const DepthOrder inverted = bench.depth_order(pseudoscopic, truth, eye);
    check(inverted.behind_db < 0.0 && inverted.front_db < 0.0, name + ": the measure does not detect pseudoscopic pictures",
          eye, report);
    report.rows.push_back(row_of(name, bench, eye, truth, order));
  }
}

}  // namespace

Report measure_replay(const Request& request, const Context& context) {
  Report report;
  const ThreadPool pool(resolved_threads(context));
  for (const std::string& scene : request.scenes.empty() ? std::vector<std::string>{"room"} : request.scenes) {
    Request one = request;
    one.scenes = {scene};
    BenchScene setup = bench_scenes(one, context).front();
    begin_step(request, context, fmt::format("replay: {} lenticular", scene));
    measure(scene + " lenticular", ReplayBench(setup.params, setup.frame, pool, context), report);
    setup.params.optics.kind = OpticsKind::kMicrolens;
    setup.params.optics.lenses = {96, 96};
    begin_step(request, context, fmt::format("replay: {} microlens", scene));
    measure(scene + " microlens", ReplayBench(setup.params, setup.frame, pool, context), report);
  }
  return report;
}

}  // namespace lippmann::bench
