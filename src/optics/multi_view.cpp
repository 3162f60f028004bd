#include "optics/multi_view.hpp"

#include "core/degrees.hpp"
#include "core/json_fields.hpp"
#include "optics/checks.hpp"
#include "optics/lens_params.hpp"
#include "optics/optics_kind.hpp"

namespace lippmann {
namespace {

struct EyeAngles {
  double first, step;
};

EyeAngles eye_angles(const MultiView& views) {
  const int count = views.columns * views.rows;
  const double cone = views.baseline_mm > 0.0f ? 0.0 : views.view_cone;
  const double shift = views.eye_shift.x;
  if (!views.cone_ends_included) return {cone * ((0.5 + shift) / count - 0.5), cone / count};
  return count > 1 ? EyeAngles{cone * (shift / (count - 1) - 0.5), cone / (count - 1)} : EyeAngles{0.0, 0.0};
}

double first_eye(double baseline_mm, int count, float shift) { return baseline_mm * (shift - 0.5 * (count - 1)); }

}  // namespace

EyeMm eye_of_view(const MultiView& views, int view) {
  const EyeAngles angles = eye_angles(views);
  const double baseline = views.parallax * views.baseline_mm, reach = views.parallax * views.distance_mm;
  return {reach * std::tan(angles.first + view * angles.step) + first_eye(baseline, views.columns, views.eye_shift.x) +
              view % views.columns * baseline,
          views.eye_height_mm + first_eye(baseline, views.rows, views.eye_shift.y) + view / views.columns * baseline};
}

MultiViewRays make_multi_view(const Panel& panel, const MultiView& views, float z_front_mm) {
  const int tile_width = panel.width / views.columns, tile_height = panel.height / views.rows;
  const EyeAngles angles = eye_angles(views);
  MultiViewRays c{};
  c.columns = static_cast<float>(views.columns), c.rows = static_cast<float>(views.rows);
  c.tile_width_px = static_cast<float>(tile_width), c.tile_height_px = static_cast<float>(tile_height);
  c.tiles_per_px_x = 1.0f / c.tile_width_px, c.tiles_per_px_y = 1.0f / c.tile_height_px;
  c.padding_top_px = static_cast<float>(panel.height - views.rows * tile_height);
  c.pixel_pitch_mm = panel.pixel_pitch_mm, c.pixel_height_mm = panel.pixel_pitch_mm * views.pixel_height;
  c.first_half_angle = static_cast<float>(0.5 * angles.first), c.half_angle_step = static_cast<float>(0.5 * angles.step);
  const double baseline = views.parallax * views.baseline_mm;
  c.first_eye_mm = Vec2f(first_eye(baseline, views.columns, views.eye_shift.x),
                         views.eye_height_mm + first_eye(baseline, views.rows, views.eye_shift.y));
  c.baseline_mm = static_cast<float>(baseline);
  c.eye_reach_mm = views.parallax * views.distance_mm;
  c.distance_mm = views.distance_mm, c.inverse_distance = 1.0f / views.distance_mm;
  c.front_from_eye_mm = z_front_mm - views.distance_mm;
  return c;
}

LIPPMANN_MULTIVERSION
void write_block(const MultiViewRays& c, const RayFrame& frame, const float* px, const float* py, const RayArrays& rays) {
  write_ray_block(frame, px, py, rays, [&c](float x, float y) LIPPMANN_INLINE_LAMBDA { return crossing(c, x, y); });
}

void pixels_seeing(const Panel& panel, const MultiView& views, Vec3f point_mm, std::vector<Vec2f>& pixels) {
  const double distance = views.distance_mm, from_eye = distance - point_mm.z;
  if (!(from_eye > 0.0)) return;
  const double magnification = distance / from_eye, m = panel.pixel_pitch_mm;
  const int width = panel.width / views.columns, height = panel.height / views.rows;
  for (int v = 0; v < views.columns * views.rows; ++v) {
    const EyeMm eye = eye_of_view(views, v);
    const double x = 0.5 * width + (eye.x + (point_mm.x - eye.x) * magnification) / m;
    const double y = 0.5 * height - (eye.y + (point_mm.y - eye.y) * magnification) / (m * views.pixel_height);
    if (!(x >= 0.0 && x < width && y >= 0.0 && y < height)) continue;
    pixels.emplace_back(v % views.columns * width + x, panel.height - (v / views.columns + 1) * height + y);
  }
}

void check_model(const Panel& panel, const MultiView& views) {
  check_count("multiview.columns", views.columns, panel.width);
  check_count("multiview.rows", views.rows, panel.height);
  check_cone("multiview.view_cone", views.view_cone);
  check_length("multiview.distance_mm", views.distance_mm);
  if (views.baseline_mm != 0.0f && !(views.baseline_mm >= kMinLength && views.baseline_mm <= kMaxLength))
    reject_field("multiview.baseline_mm", fmt::format("is {} mm", views.baseline_mm),
                 fmt::format("a length from {} to {} mm, or 0 for a cone of views", kMinLength, kMaxLength));
  check_number("multiview.pixel_height", views.pixel_height, 0.01, 100);
  check_parallax("multiview.parallax", views.parallax);
  check_position("multiview.eye_height_mm", views.eye_height_mm);
  for (const float shift : {views.eye_shift.x, views.eye_shift.y})
    check_number("multiview.eye_shift", shift, -kMaxSide, kMaxSide);
}

void write_model(const MultiView& views, nlohmann::ordered_json& json) {
  json["columns"] = views.columns, json["rows"] = views.rows, json["distance_mm"] = views.distance_mm;
  if (views.baseline_mm > 0.0f) {
    json["baseline_mm"] = views.baseline_mm;
  } else {
    json["view_cone_deg"] = to_degrees(views.view_cone);
    json["cone_ends_included"] = views.cone_ends_included;
  }
  if (views.pixel_height != 1.0f) json["pixel_height"] = views.pixel_height;
  if (views.eye_height_mm != 0.0f) json["eye_height_mm"] = views.eye_height_mm;
}

void read_model(const JsonFields& json, MultiView& views) {
  json.require({"columns", "rows", "distance_mm", json.has("baseline_mm") ? "baseline_mm" : "view_cone_deg"});
  views.columns = json.whole("columns", kAnyCount), views.rows = json.whole("rows", kAnyCount);
  views.distance_mm = json.float_number("distance_mm");
  views.pixel_height = json.float_or("pixel_height", 1.0f);
  views.eye_height_mm = json.float_or("eye_height_mm", 0.0f);
  if (json.has("baseline_mm")) {
    views.baseline_mm = json.float_number("baseline_mm");
    return;
  }
  views.view_cone = from_degrees(json.number("view_cone_deg"));
  views.cone_ends_included = json.flag_or("cone_ends_included", false);
}

namespace {

bool is_grid(const MultiView& views) { return views.baseline_mm > 0.0f; }

/// Returns the full angle of the viewing zone. For a camera grid with n eyes along its longer side, the zone is n baselines
/// wide at the distance of the eyes.
float views_zone(const MultiView& views) {
  if (!is_grid(views)) return views.view_cone;
  const auto eyes = static_cast<float>(std::max(views.columns, views.rows));
  return 2.0f * std::atan(0.5f * eyes * views.baseline_mm / views.distance_mm);
}

/// Returns the distance from the plane z = 0, towards the viewer, at which a point moves by one pixel between the two middle
/// views. Returns infinity for a stereo pair, because each eye sees only its own view.
float view_budget_mm(const MultiView& views, float pixel_pitch_mm) {
  const int steps = views.columns * views.rows - (views.cone_ends_included ? 1 : 0);
  if (views.columns * views.rows < 2 || (is_grid(views) && views.columns == 2 && views.rows == 1)) return kInfinity;
  const float on_cone = 2.0f * views.distance_mm * std::tan(0.5f * views.view_cone / static_cast<float>(steps));
  const float eyes_apart = is_grid(views) ? views.baseline_mm : on_cone;
  return pixel_pitch_mm * views.distance_mm / (eyes_apart + pixel_pitch_mm);
}

}  // namespace

OpticsFacts facts_of(const Panel& panel, const MultiView& views) {
  const bool grid = is_grid(views);
  const int count = views.columns * views.rows;
  OpticsFacts facts =
      facts_of_window({panel.width / views.columns, panel.height / views.rows, panel.pixel_pitch_mm}, views.distance_mm);
  facts.tiles = ViewTiles{views.columns, views.rows, grid};
  facts.whole_pixels_per_lens = Vec2i(1);
  facts.window_size_mm =
      Vec2f(1.0f, views.pixel_height) * Vec2f(panel.width / views.columns, panel.height / views.rows) * panel.pixel_pitch_mm;
  facts.window = {{0.0, 0.0}, Vec2d(facts.window_size_mm)};
  facts.eye_height_mm = views.eye_height_mm;
  facts.viewing_zone = views_zone(views);
  facts.depth_budget_mm = view_budget_mm(views, panel.pixel_pitch_mm);
  facts.parallax = grid ? Parallax{views.columns > 1, views.rows > 1} : Parallax{true, false};
  facts.view_counts = grid ? Vec2i(views.columns, views.rows) : Vec2i(count, 1);
  facts.samples.down_mm = static_cast<double>(panel.pixel_pitch_mm) * views.pixel_height;
  facts.views_by_angle = !grid;
  facts.crosstalk_pitch = {views.columns > 1 || !grid ? 1.0 : 0.0, views.rows > 1 && grid ? 1.0 : 0.0};
  return facts;
}

Vec2d zone_slope(const Panel&, const MultiView& views, Vec2d share) {
  if (is_grid(views))
    return {(share.x - 0.5) * views.columns * views.baseline_mm / views.distance_mm,
            (share.y - 0.5) * views.rows * views.baseline_mm / views.distance_mm};
  const int count = views.columns * views.rows;
  // If the outermost eyes are at the ends of the cone, the viewing zone extends half a view step beyond them.
  const double widening = views.cone_ends_included && count > 1 ? count / (count - 1.0) : 1.0;
  return {std::tan(views.view_cone * widening * (share.x - 0.5)), 0.0};
}

StepRule step_rule(const Panel& panel, const MultiView& views, StepsWithin) {
  StepRule rule;
  rule.bounds = StepRule::Bounds::kTile;
  rule.tile = {panel.width / views.columns, panel.height / views.rows};
  rule.last_tile = {views.columns - 1, views.rows - 1};
  rule.padding_top = panel.height - views.rows * rule.tile.y;
  return rule;
}

std::optional<ViewCameras> cameras_of(const Panel& panel, const MultiView& views) {
  const Vec2d pixel_mm = Vec2d(1.0, views.pixel_height) * double(panel.pixel_pitch_mm);
  ViewCameras cameras{views.distance_mm, pixel_mm, {}, {}};
  cameras.centre_px = 0.5 * Vec2d(panel.width / views.columns, panel.height / views.rows);
  for (int view = 0; view < views.columns * views.rows; ++view) {
    const EyeMm eye = eye_of_view(views, view);
    cameras.eyes_mm.emplace_back(eye.x, eye.y);
  }
  return cameras;
}

namespace {

PanelSize quilt_size(const OpticsParams& params, Vec2i) {
  constexpr int kDefaultTile = 256;
  const Extent<int> views = params.views.x > 0 ? params.views : Extent<int>{8, 6}, size = params.size;
  if (size.x == 0) return {covered_pixels(views.x, kDefaultTile), covered_pixels(views.y, kDefaultTile), 0.0f, views};
  if (size.x % views.x != 0 || size.y % views.y != 0)
    throw usage_error(
        "size", fmt::format("{}x{} pixels do not divide into `views` {}x{}", size.x, size.y, views.x, views.y),
        fmt::format("for example {}x{}", std::max(1, size.x / views.x) * views.x, std::max(1, size.y / views.y) * views.y));
  return {size.x, size.y, 0.0f, views};
}

/// In a camera grid with N eyes along its longer side, eyes are 2 V tan(a/2) / N apart, with the viewing distance V and the
/// angle a of the viewing zone. If the outermost eyes are at the ends of the zone, N - 1 replaces N.
OpticsModel views_of_params(const ModelSetup& setup) {
  const Extent<int> views = setup.size.views;
  const float distance_mm = setup.viewing_distance_mm;
  MultiView model{views.x, views.y, view_angle(setup.params), setup.params.cone_ends, distance_mm};
  if (!setup.params.camera_grid) return model;
  const int eyes = std::max(views.x, views.y), steps = setup.params.cone_ends ? std::max(1, eyes - 1) : eyes;
  model.baseline_mm = 2.0f * distance_mm * std::tan(0.5f * model.view_cone) / static_cast<float>(steps);
  model.cone_ends_included = false;
  return model;
}

}  // namespace

constinit const OpticsKindInfo multiview_kind{.name = kind_of(MultiView{}),
                                              .help = "a quilt of views",
                                              .takes = {"views", "camera-grid", "cone-ends"},
                                              .panel_size = quilt_size,
                                              .make_model = views_of_params};

const OpticsKindInfo& kind_info(const MultiView&) { return multiview_kind; }

}  // namespace lippmann
