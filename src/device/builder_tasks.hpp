// Embree's builders, which call us back on any of the calling arena's threads.
#pragma once

#include "device/embree_shim.hpp"

namespace lippmann {

/// Builds what rays of a scene are traced against.
void commit_scene(const EmbreeScene& scene);

/// Lives as long as a call back from a builder: tells ThreadSanitizer that it lies within commit_scene().
class BuilderCall {
 public:
  BuilderCall();
  ~BuilderCall();
  BuilderCall(const BuilderCall&) = delete;
  BuilderCall& operator=(const BuilderCall&) = delete;
};

}  // namespace lippmann
