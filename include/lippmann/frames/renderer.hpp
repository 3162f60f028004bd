// The main interface for programs that hold a scene in memory. A renderer takes a scene, optics, sampling and reuse, and
// returns frames with their layers and reports.
//
//   const Context context;
//   const Scene scene = load_scene("room", {}, context);
//   Optics quilt;
//   quilt.panel = {2048, 1536, 0.1f};
//   quilt.model = MultiView{.columns = 8, .rows = 6};
//   const Placement placement = place(scene, quilt);
//   Renderer renderer(scene, placement, {.sampling = {.integrator = Integrator::kPath, .spp = 64}}, context);
//   const auto frame = renderer.frame(0);
//   write_picture("quilt.png", to_codes(frame->pictures.film, scene.encoding));
#pragma once

#include <memory>
#include <optional>

#include "lippmann/core/context.hpp"
#include "lippmann/frames/frame_params.hpp"
#include "lippmann/frames/rendered_frame.hpp"
#include "lippmann/optics/optics.hpp"
#include "lippmann/scene/scene.hpp"
#include "lippmann/stage/placement.hpp"

namespace lippmann {

/// Renders frames of one scene for one set of optics. Frames do not depend on the number of threads or on other rendered
/// frames. A renderer is not thread-safe.
class Renderer {
 public:
  /// `context` must outlive this object. If `params` has no integrator, completed() chooses it. Throws Error if the scene does
  /// not pass validate(), if it has neither shapes nor a sky, or if parameters are invalid.
  Renderer(Scene scene, Placement placement, FrameParams params, const Context& context);
  /// Takes ownership of a temporary context, such as Context{}.
  Renderer(Scene scene, Placement placement, FrameParams params, Context&& context);
  ~Renderer();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;

  /// Renders frame `index`, counted from 0. The film holds linear RGB light in the native layout of the optics. With
  /// CopySettled and Interpolate, ascending order takes the least time. Returns nullopt if context.cancelled is set meanwhile.
  /// Throws Error if the timeline does not have this frame.
  std::optional<RenderedFrame> frame(int index);

  const Scene& scene() const;
  const Optics& optics() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace lippmann
