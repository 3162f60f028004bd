// A Scene made ready for tracing: acceleration structures, flattened primitives, shading tables; at one moment of its timeline.
#pragma once

#include <memory>

#include "lippmann/core/parallel.hpp"
#include "lippmann/scene/scene.hpp"
#include "lippmann/scene/timeline.hpp"
#include "lippmann/trace/integrator.hpp"

namespace lippmann {

struct ShadedScene;

/// Built once per scene, updated once per frame. What never moves is built once; what moves rigidly is moved, not rebuilt.
/// The Scene must outlive it. Tracing reads it from any number of threads; update() must not overlap with tracing.
class DeviceScene {
 public:
  /// What rays meet is the same for every integrator; materials and lights are tabulated for this one.
  DeviceScene(const Scene& scene, const ThreadPool& pool, Integrator integrator = Integrator::kWhitted);
  ~DeviceScene();
  DeviceScene(const DeviceScene&) = delete;
  DeviceScene& operator=(const DeviceScene&) = delete;

  /// Moves everything to where `resolved` has it.
  void update(const ResolvedScene& resolved, const ThreadPool& pool);

  const ShadedScene& shaded() const { return *shaded_; }  ///< shading/shaded_scene.hpp
  Integrator integrator() const { return integrator_; }

 private:
  Integrator integrator_;
  std::unique_ptr<ShadedScene> shaded_;
};

}  // namespace lippmann
