// Errors at the eye (`--quality-at eye`): the PSNR of what an eye sees through lenses that mix neighbours, as frames of shared
// light are told to have it, beside what replay shows. Every frame and two references of many samples are looked at from the
// eye of every view.
#include <fmt/core.h>

#include <cmath>
#include <memory>

#include "bench/benchmarks.hpp"
#include "bench/light_figures.hpp"
#include "bench/rounded_json.hpp"
#include "frames/frame_maker.hpp"
#include "job/job_stage.hpp"
#include "job/reuse_params.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/image/encode.hpp"
#include "lippmann/image/metrics.hpp"
#include "lippmann/optics/crosstalk.hpp"
#include "lippmann/optics/view_cameras.hpp"
#include "lippmann/optics/viewing.hpp"
#include "lippmann/replay/eye_view.hpp"

namespace lippmann::bench {
namespace {

constexpr int kEyeReferenceSamples = 512, kQuickEyeReferenceSamples = 64, kEyeSamples = 64, kEyeFrames = 8;
/// What frames of the rows with a floor are to reach.
constexpr double kEyeFloorDb = 38.0;
const std::vector<std::string> kEyeScenes{"room", "teapot", "small-balls", "tree"};

/// Told to be within half a decibel.
constexpr double kEyeCloseDb = 0.5;

struct EyeCase {
  const char* crosstalk;  ///< what each neighbour is of the picture
  QualityAt goal;
  bool has_floor;  ///< --min-psnr in place of --spp
};
constexpr EyeCase kEyeCases[] = {{"10%", QualityAt::kPixel, false},
                                 {"20%", QualityAt::kPixel, false},
                                 {"10%", QualityAt::kEye, false},
                                 {"10%", QualityAt::kPixel, true},
                                 {"10%", QualityAt::kEye, true}};

RenderParams eye_params(const std::string& scene, const Request& request) {
  const int pixels = request.view_pixels > 0 ? request.view_pixels : request.quick ? 24 : 128;
  RenderParams params;
  params.scene.name = scene;
  params.optics.kind = OpticsKind::kMultiview;
  params.optics.views = {8, 1};
  params.optics.size = {8 * pixels, pixels};
  params.optics.view_angle_deg = 20.0f;
  params.sampling.integrator = Integrator::kPath;
  params.sampling.spp = request.quick ? 16 : kEyeSamples;
  return with_scene_defaults(params);
}

/// What the eyes of all views see, one picture after the other.
Frames seen_by_all(const Image& film, const Optics& optics, double crosstalk_px, const ThreadPool& pool) {
  const RenderedPanel panel{optics, film};
  const ViewCameras cameras = view_cameras(optics).value();
  Frames seen;
  for (const Vec2d& eye : cameras.eyes_mm) {
    EyeView view;
    view.eye_mm = {eye, cameras.distance_mm}, view.crosstalk_px = crosstalk_px;
    seen.push_back(to_codes(eye_view(panel, view, pool), Encoding::kSrgb));
  }
  return seen;
}

struct TrueErrors {
  double pixels = 0.0, at_eye = 0.0;  ///< in codes squared
};

/// Errors of frames, told and true.
struct EyeFigures {
  double told = 0.0, truth = 0.0, most_db = 0.0;
  int close = 0, held = 0;

  void add(double told_db, double at_least_db, double true_db) {
    told += std::pow(10.0, -0.1 * told_db), truth += std::pow(10.0, -0.1 * true_db);
    most_db = std::max(most_db, std::abs(told_db - true_db));
    close += std::abs(told_db - true_db) <= kEyeCloseDb ? 1 : 0, held += true_db >= at_least_db ? 1 : 0;
  }
  static double mean_db(double sum, int frames) { return -10.0 * std::log10(sum / frames); }
};

class EyeBench {
 public:
  EyeBench(std::string scene, const Request& request, const Context& context)
      : scene_(std::move(scene)),
        request_(request),
        context_(context),
        pool_(resolved_threads(context)),
        params_(eye_params(scene_, request)),
        stage_(params_, pool_, context),
        frames_(request.frames > 0 ? request.frames
                : request.quick    ? 2
                                   : kEyeFrames) {
    for (int frame = 0; frame < frames_; ++frame) add_references(frame);
  }

