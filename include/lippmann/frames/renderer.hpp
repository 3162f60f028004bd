// The front door for programs that hold a scene in memory: a scene, optics, sampling and reuse go in; frames with their layers
// and figures come out. It knows no flags, no job files and no folders: job/animation.hpp puts those on top.
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

/// Renders the frames of one scene through one set of optics. The same bits for any number of threads, and whichever frames are
/// asked for. One thread at a time; different renderers are independent.
class Renderer {
 public:
  /// Builds what rays are traced against, on context.threads threads. An integrator that is not named is Whitted's. `context`
  /// outlives it. Throws Error where the scene does not pass validate(), or where parameters contradict each other.
  Renderer(Scene scene, Placement placement, FrameParams params, const Context& context);
  ~Renderer();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;

  /// Frame `index` of the scene's timeline, counted from 0: film as the optics lie (linear light, RGB), layers, figures. Frames
  /// that reuse others (CopySettled, Interpolate) take the least time in ascending order. None where context.cancelled was set
  /// meanwhile. Throws Error for frames that the timeline does not have.
  std::optional<RenderedFrame> frame(int index);

  const Scene& scene() const;
  const Optics& optics() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace lippmann
