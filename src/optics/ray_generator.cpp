#include "optics/ray_generator.hpp"

namespace lippmann {
namespace {

template <class Rays>
AnyRays any_rays(Rays rays) {
  return rays;
}

template <class... Kinds>
AnyRays any_rays(std::variant<Kinds...> rays) {
  return std::visit([](const auto& kind) -> AnyRays { return kind; }, rays);
}

}  // namespace

RayGenerator::RayGenerator(const Optics& optics, const Affine3f& world_from_display) {
  const float z_front = resolved_z_front_mm(optics);
  model_ = std::visit([&](const auto& model) { return any_rays(make_rays(optics.panel, model, z_front)); }, optics.model);
  frame_ = make_ray_frame(world_from_display, z_front);
  depth_ = (z_front + optics.z_back_mm) * uniform_scale(world_from_display);
}

void RayGenerator::rays(const float* pixel_x, const float* pixel_y, int count, const RayArrays& rays) const {
  std::visit(
      [&](const auto& model) {
        for_each_ray_block(pixel_x, pixel_y, count, rays, [&](const float* px, const float* py, const RayArrays& block) {
          write_block(model, frame_, px, py, block);
        });
      },
      model_);
}

void RayGenerator::mark_blocked(const float* pixel_x, const float* pixel_y, int count, float value, float* mark) const {
  std::visit(
      [&](const auto& model) {
        if constexpr (requires { is_blocked(model, 0.0f, 0.0f); })
          for (int i = 0; i < count; ++i)
            if (is_blocked(model, pixel_x[i], pixel_y[i])) mark[i] = value;
      },
      model_);
}

Ray RayGenerator::ray(Vec2f pixel) const {
  Ray ray;
  const RayArrays arrays{&ray.origin.x, &ray.origin.y, &ray.origin.z, &ray.direction.x, &ray.direction.y, &ray.direction.z};
  std::visit([&](const auto& model) { write_ray_of(model, frame_, pixel.x, pixel.y, arrays, 0); }, model_);
  return ray;
}

}  // namespace lippmann
