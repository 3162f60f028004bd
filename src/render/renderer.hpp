// The front door for programs that hold a scene in memory: a scene, optics, sampling and reuse go in; frames with their layers
// and figures come out. It knows no flags, no job files and no folders: render/animation.hpp puts those on top.
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

#include "core/context.hpp"
#include "core/parallel.hpp"
#include "render/fit_array.hpp"
#include "render/frame.hpp"
#include "render/frame_maker.hpp"
#include "render/frame_params.hpp"
#include "render/make_optics.hpp"

namespace lippmann {

/// Optics at their place in a scene.
struct Placement {
  FittedArray array;
  PlacedOptics placed;
};

struct PlacementWish {
  ViewWish view{};
  bool fit_depth = true;  ///< a scene that is deeper than the optics resolve is shown less deep (PlacedOptics::depth_scale)
};

/// Puts optics, in their own millimetres, into a scene that passes validate(): in the plane that fit_array() finds, which is as
/// high there as the window of the optics is. Viewing distances are those of the optics. Throws Error as fit_array() and
/// validate(const Optics&) do.
Placement place(const Scene& scene, const Optics& optics, const PlacementWish& wish = {});

/// Renders the frames of one scene through one set of optics. The same bits for any number of threads, and whichever frames are
/// asked for. One thread at a time; different renderers are independent.
class Renderer {
 public:
  /// Builds what rays are traced against, on context.threads threads. An integrator that is not named is Whitted's. `context`
  /// outlives it. Throws Error where the scene does not pass validate(), or where parameters contradict each other.
  Renderer(Scene scene, Placement placement, FrameParams params, const Context& context);

  /// Frame `index` of the scene's timeline, counted from 0: film as the optics lie (linear light, RGB), layers, figures. What
  /// frames share is kept best where they are asked for in ascending order. None where context.cancelled was set meanwhile.
  /// Throws Error for frames that the timeline does not have.
  std::optional<RenderedFrame> frame(int index);

  const Scene& scene() const { return stage_.scene; }
  const Optics& optics() const { return stage_.placed.optics; }

 private:
  const Context& context_;
  FrameParams params_;
  ThreadPool pool_;
  Stage stage_;
  std::unique_ptr<FrameMaker> maker_;
};

}  // namespace lippmann
