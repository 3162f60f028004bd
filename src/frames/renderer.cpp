#include "lippmann/frames/renderer.hpp"

#include <fmt/core.h>

#include <cmath>
#include <utility>
#include <variant>

#include "frames/frame.hpp"
#include "frames/frame_maker.hpp"
#include "frames/picture_check.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/core/parallel.hpp"
#include "lippmann/scene/load.hpp"

namespace lippmann {
namespace {

/// A placement that was made for another scene may refer to a node that does not exist.
void check(const Placement& placement, const Scene& scene) {
  const FittedArray& array = placement.array;
  const int nodes = static_cast<int>(scene.nodes.size());
  if (array.node < -1 || array.node >= nodes)
    throw Error("placement", fmt::format("the array moves with node {}, but the number of nodes is {}", array.node, nodes),
                "a placement that was made for this scene");
  const auto is_size = [](float value) { return value > 0.0f && std::isfinite(value); };
  if (!is_size(array.plane_height) || !is_size(placement.placed.units_per_mm))
    throw Error("placement",
                fmt::format("the height of the array is {} units, the scale {} units per mm", array.plane_height,
                            placement.placed.units_per_mm),
                "a placement that was made for this scene, with both numbers above 0");
  validate(placement.placed.optics);
}

FrameParams checked(FrameParams params, const Placement& placement, const Scene& scene) {
  check(placement, scene);
  const bool interpolates = std::holds_alternative<Interpolate>(params.reuse);
  params.sampling = completed(std::move(params.sampling), scene.kind, interpolates);
  check(params, placement.placed.optics);
  return params;
}

Scene checked(Scene scene) {
  validate(scene, "scene");
  const Background& sky = scene.background;
  if (scene.shapes.empty() && !sky.map && sky.horizon == Vec3f(0.0f) && sky.zenith == Vec3f(0.0f))
    throw Error("scene", "has no surfaces to show", "a scene with meshes or other shapes, or with a sky");
  return scene;
}

/// A Context cannot be moved as a whole, because its flag is atomic.
std::shared_ptr<const Context> moved(Context&& context) {
  const auto kept = std::make_shared<Context>();
  kept->threads = context.threads;
  kept->warn = std::move(context.warn);
  kept->frame_progress = std::move(context.frame_progress);
  kept->cancelled = context.cancelled.load();
  return kept;
}

std::shared_ptr<const Context> borrowed(const Context& context) { return {std::shared_ptr<void>(), &context}; }

}  // namespace

struct Renderer::Impl {
  std::shared_ptr<const Context> context;
  FrameParams params;
  ThreadPool pool;
  Stage stage;
  std::unique_ptr<FrameMaker> maker;
  bool is_checked = false;

  Impl(Scene scene, Placement placement, FrameParams requested, std::shared_ptr<const Context> caller)
      : context(std::move(caller)),
        params(checked(std::move(requested), placement, scene)),
        pool(resolved_threads(*context)),
        stage(checked(std::move(scene)), std::move(placement.array), std::move(placement.placed),
              integrator_of(params.sampling), pool),
        maker(make_frame_maker(stage, params, pool, *context)) {
    if (!stage.array.warning.empty()) context->warning(stage.array.warning);
  }
};

Renderer::Renderer(Scene scene, Placement placement, FrameParams params, const Context& context)
    : impl_(std::make_unique<Impl>(std::move(scene), std::move(placement), std::move(params), borrowed(context))) {}

Renderer::Renderer(Scene scene, Placement placement, FrameParams params, Context&& context)
    : impl_(std::make_unique<Impl>(std::move(scene), std::move(placement), std::move(params), moved(std::move(context)))) {}

Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

const Scene& Renderer::scene() const { return impl_->stage.scene; }
const Optics& Renderer::optics() const { return impl_->stage.placed.optics; }

std::optional<RenderedFrame> Renderer::frame(int index) {
  const int count = scene().timeline.frame_count;
  if (index < 0 || index >= count)
    throw Error("frame", fmt::format("{} is outside the animation", index), fmt::format("frames from 0 to {}", count - 1));
  std::optional<SeenShare> seen;
  if (!std::exchange(impl_->is_checked, true)) seen = look_at_frame(impl_->stage, index, impl_->pool);
  RenderedFrame rendered = impl_->maker->make(index);
  if (impl_->context->cancelled) return std::nullopt;
  if (seen)
    if (const std::string doubt = doubt_about_picture(impl_->stage, index, *seen, rendered.pictures.film); !doubt.empty())
      impl_->context->warning(doubt);
  return rendered;
}

}  // namespace lippmann
