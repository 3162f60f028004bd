#include "reuse/tracing_costs.hpp"

#include <algorithm>
#include <cmath>

namespace lippmann {
namespace {

std::size_t primitives(const Mesh& mesh) { return mesh.triangles.size(); }

std::size_t primitives(const Splats& splats) { return splats.centers.size(); }

template <class Primitives>
std::size_t primitives(const Primitives& list) {
  return list.size();
}

}  // namespace

double seconds_per_ray(const Scene& scene) {
  std::size_t count = 0;
  for (const Instance& instance : scene.instances)
    count +=
        std::visit([](const auto& shape) { return primitives(shape); }, scene.shapes[static_cast<std::size_t>(instance.shape)]);
  return 5e-9 + 8e-9 * std::pow(static_cast<double>(count), 0.25);
}

double prediction_cost(const Scene& scene, const RayCounts& rays, std::uint64_t pixels) {
  const double traced = seconds_per_ray(scene) * static_cast<double>(rays.total());
  return kPredictionSecondsPerPixel * static_cast<double>(pixels) / traced;
}

double partial_tracing_cost(double share_of_rays) { return std::min(1.8 * share_of_rays, 0.8 + 0.3 * share_of_rays); }

}  // namespace lippmann