  nlohmann::ordered_json row(const EyeCase& wanted) {
    begin_step(request_, context_, fmt::format("eye: {}, {}", scene_, wanted.crosstalk));
    const double sigma = read_crosstalk(wanted.crosstalk, "crosstalk");
    const std::unique_ptr<FrameMaker> maker = make_frame_maker(stage_, made_as(wanted, sigma), pool_, context_);
    EyeFigures pixels, at_eye;
    double rays = 0.0;
    for (int frame = 0; frame < frames_; ++frame) {
      const RenderedFrame made = maker->make(frame);
      if (context_.cancelled) throw Error("bench", "was stopped before its end");
      const TrueErrors truth = true_errors(frame, made.pictures.film, sigma);
      const FrameReport& report = made.report;
      pixels.add(*report.estimated_psnr_db, *report.psnr_at_least_db, psnr_db(truth.pixels));
      at_eye.add(*report.estimated_psnr_at_eye_db, *report.psnr_at_eye_at_least_db, psnr_db(truth.at_eye));
      rays += static_cast<double>(report.rays.total());
    }
    return json_of(wanted, pixels, at_eye, rays);
  }

 private:
  void add_references(int frame) {
    begin_step(request_, context_, fmt::format("eye: {}, reference of frame {}", scene_, frame));
    Sampling sampling = params_.sampling;
    sampling.spp = request_.reference_spp > 0 ? request_.reference_spp
                   : request_.quick           ? kQuickEyeReferenceSamples
                                              : kEyeReferenceSamples;
    for (std::uint32_t seed = 1; seed <= 2; ++seed) {
      sampling.seed = params_.sampling.seed + seed;
      references_.push_back(render_frame(stage_, sampling, frame, pool_, context_).pictures.film);
    }
  }

  FrameParams made_as(const EyeCase& wanted, double sigma) const {
    RenderParams params = params_;
    params.reuse.choice = ReuseChoice::kLight, params.reuse.quality_at = wanted.goal;
    if (wanted.has_floor) params.reuse.min_psnr_db = kEyeFloorDb;
    FrameParams made = frame_params(params);
    std::get<ShareLight>(made.reuse).crosstalk_px = sigma;
    return made;
  }

  TrueErrors true_errors(int frame, const Image& film, double sigma) const {
    const auto of = [&](double crosstalk_px) {
      const auto seen = [&](const Image& of_film) { return seen_by_all(of_film, stage_.placed.optics, crosstalk_px, pool_); };
      const std::size_t first = 2 * static_cast<std::size_t>(frame);
      const Frames made = seen(film), one = seen(references_[first]), other = seen(references_[first + 1]);
      References both;
      for (std::size_t eye = 0; eye < made.size(); ++eye) both.push_back({one[eye], other[eye]});
      return mean_squared_error(both, made);
    };
    return {of(0.0), of(sigma)};
  }

  nlohmann::ordered_json json_of(const EyeCase& wanted, const EyeFigures& pixels, const EyeFigures& at_eye, double rays) const {
    const auto mean = [&](double sum) { return rounded(EyeFigures::mean_db(sum, frames_)); };
    return {{"scene", scene_},
            {"crosstalk", wanted.crosstalk},
            {"quality_at", wanted.goal == QualityAt::kEye ? "eye" : "pixel"},
            {"floor_db", wanted.has_floor ? nlohmann::ordered_json(kEyeFloorDb) : nlohmann::ordered_json(nullptr)},
            {"frames", frames_},
            {"mrays_per_frame", rounded(1e-6 * rays / frames_)},
            {"told_db", mean(pixels.told)},
            {"true_db", mean(pixels.truth)},
            {"close_frames", pixels.close},
            {"told_at_eye_db", mean(at_eye.told)},
            {"true_at_eye_db", mean(at_eye.truth)},
            {"close_at_eye", at_eye.close},
            {"bounds_held_at_eye", at_eye.held},
            {"most_at_eye_db", rounded(at_eye.most_db)}};
  }

  std::string scene_;
  const Request& request_;
  const Context& context_;
  ThreadPool pool_;
  RenderParams params_;
  JobStage stage_;
  int frames_;
  std::vector<Image> references_;  ///< two of each frame
};

}  // namespace

Report measure_eye(const Request& request, const Context& context) {
  Report report;
  for (const std::string& scene : request.scenes.empty() ? kEyeScenes : request.scenes) {
    EyeBench bench(scene, request, context);
    for (const EyeCase& wanted : kEyeCases) report.rows.push_back(bench.row(wanted)), ++report.passed_checks;
  }
  return report;
}

}  // namespace lippmann::bench
