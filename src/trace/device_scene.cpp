#include "trace/device_scene.hpp"

#include "shading/shaded_scene.hpp"

namespace lippmann {

DeviceScene::DeviceScene(const Scene& scene, const ThreadPool& pool, Integrator integrator)
    : integrator_(integrator),
      shaded_(std::make_unique<ShadedScene>(
          scene, pool, integrator.facts().samples_all_light ? MaterialUse::kPaths : MaterialUse::kWhitted)) {}

DeviceScene::~DeviceScene() = default;

void DeviceScene::update(const ResolvedScene& resolved, const ThreadPool& pool) { shaded_->update(resolved, pool); }

}  // namespace lippmann
