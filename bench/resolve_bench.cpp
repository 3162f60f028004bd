// What pooling the samples of neighbouring views is worth, and what it costs: views of 1, 2 and 4 samples per pixel, resolved
// from their own samples alone and from those of their neighbours (view_resolver.hpp), held to references of many samples.
// Whitted's shading, whose samples have no noise of their own; nothing is adaptive.
#include <fmt/core.h>

#include <cmath>

#include "bench/benchmarks.hpp"
#include "bench/timing.hpp"
#include "bench/view_resolver.hpp"
#include "core/random.hpp"
#include "job/job_stage.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/image/encode.hpp"
#include "lippmann/image/metrics.hpp"
#include "lippmann/optics/view_cameras.hpp"
#include "trace/first_hits.hpp"
#include "trace/trace_frame.hpp"

namespace lippmann::bench {
namespace {

constexpr int kResolveViewPixels = 128, kQuickResolveViewPixels = 32;
/// Samples across and down a pixel of references.
constexpr int kResolveReferenceSide = 12, kQuickResolveReferenceSide = 4;
/// What samples of the view alone are compared with: as many a pixel.
constexpr int kMostOwnSamples = 32;
/// Shifts from view to the next that differ by less, in pixels, are those of one surface.
constexpr float kSameSurfacePx = 0.15f;
/// Of a pixel of each view.
constexpr int kPooledSamples[] = {1, 2, 4};
constexpr std::pair<Resolver, const char*> kHows[] = {
    {Resolver::kCount, "count"}, {Resolver::kVoronoi, "voronoi"}, {Resolver::kLines, "lines"}};
const std::vector<std::string> kResolvedScenes{"room", "teapot", "small-balls", "tree"};

struct ViewRow {
  int views;
  float cone_deg;
  int reach;  ///< neighbours on each side whose samples are pooled
};
constexpr ViewRow kViewRows[] = {{8, 20.0f, 3}, {48, 40.0f, 7}};

RenderParams resolve_params(const std::string& scene, const ViewRow& row, int pixels) {
  RenderParams params;
  params.scene.name = scene;
  params.optics.kind = OpticsKind::kMultiview;
  params.optics.views = {row.views, 1};
  params.optics.size = {row.views * pixels, pixels};
  params.optics.view_angle_deg = row.cone_deg;
  params.sampling.integrator = Integrator::kWhitted;
  return with_scene_defaults(params);
}

/// Whether light that leaves a surface depends on where it goes.
bool depends_on_view(const Material& material) {
  if (const auto* phong = std::get_if<PhongSurface>(&material.surface))
    return phong->mirror > 0.0f || phong->opacity < 1.0f || phong->highlight > 0.0f;
  if (const auto* physical = std::get_if<MetallicRoughness>(&material.surface))
    return physical->metallic > 0.5f || physical->roughness < 0.4f || physical->transmission > 0.0f;
  return true;
}

/// A number in [0, 1) for a view and a sample, evenly spread over views and samples together (additive recurrence of the
/// plastic number: M. Roberts, "The unreasonable effectiveness of quasirandom sequences", 2018), and moved at random by pixel.
float stratified(int index, int axis, std::uint32_t pixel) {
  constexpr double kSteps[] = {0.7548776662466927, 0.5698402909980532};
  const double moved = static_cast<double>(unit_float(hash(pixel, static_cast<std::uint32_t>(axis), 0x72657370u)));
  const double u = moved + kSteps[axis] * index;
  return std::min(static_cast<float>(u - std::floor(u)), 1.0f - 0x1p-12f);
}

class ResolveStage {
 public:
  ResolveStage(const std::string& scene, const ViewRow& row, int pixels, const Context& context)
      : pixels_(pixels),
        context_(context),
        pool_(1),
        params_(resolve_params(scene, row, pixels)),
        stage_(params_, pool_, context),
        frame_(std::min(20, stage_.scene.timeline.frame_count - 1)),
        moment_(stage_.moment_at(frame_)),
        cameras_(view_cameras(stage_.placed.optics).value()) {
    stage_.device.update(moment_.resolved, pool_);
  }

