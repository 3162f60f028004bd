#include "optics/single_view.hpp"

#include "core/json_fields.hpp"
#include "optics/checks.hpp"
#include "optics/optics_kind.hpp"

namespace lippmann {

SingleViewRays make_single_view(const Panel& panel, const SingleView& view, float z_front_mm) {
  return {0.5f * panel.width - view.pixel_offset.x,
          0.5f * panel.height - view.pixel_offset.y,
          panel.pixel_pitch_mm,
          view.eye_height_mm,
          1.0f / view.distance_mm,
          z_front_mm - view.distance_mm};
}

LIPPMANN_MULTIVERSION
void write_block(const SingleViewRays& c, const RayFrame& frame, const float* px, const float* py, const RayArrays& rays) {
  write_ray_block(frame, px, py, rays, [&c](float x, float y) LIPPMANN_INLINE_LAMBDA { return crossing(c, x, y); });
}

void pixels_seeing(const Panel& panel, const SingleView& view, Vec3f point_mm, std::vector<Vec2f>& pixels) {
  const double distance = view.distance_mm, from_eye = distance - point_mm.z;
  if (!(from_eye > 0.0)) return;
  const double px_per_mm = distance / from_eye / panel.pixel_pitch_mm;
  const double px = 0.5 * panel.width - view.pixel_offset.x + point_mm.x * px_per_mm;
  const double eye_y = view.eye_height_mm;
  const double py = 0.5 * panel.height - view.pixel_offset.y - eye_y / panel.pixel_pitch_mm - (point_mm.y - eye_y) * px_per_mm;
  if (px >= 0.0 && px < panel.width && py >= 0.0 && py < panel.height) pixels.emplace_back(px, py);
}

void check_model(const Panel&, const SingleView& view) {
  check_length("singleview.distance_mm", view.distance_mm);
  check_position("singleview.eye_height_mm", view.eye_height_mm);
  for (const float offset : {view.pixel_offset.x, view.pixel_offset.y})
    if (!(std::abs(offset) <= kMaxSide))
      reject_field("singleview.pixel_offset", fmt::format("is {} pixels", offset), fmt::format("at most {} pixels", kMaxSide));
}

void write_model(const SingleView& view, nlohmann::ordered_json& json) {
  json["distance_mm"] = view.distance_mm;
  json["pixel_offset_px"] = {view.pixel_offset.x, view.pixel_offset.y};
  if (view.eye_height_mm != 0.0f) json["eye_height_mm"] = view.eye_height_mm;
}

void read_model(const JsonFields& json, SingleView& view) {
  view.distance_mm = json.float_number("distance_mm");
  view.eye_height_mm = json.float_or("eye_height_mm", 0.0f);
  view.pixel_offset = json.has("pixel_offset_px") ? Vec2f(json.pair("pixel_offset_px")) : Vec2f(0.0f);
}

OpticsFacts facts_of(const Panel& panel, const SingleView& view) {
  OpticsFacts facts = facts_of_window(panel, view.distance_mm);
  const double m = panel.pixel_pitch_mm;
  facts.window = {Vec2d(view.pixel_offset.x, -view.pixel_offset.y) * m, Vec2d(panel.width * m, panel.height * m)};
  facts.whole_pixels_per_lens = Vec2i(1);
  facts.single_view = true;
  facts.eye_height_mm = view.eye_height_mm;
  return facts;
}

std::optional<ViewCameras> cameras_of(const Panel& panel, const SingleView& view) {
  const Vec2d centre = 0.5 * Vec2d(panel.width, panel.height) - Vec2d(view.pixel_offset);
  return ViewCameras{view.distance_mm, Vec2d(panel.pixel_pitch_mm), centre, {Vec2d(0.0, view.eye_height_mm)}};
}

namespace {

PanelSize single_size(const OpticsParams& params, Vec2i scene_resolution) {
  if (params.size.x > 0) return {params.size.x, params.size.y};
  if (scene_resolution.x > 0 && scene_resolution.y > 0) return {scene_resolution.x, scene_resolution.y};
  return {512, 512};
}

OpticsModel view_of_params(const ModelSetup& setup) { return SingleView{setup.viewing_distance_mm, setup.pixel_offset}; }

}  // namespace

constinit const OpticsKindInfo single_kind{.name = kind_of(SingleView{}),
                                           .help = "one pinhole view",
                                           .has_parallax = false,
                                           .panel_size = single_size,
                                           .make_model = view_of_params};

const OpticsKindInfo& kind_info(const SingleView&) { return single_kind; }

}  // namespace lippmann
