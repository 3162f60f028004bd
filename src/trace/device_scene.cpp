#include "trace/device_scene.hpp"

#include "shading/shaded_scene.hpp"

namespace lippmann {

DeviceScene::DeviceScene(const Scene& scene, const ThreadPool& pool, Integrator integrator)
    : shaded_(std::make_unique<ShadedScene>(
          scene, pool, integrator == Integrator::kWhitted ? MaterialUse::kWhitted : MaterialUse::kPaths)) {}

DeviceScene::~DeviceScene() = default;

void DeviceScene::update(const ResolvedScene& resolved, const ThreadPool& pool) { shaded_->update(resolved, pool); }

}  // namespace lippmann