  /// A sample of every pixel of a view. Runs of numbers are spread evenly, be they of one view or of several.
  ViewSamples samples_of(int view, int number) {
    const auto pixel_count = static_cast<std::size_t>(pixels_) * static_cast<std::size_t>(pixels_);
    ViewSamples samples{.width = pixels_, .height = pixels_, .eye_mm = cameras_.eyes_mm[static_cast<std::size_t>(view)].x};
    for (std::size_t i = 0; i < pixel_count; ++i) {
      const auto pixel = static_cast<std::uint32_t>(i);
      samples.x.push_back(static_cast<float>(i % static_cast<std::size_t>(pixels_)) + stratified(number, 0, pixel));
      samples.y.push_back(static_cast<float>(i / static_cast<std::size_t>(pixels_)) + stratified(number, 1, pixel));
    }
    FrameAovs aovs;
    aovs.want(Aov::kDepth), aovs.want(Aov::kId);
    const Optics optics = rays_of(view, pixels_, pixels_, [&](std::size_t i) { return Vec2f(samples.x[i], samples.y[i]); });
    samples.rgb = trace(optics, &aovs).data;
    for (std::size_t i = 0; i < pixel_count; ++i) {
      const auto id = static_cast<std::int32_t>(aovs[Aov::kId].data[i]);
      samples.surface.push_back(id);
      samples.own.push_back(id >= 0 && depends_on_view(material_of(id)) ? 1 : 0);
      samples.shift.push_back(shift_of(aovs[Aov::kDepth].data[i]));
    }
    return samples;
  }

  /// The mean over side x side samples of every pixel.
  Image reference_of(int view, int side) {
    const int wide = pixels_ * side;
    const auto place = [&](std::size_t i) {
      const std::size_t x = i % static_cast<std::size_t>(wide), y = i / static_cast<std::size_t>(wide);
      const auto number = static_cast<std::uint32_t>(i);
      return (Vec2f(x, y) + Vec2f(unit_float(hash(number, 1u)), unit_float(hash(number, 2u)))) / static_cast<float>(side);
    };
    const Image fine = trace(rays_of(view, wide, wide, place), nullptr);
    Image mean(pixels_, pixels_, 3);
    for (int y = 0; y < wide; ++y)
      for (int x = 0; x < wide; ++x)
        for (int c = 0; c < 3; ++c) mean.pixel(x / side, y / side)[c] += fine.pixel(x, y)[c] / static_cast<float>(side * side);
    return mean;
  }

  float same_surface() const { return kSameSurfacePx / static_cast<float>(cameras_.eyes_mm[1].x - cameras_.eyes_mm[0].x); }
  double seconds_per_sample() const { return traced_seconds_ / static_cast<double>(traced_); }

 private:
  const Material& material_of(std::int32_t instance) const {
    const auto material = stage_.scene.instances[static_cast<std::size_t>(instance)].material;
    return stage_.scene.materials[static_cast<std::size_t>(material)];
  }

  /// Where nothing is hit the depth is minus infinity, and the point stays in its direction.
  float shift_of(float depth_mm) const {
    const double from_eye = cameras_.distance_mm - static_cast<double>(depth_mm);
    return static_cast<float>((1.0 - cameras_.distance_mm / from_eye) / cameras_.pixel_mm.x);
  }

  /// A table of the rays of a view at places within it, in its pixels.
  template <class PlaceOf>
  Optics rays_of(int view, int width, int height, const PlaceOf& place_of) const {
    auto rays = std::make_shared<std::vector<Ray>>();
    const Vec2f origin(static_cast<float>(view * pixels_), 0.0f);
    for (std::size_t i = 0; i < static_cast<std::size_t>(width) * static_cast<std::size_t>(height); ++i)
      rays->push_back(ray_of_pixel(stage_.placed.optics, origin + place_of(i)));
    Optics optics = stage_.placed.optics;
    optics.panel.width = width, optics.panel.height = height;
    optics.model = RayTable{std::move(rays), 1, 0.0f};
    return optics;
  }

  Image trace(const Optics& optics, FrameAovs* aovs) {
    const Shot shot{stage_.device, optics, moment_.world_from_display};
    TraceParams params;
    params.max_depth = stage_.scene.max_depth;
    Image film;
    pool_.run([&] {
      traced_seconds_ += seconds([&] { trace_frame(shot, params, {pool_, context_}, {film}); });
      if (aovs) find_first_hits(shot, params.order, nullptr, pool_, *aovs);
    });
    traced_ += film.data.size() / 3;
    return film;
  }

