#include "optics/plenoptic.hpp"

#include "core/json_fields.hpp"
#include "lippmann/optics/view_lens.hpp"
#include "optics/checks.hpp"
#include "optics/lens_params.hpp"
#include "optics/optics_kind.hpp"

namespace lippmann {
namespace {

MicrolensArray array_of(const PlenopticCamera& camera) {
  return {.packing = camera.packing,
          .lens_pitch_mm = camera.lens_pitch_mm,
          .gap_mm = camera.gap_mm,
          .offset_mm = camera.offset_mm,
          .viewing_distance_mm = static_cast<float>(array_distance_mm(camera))};
}

float row_share(LensPacking packing) { return packing == LensPacking::kHexagonal ? std::sqrt(0.75f) : 1.0f; }

}  // namespace

std::variant<SquarePlenopticRays, HexagonalPlenopticRays> make_rays(const Panel& panel, const PlenopticCamera& camera,
                                                                    float z_front_mm) {
  const float radius = 0.5f * camera.focal_length_mm / camera.f_number;
  const auto behind_main_lens = [&]<class LensRays>(const LensRays& lenses) -> PlenopticRays<LensRays> {
    return {lenses, static_cast<float>(array_distance_mm(camera)), 1.0f / camera.focal_length_mm,
            z_front_mm - camera.distance_mm, radius * radius};
  };
  const auto lenses = make_rays(panel, array_of(camera), 0.0f);
  if (const auto* hexagonal = std::get_if<HexagonalMicrolensRays>(&lenses))
    return HexagonalPlenopticRays{behind_main_lens(*hexagonal)};
  return SquarePlenopticRays{behind_main_lens(std::get<SquareMicrolensRays>(lenses))};
}

LIPPMANN_MULTIVERSION
void write_block(const SquarePlenopticRays& c, const RayFrame& frame, const float* px, const float* py, const RayArrays& rays) {
  write_ray_block(frame, px, py, rays, [&c](float x, float y) LIPPMANN_INLINE_LAMBDA { return crossing(c, x, y); });
}

LIPPMANN_MULTIVERSION
void write_block(const HexagonalPlenopticRays& c, const RayFrame& frame, const float* px, const float* py,
                 const RayArrays& rays) {
  write_ray_block(frame, px, py, rays, [&c](float x, float y) LIPPMANN_INLINE_LAMBDA { return crossing(c, x, y); });
}

void check_model(const Panel& panel, const PlenopticCamera& camera) {
  check_lens("plenoptic.lens_pitch_mm", camera.lens_pitch_mm, panel);
  check_length("plenoptic.gap_mm", camera.gap_mm);
  check_position("plenoptic.offset_mm.x", camera.offset_mm.x);
  check_position("plenoptic.offset_mm.y", camera.offset_mm.y);
  check_length("plenoptic.focal_length_mm", camera.focal_length_mm);
  check_number("plenoptic.f_number", camera.f_number, 0.05, 1e4);
  check_length("plenoptic.distance_mm", camera.distance_mm);
  check_position("plenoptic.array_shift_mm", camera.array_shift_mm);
  if (!(camera.distance_mm > 1.001f * camera.focal_length_mm))
    reject_field("plenoptic.distance_mm",
                 fmt::format("is {} mm, too near for a focal length of {} mm", camera.distance_mm, camera.focal_length_mm),
                 "more than the focal length of the main lens");
  if (!(array_distance_mm(camera) >= kMinLength))
    reject_field("plenoptic.array_shift_mm",
                 fmt::format("is {} mm, and puts the array in front of the main lens", camera.array_shift_mm),
                 fmt::format("more than -{} mm", image_distance_mm(camera.focal_length_mm, camera.distance_mm)));
}

void write_model(const PlenopticCamera& camera, nlohmann::ordered_json& json) {
  json["packing"] = camera.packing == LensPacking::kSquare ? "square" : "hexagonal";
  json["lens_pitch_mm"] = camera.lens_pitch_mm;
  json["gap_mm"] = camera.gap_mm;
  json["offset_mm"] = {camera.offset_mm.x, camera.offset_mm.y};
  json["focal_length_mm"] = camera.focal_length_mm;
  json["f_number"] = camera.f_number;
  json["distance_mm"] = camera.distance_mm;
  json["array_shift_mm"] = camera.array_shift_mm;
}

void read_model(const JsonFields& json, PlenopticCamera& camera) {
  json.require({"packing", "lens_pitch_mm", "gap_mm", "focal_length_mm", "f_number", "distance_mm"});
  camera.packing = json.word("packing", {"square", "hexagonal"}) == 0 ? LensPacking::kSquare : LensPacking::kHexagonal;
  camera.lens_pitch_mm = json.float_number("lens_pitch_mm");
  camera.gap_mm = json.float_number("gap_mm");
  if (json.has("offset_mm")) camera.offset_mm = json.pair("offset_mm");
  camera.focal_length_mm = json.float_number("focal_length_mm");
  camera.f_number = json.float_number("f_number");
  camera.distance_mm = json.float_number("distance_mm");
  camera.array_shift_mm = json.float_or("array_shift_mm", 0.0f);
}

OpticsFacts facts_of(const Panel& panel, const PlenopticCamera& camera) {
  OpticsFacts facts = facts_of_window(panel, camera.distance_mm);
  const double t = array_distance_mm(camera);
  const double scale = camera.distance_mm / (t + static_cast<double>(camera.gap_mm));
  facts.window_size_mm *= static_cast<float>(scale);
  facts.window.size *= scale;
  facts.samples.across_mm *= scale, facts.samples.down_mm *= scale;
  const MicrolensConstants<double> lenses = make_microlens(panel, array_of(camera), 0.0);
  facts.sensor_lenses = SensorLenses{
      lenses.columns.cell_px, lenses.rows.cell_px,
      Vec2d(lenses.columns.start_px, lenses.rows.start_px) + 0.5 * Vec2d(lenses.columns.cell_px, lenses.rows.cell_px),
      camera.packing};
  return facts;
}

Vec2f footprint_mm(const Panel& panel, const PlenopticCamera& camera, float z_mm) {
  const auto t = static_cast<float>(array_distance_mm(camera));
  const float distance = camera.distance_mm - z_mm, lens = camera.lens_pitch_mm * std::abs(distance) / t;
  const float eye_step = panel.pixel_pitch_mm * t / camera.gap_mm;
  const float pixel = eye_step * std::abs(1.0f - distance * (1.0f / camera.focal_length_mm - 1.0f / t));
  return {std::max(lens, pixel), std::max(lens * row_share(camera.packing), pixel)};
}

namespace {

constexpr double kDefaultFNumber = 2.0;

PanelSize sensor_size(const OpticsParams& params, Vec2i scene_resolution) {
  return microlens_kind.panel_size(params, scene_resolution);
}

/// The lengths b, e, s and f of a camera (see plenoptic.hpp) and its f-number n.
struct CameraLengths {
  double b, e = 0.0, s = 0.0, f = 0.0, n = 0.0;
  double t() const { return s + e; }
};

double given_image_distance(const ModelSetup& setup) {
  const double f = static_cast<double>(*setup.params.focal_length_mm), z = setup.viewing_distance_mm;
  if (!(z > 1.001 * f))
    throw usage_error("focal-length", fmt::format("is {:g} mm, but the plane in focus is only {:g} mm away", f, z),
                      "a shorter focal length, or a longer `viewing-distance`");
  return image_distance_mm(f, z);
}

/// Returns the gap between microlenses and sensor: the given gap or, if none is given, the given focal length of the
/// microlenses. If neither is given, returns the gap at which the images below the microlenses touch.
double gap_of(const ModelSetup& setup, double cell) {
  if (setup.params.gap_mm) return static_cast<double>(*setup.params.gap_mm);
  if (setup.params.lens_focal_length_mm) return static_cast<double>(*setup.params.lens_focal_length_mm);
  const double n = setup.f_number > 0.0f ? static_cast<double>(setup.f_number) : kDefaultFNumber;
  const double z = setup.viewing_distance_mm, pinhole = setup.pinhole_mm;
  if (setup.params.focal_length_mm) return cell * n * (1.0 + given_image_distance(setup) / z);
  return cell * n * (1.0 + pinhole / z) / (1.0 + cell * n / z);
}

CameraLengths camera_lengths(const ModelSetup& setup, double cell) {
  CameraLengths camera{gap_of(setup, cell)};
  if (const auto g = setup.params.lens_focal_length_mm; g && static_cast<double>(*g) != camera.b)
    camera.e = static_cast<double>(*g) * camera.b / (camera.b - static_cast<double>(*g));
  const double pinhole = setup.pinhole_mm;
  camera.s = setup.params.focal_length_mm ? given_image_distance(setup) : pinhole - camera.b - camera.e;
  if (!(camera.s > 0.0 && camera.t() > 0.0))
    throw usage_error(
        setup.params.lens_focal_length_mm ? "lens-focal-length" : "gap",
        fmt::format(
            "puts the microlenses {:.4g} mm and the image of the plane in focus {:.4g} mm behind the main lens, but both "
            "distances must be above 0",
            camera.t(), camera.s),
        "a smaller `gap`, or a `lens-focal-length` that differs more from `gap`");
  camera.f = setup.params.focal_length_mm ? static_cast<double>(*setup.params.focal_length_mm)
                                          : 1.0 / (1.0 / camera.s + 1.0 / static_cast<double>(setup.viewing_distance_mm));
  const bool is_matched = setup.params.gap_mm || setup.params.lens_focal_length_mm;
  camera.n = setup.f_number > 0.0f ? static_cast<double>(setup.f_number)
             : is_matched          ? camera.f * camera.b / (cell * camera.t())
                                   : kDefaultFNumber;
  const double image_px = camera.f / camera.n * camera.b / camera.t() / static_cast<double>(setup.panel.pixel_pitch_mm);
  if (image_px < 0.999)
    throw usage_error("f-number",
                      fmt::format("is {:.4g}: the image below each microlens is {:.2g} pixels wide", camera.n, image_px),
                      "a smaller `f-number`, or a longer `gap`");
  return camera;
}

OpticsModel camera_of_params(const ModelSetup& setup) {
  const Panel& panel = setup.panel;
  const float cell = setup.size.lens_pixels * panel.pixel_pitch_mm, row = cell * row_share(setup.params.packing);
  const CameraLengths lengths = camera_lengths(setup, static_cast<double>(cell));
  const auto pitch_per_cell = static_cast<float>(1.0 / (1.0 + lengths.b / lengths.t()));
  const Vec2f extent = Vec2f(panel.width, panel.height) * panel.pixel_pitch_mm;
  PlenopticCamera camera;
  camera.packing = setup.params.packing;
  camera.lens_pitch_mm = cell * pitch_per_cell;
  camera.gap_mm = static_cast<float>(lengths.b);
  camera.offset_mm =
      Vec2f(cell_center_nearest_middle(extent.x, cell), cell_center_nearest_middle(extent.y, row)) * pitch_per_cell;
  camera.focal_length_mm = static_cast<float>(lengths.f);
  camera.f_number = static_cast<float>(lengths.n);
  camera.distance_mm = setup.viewing_distance_mm;
  camera.array_shift_mm = static_cast<float>(lengths.e);
  return camera;
}

}  // namespace

constinit const OpticsKindInfo plenoptic_kind{
    .name = kind_of(PlenopticCamera{}),
    .help = "a camera with a main lens and microlenses before its sensor",
    .takes = {"lenses", "lens-pixels", "packing", "sensor-width", "focal-length", "gap", "lens-focal-length"},
    .has_parallax = false,
    .is_camera = true,
    .panel_size = sensor_size,
    .make_model = camera_of_params};

const OpticsKindInfo& kind_info(const PlenopticCamera&) { return plenoptic_kind; }

}  // namespace lippmann
