// Loads the scene of a job and applies its light.
#pragma once

#include <string>
#include <vector>

#include "job/resolved_job.hpp"
#include "lippmann/core/context.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// Facts about a loaded scene that the scene itself does not store.
struct SceneNotes {
  std::vector<std::string> camera_names;  ///< in the file's order
  std::string light;                      ///< one sentence naming the light and the reason for it
};

struct JobScene {
  Scene scene;  ///< the scene, which passes validate(); the camera that sets the view comes first
  SceneNotes notes;
};

/// Loads the job's scene, or an empty one for the test pattern. Throws Error.
JobScene load_scene_of(const ResolvedJob& job, const Context& context);

}  // namespace lippmann
