#include "render/frame_maker.hpp"

#include <fmt/format.h>

#include "core/printable.hpp"
#include "lippmann/core/error.hpp"
#include "render/denoised_frames.hpp"
#include "render/exact_frames.hpp"
#include "render/floored_frames.hpp"
#include "render/forward_frames.hpp"
#include "render/lit_frames.hpp"
#include "render/test_pattern.hpp"
#include "scene/deform.hpp"

namespace lippmann {
namespace {

class TracedFrames final : public FrameMaker {
 public:
  TracedFrames(Stage& stage, const FrameParams& params, const ThreadPool& pool, const Context& context)
      : stage_(stage), params_(params), pool_(pool), context_(context) {}

  RenderedFrame make(int frame) override { return render_frame(stage_, params_, frame, pool_, context_); }

 private:
  Stage& stage_;
  const FrameParams& params_;
  const ThreadPool& pool_;
  const Context& context_;
};

class PatternFrames final : public FrameMaker {
 public:
  PatternFrames(const Stage& stage, const ThreadPool& pool) : stage_(stage), pool_(pool) {}

  RenderedFrame make(int frame) override {
    const FrameClock clock(pool_);
    RenderedFrame rendered;
    rendered.report.frame = frame;
    rendered.pictures.film = test_pattern_film(stage_.placed.optics, pool_);
    clock.add_to(rendered.report);
    return rendered;
  }

 private:
  const Stage& stage_;
  const ThreadPool& pool_;
};

/// What is asked for needs whole paths, so that no light is shared although it would be by default.
void warn_of_whole_paths(const FrameParams& params, const Context& context) {
  if (!LitFrames::is_wanted(params) || LitFrames::serves(params)) return;
  context.warning("--aov direct and indirect are parts of whole paths: no light is shared by --reuse exact");
}

/// Points are carried from frame to frame with their nodes, which says nothing of meshes that change their shape.
void refuse_deforming_meshes(const Scene& scene) {
  const std::vector<bool> moves = moving_instances(scene);
  for (std::size_t i = 0; i < scene.instances.size(); ++i)
    if (moves[i] && is_posed(scene, scene.instances[i]))
      throw usage_error(
          "--reuse",
          fmt::format("interpolated frames need things to keep their shape, and {} changes it (skin or morph targets)",
                      shown(scene.instances[i].name)),
          "exact or none for this scene");
}

}  // namespace

std::unique_ptr<FrameMaker> make_frame_maker(Stage& stage, const FrameParams& params, const ThreadPool& pool,
                                             const Context& context) {
  if (params.reuse.mode == Reuse::kForward) refuse_deforming_meshes(stage.scene);
  if (params.reuse.mode == Reuse::kForward && params.reuse.min_psnr_db)
    return std::make_unique<FlooredFrames>(stage, params, pool, context);
  if (params.reuse.mode == Reuse::kForward) return std::make_unique<ForwardFrames>(stage, params, pool, context);
  warn_of_whole_paths(params, context);
  if (params.sampling.denoise) return std::make_unique<DenoisedFrames>(stage, params, pool, context);
  // Extra layers are of every pixel of every frame: with them nothing is left to reuse.
  if (params.reuse.mode == Reuse::kExact && params.sampling.aov.empty() && !params.sampling.transparent &&
      integrator_of(params) == Integrator::kWhitted)
    return std::make_unique<ExactFrames>(stage, params, pool, context);
  if (LitFrames::serves(params)) return std::make_unique<LitFrames>(stage, params, pool, context);
  return std::make_unique<TracedFrames>(stage, params, pool, context);
}

std::unique_ptr<FrameMaker> make_pattern_frames(const Stage& stage, const ThreadPool& pool) {
  return std::make_unique<PatternFrames>(stage, pool);
}

double bytes_kept_per_pixel(const FrameParams& params) {
  if (params.reuse.mode == Reuse::kForward && params.reuse.min_psnr_db) return FlooredFrames::bytes_kept_per_pixel();
  if (params.reuse.mode == Reuse::kForward) return ForwardFrames::bytes_kept_per_pixel(params);
  if (params.sampling.denoise) return DenoisedFrames::bytes_kept_per_pixel(params);
  if (LitFrames::serves(params)) return LitFrames::bytes_kept_per_pixel();
  return params.reuse.mode == Reuse::kExact ? ExactFrames::bytes_kept_per_pixel() : 0.0;
}

}  // namespace lippmann
