#include "lippmann/optics/optics.hpp"

#include "lippmann/core/error.hpp"
#include "optics/models.hpp"
#include "optics/ray_generator.hpp"

namespace lippmann {
namespace {

template <class Function>
auto visit_model(const Optics& optics, const Function& function) {
  return std::visit([&](const auto& model) { return function(optics.panel, model); }, optics.model);
}

}  // namespace

float front_of_lenses_mm(const Panel& panel, float viewing_distance_mm, float chosen_mm) {
  if (std::isfinite(chosen_mm)) return chosen_mm;
  if (std::isfinite(viewing_distance_mm)) return viewing_distance_mm;
  return 4.0f * (panel.pixel_pitch_mm * std::hypot(static_cast<float>(panel.width), static_cast<float>(panel.height)));
}

float lens_zone(float pitch_mm, float gap_mm, float viewing_distance_mm) {
  const float cell_mm = pitch_mm * (1.0f + gap_mm / viewing_distance_mm);
  return 2.0f * std::atan(cell_mm / (2.0f * gap_mm));
}

int rounded_count(double samples) { return static_cast<int>(std::clamp(std::round(samples), 1.0, 65536.0)); }

OpticsFacts facts_of_lenses(const Panel& panel, const LensArray& lenses, Vec2i whole_pixels_per_lens) {
  const double m = panel.pixel_pitch_mm;
  const double toward_viewer = lenses.gap_mm / (lenses.viewing_distance_mm + lenses.gap_mm);  // 0 if the distance is infinite
  const auto gap = static_cast<float>(lenses.gap_mm), distance = static_cast<float>(lenses.viewing_distance_mm);
  const bool rows = lenses.row_pitch_mm > 0.0;
  OpticsFacts facts;
  facts.lenses = lenses;
  facts.whole_pixels_per_lens = whole_pixels_per_lens;
  facts.window_size_mm = Vec2f(panel.width, panel.height) * panel.pixel_pitch_mm;
  facts.window = {{0.0, lenses.eye_height_mm * toward_viewer},
                  Vec2d(panel.width * m, panel.height * m) * (1.0 - toward_viewer)};
  facts.viewing_distance_mm = distance;
  facts.eye_height_mm = static_cast<float>(lenses.eye_height_mm);
  facts.viewing_zone = lens_zone(lenses.lens_pitch_mm, gap, distance);
  facts.depth_budget_mm = lenses.lens_pitch_mm * gap / panel.pixel_pitch_mm;
  facts.parallax = {true, rows};
  facts.view_counts = {rounded_up_count(lenses.cell_mm / m),
                       rows ? rounded_up_count(lenses.cell_mm * (lenses.row_pitch_mm / lenses.pitch_mm) / m) : 1};
  facts.lens_step_mm = lenses.pitch_mm;
  facts.repeats_beyond_zone = true;
  return facts;
}

OpticsFacts facts_of_window(const Panel& panel, float viewing_distance_mm) {
  OpticsFacts facts;
  facts.window_size_mm = Vec2f(panel.width, panel.height) * panel.pixel_pitch_mm;
  facts.window = {{0.0, 0.0}, Vec2d(facts.window_size_mm)};
  facts.viewing_distance_mm = viewing_distance_mm;
  facts.samples = {panel.pixel_pitch_mm, panel.pixel_pitch_mm};
  return facts;
}

std::vector<Vec2d> lens_eyes(Vec2i n, double eye_step_mm, double eye_height_mm) {
  std::vector<Vec2d> eyes;
  for (int row = 0; row < n.y; ++row)
    for (int column = 0; column < n.x; ++column)
      eyes.emplace_back((column - 0.5 * (n.x - 1)) * eye_step_mm, eye_height_mm + (row - 0.5 * (n.y - 1)) * eye_step_mm);
  return eyes;
}

void throw_no_inverse() {
  throw usage_error("optics", "the pixels that see a point cannot be computed for these optics",
                    "other optics than a table of rays or a plenoptic camera");
}

OpticsFacts optics_facts(const Optics& optics) {
  return visit_model(optics, [](const Panel& panel, const auto& model) { return facts_of(panel, model); });
}

float resolved_z_front_mm(const Optics& optics) {
  return visit_model(optics, [&](const Panel& panel, const auto& model) { return front_mm(panel, model, optics.z_front_mm); });
}

Ray ray_of_pixel(const Optics& optics, Vec2f pixel) { return RayGenerator(optics).ray(pixel); }

void rays_of_pixels(const Optics& optics, const float* pixel_x, const float* pixel_y, int count, const RayArrays& rays) {
  RayGenerator(optics).rays(pixel_x, pixel_y, count, rays);
}

bool is_blocked(const Optics& optics, Vec2f pixel) {
  float mark = 0.0f;
  RayGenerator(optics).mark_blocked(&pixel.x, &pixel.y, 1, 1.0f, &mark);
  return mark > 0.0f;
}

void pixels_seeing(const Optics& optics, Vec3f point_mm, std::vector<Vec2f>& pixels) {
  if (!std::isfinite(point_mm.x) || !std::isfinite(point_mm.y) || !std::isfinite(point_mm.z)) return;
  if (!(point_mm.z <= resolved_z_front_mm(optics) && point_mm.z >= -optics.z_back_mm)) return;
  visit_model(optics, [&]<class Model>(const Panel& panel, const Model& model) {
    if constexpr (HasInverse<Model>)
      pixels_seeing(panel, model, point_mm, pixels);
    else
      throw_no_inverse();
  });
}

AnySight make_sight(const Optics& optics) {
  return visit_model(optics, []<class Model>(const Panel& panel, const Model& model) -> AnySight {
    if constexpr (HasInverse<Model>)
      return sight_of(panel, model);
    else
      throw_no_inverse();
  });
}

std::optional<ViewCameras> view_cameras(const Optics& optics) {
  return visit_model(optics, []<class Model>(const Panel& panel, const Model& model) -> std::optional<ViewCameras> {
    if constexpr (HasCameras<Model>)
      return cameras_of(panel, model);
    else
      return std::nullopt;
  });
}

Vec2f sample_footprint_mm(const Optics& optics, float z_mm) {
  return visit_model(optics, [&](const Panel& panel, const auto& model) { return footprint_mm(panel, model, z_mm); });
}

int sub_pixels_per_pixel(const Optics& optics) {
  return visit_model(optics, [](const Panel&, const auto& model) { return sub_pixels_of(model); });
}

Vec2i film_size(const Optics& optics) { return {optics.panel.width * sub_pixels_per_pixel(optics), optics.panel.height}; }

Vec2i whole_pixels_per_lens(const Optics& optics) { return optics_facts(optics).whole_pixels_per_lens; }
std::optional<LensArray> lens_array(const Optics& optics) { return optics_facts(optics).lenses; }
std::optional<SensorLenses> sensor_lenses(const Optics& optics) { return optics_facts(optics).sensor_lenses; }
std::optional<ViewTiles> view_tiles(const Optics& optics) { return optics_facts(optics).tiles; }
bool is_single_view(const Optics& optics) { return optics_facts(optics).single_view; }
float viewing_distance_mm(const Optics& optics) { return optics_facts(optics).viewing_distance_mm; }
float viewing_zone(const Optics& optics) { return optics_facts(optics).viewing_zone; }
float depth_budget_mm(const Optics& optics) { return optics_facts(optics).depth_budget_mm; }
Vec2f window_size_mm(const Optics& optics) { return optics_facts(optics).window_size_mm; }

Optics with_parallax(Optics optics, float parallax) {
  std::visit(
      [&](auto& model) {
        if constexpr (requires { model.parallax; }) model.parallax = parallax;
      },
      optics.model);
  return optics;
}

std::optional<OpticsModel> with_lenses(OpticsModel model, float pitch_mm, float gap_mm, Vec2f offset_mm) {
  const bool has_lenses = std::visit(
      [&]<class Model>(Model& lenses) {
        if constexpr (HasLenses<Model>) set_lenses(lenses, pitch_mm, gap_mm, offset_mm);
        return HasLenses<Model>;
      },
      model);
  return has_lenses ? std::optional(model) : std::nullopt;
}

}  // namespace lippmann
