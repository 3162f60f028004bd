// The stage of a job: its display, its scene in its light, and the optics where the parameters want them.
#pragma once

#include <memory>
#include <string>

#include "frames/frame.hpp"
#include "job/params.hpp"
#include "lippmann/display/display.hpp"

namespace lippmann {

struct JobStage : Stage {
  std::unique_ptr<const Display> display;  ///< none: optics of the parameters alone
  std::string light;                       ///< SceneNotes::light; empty where the scene was there already

  /// Loads the scene, fits the array and builds what rays are traced against. Throws Error.
  JobStage(const RenderParams& params, const ThreadPool& pool, const Context& context);
  /// The same for a scene that is there already and passes validate(); it is lit by what it holds, whatever environment the
  /// parameters name. Throws Error.
  JobStage(Scene scene, const RenderParams& params, const ThreadPool& pool);

  /// Fits the array anew, and makes other optics: of parameters that differ in what is seen of the scene and what shows it, not
  /// in the scene, its light or its integrator. Throws Error, and then stays as it was.
  void place(const RenderParams& params);

 private:
  struct Parts;
  JobStage(Parts parts, Integrator integrator, const ThreadPool& pool);
};

}  // namespace lippmann
