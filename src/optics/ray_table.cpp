#include "optics/ray_table.hpp"

#include "core/json_fields.hpp"
#include "optics/checks.hpp"

namespace lippmann {

void write_ray_of(const RayTableRays& c, const RayFrame& frame, float px, float py, const RayArrays& rays, int i) {
  const Ray& ray = c.at(px, py);
  const Vec3f origin =
      frame.origin + (ray.origin.x * frame.right + ray.origin.y * frame.up + (c.z_front_mm - ray.origin.z) * frame.forward);
  const Vec3f direction =
      ray.direction.x * frame.unit_right + ray.direction.y * frame.unit_up - ray.direction.z * frame.unit_forward;
  rays.origin_x[i] = origin.x, rays.origin_y[i] = origin.y, rays.origin_z[i] = origin.z;
  rays.direction_x[i] = direction.x, rays.direction_y[i] = direction.y, rays.direction_z[i] = direction.z;
}

void write_block(const RayTableRays& c, const RayFrame& frame, const float* px, const float* py, const RayArrays& rays) {
  for (int i = 0; i < kRayBlock; ++i) write_ray_of(c, frame, px[i], py[i], rays, i);
}

void check_model(const Panel& panel, const RayTable& table) {
  check_count("rays.samples_per_side", table.samples_per_side, 64);
  check_number("rays.spread", table.spread, 0.0, 1e3);
  const auto side = static_cast<std::size_t>(table.samples_per_side);
  const std::size_t wanted = side * side * static_cast<std::size_t>(panel.width) * static_cast<std::size_t>(panel.height);
  const std::size_t count = table.rays ? table.rays->size() : 0;
  if (count != wanted)
    reject_field("rays.rays", fmt::format("has {} rays", count),
                 fmt::format("{}: {} for each of {}x{} pixels", wanted, side * side, panel.width, panel.height));
  for (std::size_t i = 0; i < count; ++i) {
    const Ray& ray = (*table.rays)[i];
    const Vec3f &at = ray.origin, &to = ray.direction;
    const bool placed = std::max({std::abs(at.x), std::abs(at.y), std::abs(at.z)}) <= kMaxLength;  // false also for NaN
    if (!(placed && std::isfinite(at.x + at.y + at.z) && std::abs(glm::length(to) - 1.0f) <= 1e-3f && to.z < 0.0f))
      reject_field("rays.rays",
                   fmt::format("ray {}, which starts at ({}, {}, {}) mm and runs along ({}, {}, {}), is out of range", i, at.x,
                               at.y, at.z, to.x, to.y, to.z),
                   "rays that start within 1e9 mm of the centre, and directions of unit length with z < 0");
  }
}

void write_model(const RayTable& table, nlohmann::ordered_json& json) {
  json["samples_per_side"] = table.samples_per_side;
  json["spread"] = table.spread;
}

void read_model(const JsonFields& json, RayTable&) {
  json.reject("kind", "is rays, but the JSON does not contain their table", "pictures of other optics");
}

OpticsFacts facts_of(const Panel& panel, const RayTable&) { return facts_of_window(panel, kInfinity); }

float front_mm(const Panel&, const RayTable& table, float) {
  float front = -kMaxLength;
  for (const Ray& ray : *table.rays) front = std::max(front, ray.origin.z);
  return front;
}

RayTableRays make_rays(const Panel& panel, const RayTable& table, float z_front_mm) {
  const int side = table.samples_per_side;
  return {table.rays, static_cast<float>(side), panel.width * side, panel.height * side, z_front_mm};
}

}  // namespace lippmann
