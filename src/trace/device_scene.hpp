// A Scene prepared for tracing at one time: acceleration structures, flattened primitives and shading tables.
#pragma once

#include <memory>

#include "lippmann/core/parallel.hpp"
#include "lippmann/scene/scene.hpp"
#include "lippmann/scene/timeline.hpp"
#include "lippmann/trace/integrator.hpp"

namespace lippmann {

struct ShadedScene;

/// Build once per scene and update once per frame. Static objects are built once; rigidly moving objects are transformed, not
/// rebuilt. The Scene must outlive this object. Any number of threads may trace concurrently; update() must not overlap with
/// tracing.
class DeviceScene {
 public:
  /// Tabulates materials and lights for `integrator`. The geometry is the same for every integrator.
  DeviceScene(const Scene& scene, const ThreadPool& pool, Integrator integrator = Integrator::kWhitted);
  ~DeviceScene();
  DeviceScene(const DeviceScene&) = delete;
  DeviceScene& operator=(const DeviceScene&) = delete;

  /// Moves all objects to their places in `resolved`.
  void update(const ResolvedScene& resolved, const ThreadPool& pool);

  const ShadedScene& shaded() const { return *shaded_; }  ///< shading/shaded_scene.hpp
  Integrator integrator() const { return integrator_; }

 private:
  Integrator integrator_;
  std::unique_ptr<ShadedScene> shaded_;
};

}  // namespace lippmann
