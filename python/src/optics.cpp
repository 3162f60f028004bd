#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "archive.hpp"
#include "arrays.hpp"
#include "bindings.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/display/load_display.hpp"
#include "lippmann/optics/optics.hpp"
#include "lippmann/optics/optics_of_kind.hpp"
#include "lippmann/optics/viewing.hpp"
#include "lippmann/stage/placement.hpp"

namespace lippmann::python {
namespace {

Optics checked(Panel panel, OpticsModel model) {
  Optics optics;
  optics.panel = panel;
  optics.model = std::move(model);
  validate(optics);
  return optics;
}

/// If baseline_mm > 0, the eyes form a grid with this spacing. Otherwise the eyes are spread over the angle cone_deg.
Optics views(Vec2i grid, Vec2i view, float pixel_mm, float cone_deg, float distance_mm, float baseline_mm) {
  MultiView model;
  model.columns = grid.x, model.rows = grid.y;
  model.view_cone = radians(cone_deg);
  model.distance_mm = distance_mm;
  model.baseline_mm = baseline_mm;
  return checked({grid.x * view.x, grid.y * view.y, pixel_mm}, model);
}

Optics lenticular_sheet(Vec2i size, float pixel_mm, float lens_pitch_mm, float gap_mm, float slant_deg, float offset_mm,
                        float viewing_distance_mm) {
  LenticularSheet sheet;
  sheet.lens_pitch_mm = lens_pitch_mm, sheet.gap_mm = gap_mm, sheet.offset_mm = offset_mm;
  sheet.slant = radians(slant_deg);
  sheet.viewing_distance_mm = viewing_distance_mm;
  return checked({size.x, size.y, pixel_mm}, sheet);
}

Optics microlens_array(Vec2i size, float pixel_mm, float lens_pitch_mm, float gap_mm, bool hexagonal, float offset_mm,
                       float viewing_distance_mm) {
  MicrolensArray array;
  array.packing = hexagonal ? LensPacking::kHexagonal : LensPacking::kSquare;
  array.lens_pitch_mm = lens_pitch_mm, array.gap_mm = gap_mm, array.offset_mm = Vec2f(offset_mm);
  array.viewing_distance_mm = viewing_distance_mm;
  return checked({size.x, size.y, pixel_mm}, array);
}

Optics single_view(Vec2i size, float pixel_mm, float distance_mm) {
  return checked({size.x, size.y, pixel_mm}, SingleView{distance_mm, {}});
}

/// Makes optics from a table of rays, with samples_per_side squared rays per pixel. Origins are in mm.
Optics ray_table(Vec2i size, float pixel_mm, int samples_per_side, float spread, const Array<float>& origins,
                 const Array<float>& directions) {
  const std::vector<Vec3f> from = vectors_of<Vec3f>(origins, "origins"), to = vectors_of<Vec3f>(directions, "directions");
  if (from.size() != to.size()) throw Error("directions", "differ in number from the origins", "as many as origins");
  auto rays = std::make_shared<std::vector<Ray>>(from.size());
  for (std::size_t i = 0; i < from.size(); ++i) (*rays)[i] = {from[i], to[i]};
  return checked({size.x, size.y, pixel_mm}, RayTable{std::move(rays), samples_per_side, spread});
}

using Pair = std::array<int, 2>;  ///< (rows, columns) of a grid, or (height, width) of a picture
Vec2i xy(const Pair& pair) { return {pair[1], pair[0]}; }

py::tuple rays_of(const Optics& optics, const Array<float>& pixels) {
  const std::vector<Vec2f> points = vectors_of<Vec2f>(pixels, "pixels");
  std::vector<float> origins, directions;
  for (const Vec2f& point : points) {
    const Ray ray = ray_of_pixel(optics, point);
    for (int c = 0; c < 3; ++c) origins.push_back(ray.origin[c]), directions.push_back(ray.direction[c]);
  }
  const auto count = static_cast<py::ssize_t>(points.size());
  return py::make_tuple(moved(std::move(origins), {count, 3}), moved(std::move(directions), {count, 3}));
}

std::array<double, 3> eye_of(const Optics& optics) {
  const Vec3d eye = default_eye_mm(optics);
  return {eye.x, eye.y, eye.z};
}

ViewWish wish_of(const std::string& focus, const std::string& fit_to, float zoom, const std::array<float, 2>& orbit_deg) {
  return {focus, fit_to, zoom, {orbit_deg[0], orbit_deg[1]}};
}

Pair panel_size(const Display& display) { return {display.pixels.y, display.pixels.x}; }

std::optional<Pair> tiles_of(const Display& display) {
  return display.quilt ? std::optional(Pair{display.quilt->rows, display.quilt->columns}) : std::nullopt;
}

double aspect_of(const Display& display) {
  return display.quilt ? display.quilt->aspect : static_cast<double>(display.pixels.x) / display.pixels.y;
}

Pair picture_shape(const Optics& optics) { return {picture_size(optics).y, picture_size(optics).x}; }

std::array<float, 2> window_of(const Optics& optics) { return {window_size_mm(optics).y, window_size_mm(optics).x}; }

std::string size_text(const Pair& size) { return std::to_string(size[1]) + "x" + std::to_string(size[0]) + " pixels"; }

std::string display_text(const Display& display) {
  const auto name = py::repr(decoded(display.name)).cast<std::string>();
  return "<lippmann.Display " + name + ": " + to_string(display.kind) + ", " + size_text(panel_size(display)) + ">";
}

std::string views_text(const ViewTiles& tiles) {
  if (!tiles.camera_grid) return std::to_string(tiles.count()) + " views";
  return std::to_string(tiles.rows) + " x " + std::to_string(tiles.columns) + " views (rows x columns)";
}

std::string lenses_text(const Optics& optics) {
  if (sub_pixels_per_pixel(optics) > 1) return "a slanted panel";
  const std::optional<LensArray> lenses = lens_array(optics);
  if (!lenses) return kind_name(optics) == "rays" ? "custom rays" : std::string(kind_name(optics));
  return lenses->row_pitch_mm > 0.0 ? "a microlens array" : "a lenticular sheet";
}

std::string optics_text(const Optics& optics) {
  const std::optional<ViewTiles> tiles = view_tiles(optics);
  const std::string what = tiles ? views_text(*tiles) : is_single_view(optics) ? "a single view" : lenses_text(optics);
  return "<lippmann.Optics: " + what + ", " + size_text(picture_shape(optics)) + ">";
}

void bind_display(py::module_& module) {
  py::class_<Display>(module, "Display",
                      "A display: a preset, a file of your own, or a device's calibration (lippmann.display).")
      .def("__repr__", &display_text)
      .def(pickled<Display>())
      .def_property_readonly(
          "name", [](const Display& d) { return decoded(d.name); }, "Name of the preset, or of the file without its extension.")
      .def_property_readonly(
          "description", [](const Display& d) { return decoded(d.description); }, "One-line description.")
      .def_property_readonly(
          "kind", [](const Display& d) { return to_string(d.kind); }, "slanted-panel, lenticular-sheet or microlens-array.")
      .def_property_readonly("size", &panel_size, "[height, width] of the panel in pixels.")
      .def_readonly("dpi", &Display::dpi, "Pixels per inch.")
      .def_readonly("view_cone_deg", &Display::view_cone_deg, "Full angle of all views, in degrees.")
      .def_property_readonly(
          "viewing_distance_mm", [](const Display& d) { return viewing_distance_mm(d); }, "Distance of the viewer.")
      .def_property_readonly("view_count", &views_of, "Number of views.")
      .def_property_readonly("tiles", &tiles_of, "[rows, columns] of its quilt; None: it has none.")
      .def_property_readonly("aspect", &aspect_of, "Width / height.")
      .def_readonly("crosstalk_px", &Display::crosstalk_px, "Blur of its lenses: sigma in pixels of the panel; None: unknown.");
  module.def("crosstalk_of_picture", &crosstalk_of_picture);
  module.def("load_display", &load_display);
  module.def("display_from_toml", [](const std::string& text) { return display_from_toml(text, "text"); });
  module.def("display_presets", &display_presets);
}

}  // namespace

void bind_optics(py::module_& module) {
  bind_display(module);
  py::class_<Optics>(module, "Optics", "The ray of every pixel of a panel (lippmann.camera_grid, lippmann.quilt, ...).")
      .def("__repr__", &optics_text)
      .def(pickled<Optics>())
      .def_property_readonly("size", &picture_shape, "[height, width] of the panel's picture in pixels.")
      .def_property_readonly(
          "is_views", [](const Optics& o) { return view_tiles(o).has_value(); },
          "Whether the picture consists of views side by side.")
      .def_property_readonly(
          "is_single_view", [](const Optics& o) { return is_single_view(o); }, "Whether the picture is a single view.")
      .def_property_readonly("window_mm", &window_of, "[height, width] of the visible part of the display's plane.")
      .def_property_readonly("default_eye_mm", &eye_of, "[x, y, z]: the intended viewing position.")
      .def_property_readonly("depth_budget_mm", &depth_budget_mm,
                             "Depth in front of and behind its plane that is shown sharply.")
      .def("rays", &rays_of,
           "Returns origins (n, 3), mm, and unit directions (n, 3) of the rays of points (n, 2) of the panel: x, y in pixels "
           "from its "
           "top left corner, centres at + 0.5.");
  module.def("optics_kinds", &optics_kind_names);
  module.def("optics", [](const std::string& kind, const Pair& size, float pixel_mm, const std::string& members) {
    return optics_of_kind(kind, {size[1], size[0], pixel_mm}, members);
  });
  module.def("views",
             [](const Pair& grid, const Pair& view, float pixel_mm, float cone_deg, float distance_mm, float baseline_mm) {
               return views(xy(grid), xy(view), pixel_mm, cone_deg, distance_mm, baseline_mm);
             });
  module.def("lenticular_sheet",
             [](const Pair& size, float pixel_mm, float pitch, float gap, float slant, float offset, float distance) {
               return lenticular_sheet(xy(size), pixel_mm, pitch, gap, slant, offset, distance);
             });
  module.def("microlens_array",
             [](const Pair& size, float pixel_mm, float pitch, float gap, bool hexagonal, float offset, float distance) {
               return microlens_array(xy(size), pixel_mm, pitch, gap, hexagonal, offset, distance);
             });
  module.def("single_view",
             [](const Pair& size, float pixel_mm, float distance) { return single_view(xy(size), pixel_mm, distance); });
  module.def("ray_table", [](const Pair& size, float pixel_mm, int samples, float spread, const Array<float>& origins,
                             const Array<float>& directions) {
    return ray_table(xy(size), pixel_mm, samples, spread, origins, directions);
  });

  py::class_<Placement>(module, "Placement")
      .def(pickled<Placement>())
      .def_property_readonly("optics", [](const Placement& p) { return p.placed.optics; })
      .def_property_readonly("units_per_mm", [](const Placement& p) { return p.placed.units_per_mm; })
      .def_property_readonly("depth_scale", [](const Placement& p) { return p.placed.depth_scale; })
      .def_property_readonly("how", [](const Placement& p) { return decoded(p.array.how); });
  py::class_<ViewWish>(module, "ViewWish").def(py::init(&wish_of)).def(pickled<ViewWish>());
  module.def("place",
             [](const Scene& scene, const Optics& optics, std::optional<bool> fit_depth, const ViewWish& view, bool at_camera) {
               return place(scene, optics, PlacementWish{view, fit_depth, at_camera});
             });
  module.def("place_display",
             [](const Scene& scene, const Display& display, bool native, std::optional<bool> fit_depth, const ViewWish& view) {
               return place(scene, display, native ? DisplayPicture::kNative : DisplayPicture::kQuilt, {view, fit_depth});
             });
}

}  // namespace lippmann::python
