// A Scene prepared for tracing at one time.
#pragma once

#include <memory>

#include "lippmann/core/parallel.hpp"
#include "lippmann/scene/scene.hpp"
#include "lippmann/scene/timeline.hpp"
#include "lippmann/trace/integrator.hpp"

namespace lippmann {

struct ShadedScene;

/// Build a DeviceScene once per scene, and call update() once per frame. The Scene must outlive this object. Any number of
/// threads may trace at once, but not during update().
class DeviceScene {
 public:
  DeviceScene(const Scene& scene, const ThreadPool& pool, Integrator integrator = Integrator::kWhitted);
  ~DeviceScene();
  DeviceScene(const DeviceScene&) = delete;
  DeviceScene& operator=(const DeviceScene&) = delete;

  void update(const ResolvedScene& resolved, const ThreadPool& pool);

  const ShadedScene& shaded() const { return *shaded_; }  ///< defined in shading/shaded_scene.hpp
  Integrator integrator() const { return integrator_; }

 private:
  Integrator integrator_;
  std::unique_ptr<ShadedScene> shaded_;
};

}  // namespace lippmann
