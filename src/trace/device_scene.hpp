// A Scene prepared for tracing at one time: acceleration structures, geometry records and shading tables.
#pragma once

#include <memory>

#include "lippmann/core/parallel.hpp"
#include "lippmann/scene/scene.hpp"
#include "lippmann/scene/timeline.hpp"
#include "lippmann/trace/integrator.hpp"

namespace lippmann {

struct ShadedScene;

/// Build a DeviceScene once per scene, and update it once per frame. Static objects are built once. Rigidly moving objects are
/// transformed instead of rebuilt. The Scene must outlive this object. Any number of threads may trace at once, but not during
/// update().
class DeviceScene {
 public:
  /// Builds the tables of materials and lights for `integrator`. The geometry does not depend on the integrator.
  DeviceScene(const Scene& scene, const ThreadPool& pool, Integrator integrator = Integrator::kWhitted);
  ~DeviceScene();
  DeviceScene(const DeviceScene&) = delete;
  DeviceScene& operator=(const DeviceScene&) = delete;

  /// Moves all objects and lights to their positions in `resolved`.
  void update(const ResolvedScene& resolved, const ThreadPool& pool);

  const ShadedScene& shaded() const { return *shaded_; }  ///< defined in shading/shaded_scene.hpp
  Integrator integrator() const { return integrator_; }

 private:
  Integrator integrator_;
  std::unique_ptr<ShadedScene> shaded_;
};

}  // namespace lippmann
