#include "job/job_stage.hpp"

#include <utility>

#include "job/display_optics.hpp"
#include "job/make_optics.hpp"
#include "lippmann/stage/fit_array.hpp"

namespace lippmann {

/// All that is known before structures for rays are built.
struct JobStage::Parts {
  std::unique_ptr<const Display> display;
  std::string light;
  Scene scene;
  FittedArray array;
  PlacedOptics placed;

  Parts(Scene described, const RenderParams& params)
      : display(wanted_display(params)),
        scene(std::move(described)),
        array(fit_array(scene, window_aspect(params, scene.resolution, display.get()), params.scene.view)),
        placed(make_optics(params, scene, array, display.get())) {}

  static Parts loaded(const RenderParams& params, const Context& context) {
    SceneNotes notes;
    Parts parts(wanted_scene(params, context, &notes), params);
    parts.light = std::move(notes.light);
    if (!parts.array.warning.empty()) context.warning(parts.array.warning);
    return parts;
  }
};

JobStage::JobStage(Parts parts, Integrator integrator, const ThreadPool& pool)
    : Stage(std::move(parts.scene), std::move(parts.array), std::move(parts.placed), integrator, pool),
      display(std::move(parts.display)),
      light(std::move(parts.light)) {}

JobStage::JobStage(const RenderParams& params, const ThreadPool& pool, const Context& context)
    : JobStage(Parts::loaded(params, context), integrator_of(params.sampling), pool) {}

JobStage::JobStage(Scene described, const RenderParams& params, const ThreadPool& pool)
    : JobStage(Parts(std::move(described), params), integrator_of(params.sampling), pool) {}

void JobStage::place(const RenderParams& params) {
  std::unique_ptr<const Display> wanted = wanted_display(params);
  FittedArray fitted = fit_array(scene, window_aspect(params, scene.resolution, wanted.get()), params.scene.view);
  placed = make_optics(params, scene, fitted, wanted.get());
  array = std::move(fitted);
  display = std::move(wanted);
}

}  // namespace lippmann
