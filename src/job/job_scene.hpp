#pragma once

#include <string>
#include <vector>

#include "job/resolved_job.hpp"
#include "lippmann/core/context.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann {

struct SceneNotes {
  std::vector<std::string> camera_names;  ///< in the order of the file
  std::string light;                      ///< one sentence that names the light and the reason for it
};

struct JobScene {
  /// Passes validate(). The camera that sets the view comes first.
  Scene scene;
  SceneNotes notes;
};

/// Loads the job's scene with the light that the job requests, or an empty scene for the test pattern. Throws Error if
/// the scene cannot be loaded.
JobScene load_scene_of(const ResolvedJob& job, const Context& context);

}  // namespace lippmann
