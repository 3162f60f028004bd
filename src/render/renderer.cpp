#include "render/renderer.hpp"

#include <fmt/core.h>

#include <utility>

#include "core/error.hpp"
#include "render/aov_params.hpp"
#include "render/denoised_frames.hpp"
#include "render/reuse_params.hpp"
#include "scene/load.hpp"

namespace lippmann {
namespace {

/// Before anything is built.
FrameParams checked(FrameParams params, const Optics& optics) {
  check_reuse(params);
  check_layers(params);
  check_denoise(params);
  check_angular_filter(params, optics);
  return params;
}

Scene checked(Scene scene) {
  validate(scene, "scene");
  return scene;
}

}  // namespace

Placement place(const Scene& scene, const Optics& optics, const PlacementWish& wish) {
  validate(optics);
  const Vec2f window = window_size_mm(optics);
  Placement placement;
  placement.array = fit_array(scene, window.x / window.y, wish.view);
  placement.placed = placed_on(placement.array, optics, wish.fit_depth);
  return placement;
}

Renderer::Renderer(Scene scene, Placement placement, FrameParams params, const Context& context)
    : context_(context),
      params_(checked(std::move(params), placement.placed.optics)),
      pool_(resolved_threads(context)),
      stage_(checked(std::move(scene)), std::move(placement.array), std::move(placement.placed), integrator_of(params_), pool_),
      maker_(make_frame_maker(stage_, params_, pool_, context)) {}

std::optional<RenderedFrame> Renderer::frame(int index) {
  const int count = stage_.scene.timeline.frame_count;
  if (index < 0 || index >= count)
    throw Error("frame", fmt::format("{} is outside the animation", index), fmt::format("frames from 0 to {}", count - 1));
  RenderedFrame rendered = maker_->make(index);
  if (context_.cancelled) return std::nullopt;
  return rendered;
}

}  // namespace lippmann