  int pixels_;
  const Context& context_;
  ThreadPool pool_;
  RenderParams params_;
  JobStage stage_;
  int frame_;
  Moment moment_;
  ViewCameras cameras_;
  double traced_seconds_ = 0.0;
  std::size_t traced_ = 0;
};

double psnr_between(const Image& reference, const Image& picture) {
  return measure_difference(to_codes(reference, Encoding::kSrgb), to_codes(picture, Encoding::kSrgb)).psnr_db;
}

/// The PSNR of so many samples of the view alone, from those of 1, 2, 4 ... samples: on a straight line in their logarithm.
double own_psnr_at(const std::vector<double>& by_doubling, double samples) {
  const double place = std::clamp(std::log2(samples), 0.0, static_cast<double>(by_doubling.size() - 1));
  const auto below = std::min(static_cast<std::size_t>(place), by_doubling.size() - 2);
  return by_doubling[below] + (place - static_cast<double>(below)) * (by_doubling[below + 1] - by_doubling[below]);
}

/// By 1, 2, 4 ... kMostOwnSamples samples.
std::vector<double> own_psnrs(ResolveStage& stage, int view, const Image& reference) {
  Image sum(reference.width, reference.height, 3);
  std::vector<double> psnrs;
  for (int set = 0; set < kMostOwnSamples; ++set) {
    const std::vector<float> light = stage.samples_of(view, view + set).rgb;
    for (std::size_t i = 0; i < light.size(); ++i) sum.data[i] += light[i];
    const int samples = set + 1;
    if ((samples & set) != 0) continue;
    Image mean = sum;
    for (float& v : mean.data) v /= static_cast<float>(samples);
    psnrs.push_back(psnr_between(reference, mean));
  }
  return psnrs;
}

/// So many samples a pixel of the views around one.
std::vector<ViewSamples> samples_around(ResolveStage& stage, int view, int reach, int samples) {
  std::vector<ViewSamples> around;
  for (int v = view - reach; v <= view + reach; ++v)
    for (int k = 0; k < samples; ++k) around.push_back(stage.samples_of(v, v * samples + k));
  return around;
}

void add_resolve_rows(const std::string& scene, const ViewRow& row, const Request& request, const Context& context,
                      nlohmann::ordered_json& rows) {
  const int pixels = request.view_pixels > 0 ? request.view_pixels
                     : request.quick         ? kQuickResolveViewPixels
                                             : kResolveViewPixels;
  ResolveStage stage(scene, row, pixels, context);
  const int view = row.views / 2;
  const Image reference = stage.reference_of(view, request.quick ? kQuickResolveReferenceSide : kResolveReferenceSide);
  const std::vector<double> own = own_psnrs(stage, view, reference);
  const double microseconds = 1e6 / (static_cast<double>(pixels) * pixels);
  for (const int samples : kPooledSamples) {
    const std::vector<ViewSamples> around = samples_around(stage, view, row.reach, samples);
    const int target = row.reach * samples, reach = static_cast<int>(around.size());
    const double sample_us = 1e6 * stage.seconds_per_sample();
    nlohmann::ordered_json json{
        {"scene", scene}, {"views", row.views}, {"samples", samples}, {"sample_us", rounded(sample_us)}};
    for (std::size_t i = 0; i < own.size(); ++i) json[fmt::format("own_{}_db", 1 << i)] = rounded(own[i]);
    const auto pooled = [&](Resolver how, ResolveTimes& times) {
      resolve_view(around, target, reach, stage.same_surface(), how);  // warms up
      return resolve_view(around, target, reach, stage.same_surface(), how, &times);
    };
    ResolveTimes unused;
    if (samples == 1 && std::abs(psnr_between(reference, pooled(Resolver::kOwn, unused)) - own[0]) > 1e-9)
      throw Error("bench resolve", scene + ": a view's own samples are not what was traced");
    for (const auto& [how, name] : kHows) {
      ResolveTimes times;
      const double psnr = psnr_between(reference, pooled(how, times));
      const double us = microseconds * (times.land_seconds + times.resolve_seconds);
      json[fmt::format("{}_land_us", name)] = rounded(microseconds * times.land_seconds);
      json[fmt::format("{}_us", name)] = rounded(us);
      json[fmt::format("{}_db", name)] = rounded(psnr);
      json[fmt::format("{}_gain_db", name)] = rounded(psnr - own_psnr_at(own, samples + us / sample_us));
    }
    rows.push_back(std::move(json));
  }
}

}  // namespace

Report measure_resolve(const Request& request, const Context& context) {
  Report report;
  for (const std::string& scene : request.scenes.empty() ? kResolvedScenes : request.scenes)
    for (const ViewRow& row : kViewRows) {
      begin_step(request, context, fmt::format("resolve: {}, {} views", scene, row.views));
      add_resolve_rows(scene, row, request, context, report.rows);
      ++report.passed_checks;
    }
  return report;
}

}  // namespace lippmann::bench
