// Runs Embree's builders, which call our callbacks on any thread of the calling arena.
#pragma once

#include "device/embree_shim.hpp"

namespace lippmann {

/// Builds the acceleration structure of a scene.
void commit_scene(const EmbreeScene& scene);

/// Lives as long as a callback from a builder, to declare to ThreadSanitizer that the callback runs within commit_scene().
class BuilderCall {
 public:
  BuilderCall();
  ~BuilderCall();
  BuilderCall(const BuilderCall&) = delete;
  BuilderCall& operator=(const BuilderCall&) = delete;
};

}  // namespace lippmann
