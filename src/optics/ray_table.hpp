// Rays of optics that are defined by a table of rays.
#pragma once

#include <memory>
#include <vector>

#include "lippmann/optics/optics.hpp"
#include "optics/crossing.hpp"
#include "optics/model.hpp"

namespace lippmann {

struct RayTableRays {
  std::shared_ptr<const std::vector<Ray>> rays;
  float samples_per_px;
  int columns, rows;
  float z_front_mm;

  const Ray& at(float px, float py) const {
    const auto index = [this](float p, int count) {
      return static_cast<std::size_t>(std::clamp(static_cast<int>(std::floor(p * samples_per_px)), 0, count - 1));
    };
    return (*rays)[index(py, rows) * static_cast<std::size_t>(columns) + index(px, columns)];
  }
};

void write_ray_of(const RayTableRays& constants, const RayFrame& frame, float px, float py, const RayArrays& rays, int i);
void write_block(const RayTableRays& constants, const RayFrame& frame, const float* px, const float* py, const RayArrays& rays);

constexpr std::string_view kind_of(const RayTable&) { return "rays"; }
constexpr int sub_pixels_of(const RayTable&) { return 1; }
void check_model(const Panel& panel, const RayTable& table);
/// write_model() writes no rays. read_model() throws Error, because JSON does not contain the rays.
void write_model(const RayTable& table, nlohmann::ordered_json& json);
void read_model(const JsonFields& json, RayTable& table);
OpticsFacts facts_of(const Panel& panel, const RayTable& table);
float front_mm(const Panel& panel, const RayTable& table, float chosen_mm);
RayTableRays make_rays(const Panel& panel, const RayTable& table, float z_front_mm);
inline Vec2f footprint_mm(const Panel& panel, const RayTable& table, float z_mm) {
  return Vec2f(panel.pixel_pitch_mm + std::abs(z_mm) * table.spread);
}
inline Vec2d zone_slope(const Panel&, const RayTable&, Vec2d) { return Vec2d(0.0); }
inline StepRule step_rule(const Panel&, const RayTable&, StepsWithin) { return {}; }

}  // namespace lippmann
