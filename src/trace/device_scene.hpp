// A Scene made ready for tracing: acceleration structures, flattened primitives, shading tables; at one moment of its timeline.
#pragma once

#include <memory>

#include "lippmann/core/parallel.hpp"
#include "lippmann/scene/scene.hpp"
#include "lippmann/scene/timeline.hpp"
#include "lippmann/trace/integrator.hpp"

namespace lippmann {

/// Built once per scene, updated once per frame. What never moves is built once; what moves rigidly is moved, not rebuilt.
/// The Scene must outlive it. Tracing reads it from any number of threads; update() must not overlap with tracing.
class DeviceScene {
 public:
  /// Made ready for tracing by `integrator` and no other.
  DeviceScene(const Scene& scene, const ThreadPool& pool, Integrator integrator = Integrator::kWhitted);
  ~DeviceScene();
  DeviceScene(const DeviceScene&) = delete;
  DeviceScene& operator=(const DeviceScene&) = delete;

  /// Moves everything to where `resolved` has it.
  void update(const ResolvedScene& resolved, const ThreadPool& pool);

  struct Impl;
  const Impl& impl() const { return *impl_; }

 private:
  std::unique_ptr<Impl> impl_;
};

}  // namespace lippmann
