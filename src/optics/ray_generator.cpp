#include "optics/ray_generator.hpp"

namespace lippmann {

RayGenerator::RayGenerator(const Optics& optics, const Affine3f& world_from_display) {
  const Panel& panel = optics.panel;
  const float z_front = resolved_z_front_mm(optics);
  if (const auto* sheet = std::get_if<LenticularSheet>(&optics.model)) {
    model_ = make_lenticular(panel, *sheet, z_front).as<float>();
  } else if (const auto* array = std::get_if<MicrolensArray>(&optics.model)) {
    const MicrolensConstants<float> constants = make_microlens(panel, *array, z_front).as<float>();
    if (array->packing == LensPacking::kSquare)
      model_ = SquareMicrolensRays{constants};
    else
      model_ = HexagonalMicrolensRays{constants};
  } else if (const auto* views = std::get_if<MultiView>(&optics.model)) {
    model_ = make_multi_view(panel, *views, z_front);
  } else if (const auto* slanted = std::get_if<SlantedPanel>(&optics.model)) {
    model_ = make_slanted_panel(panel, *slanted, z_front);
  } else {
    model_ = make_single_view(panel, std::get<SingleView>(optics.model), z_front);
  }
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

Ray RayGenerator::ray(Vec2f pixel) const {
  Ray ray;
  const RayArrays arrays{&ray.origin.x, &ray.origin.y, &ray.origin.z, &ray.direction.x, &ray.direction.y, &ray.direction.z};
  std::visit([&](const auto& model) { write_ray(frame_, crossing(model, pixel.x, pixel.y), arrays, 0); }, model_);
  return ray;
}

}  // namespace lippmann
