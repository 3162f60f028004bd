#pragma once

#include "device/embree_shim.hpp"

namespace lippmann {

void commit_scene(const EmbreeScene& scene);

/// Declares to ThreadSanitizer that a callback runs within commit_scene(). Construct a BuilderCall at the start of the
/// callback.
class BuilderCall {
 public:
  BuilderCall();
  ~BuilderCall();
  BuilderCall(const BuilderCall&) = delete;
  BuilderCall& operator=(const BuilderCall&) = delete;
};

}  // namespace lippmann
