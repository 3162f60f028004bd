#include <algorithm>
#include <utility>

#include "archive.hpp"
#include "arrays.hpp"
#include "bindings.hpp"
#include "interruptible.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/core/parallel.hpp"
#include "lippmann/display/display.hpp"
#include "lippmann/formats/formats.hpp"
#include "lippmann/formats/kept_data.hpp"
#include "lippmann/formats/open_light_field.hpp"
#include "lippmann/formats/plenoptic_calibration.hpp"
#include "lippmann/image/encode.hpp"
#include "lippmann/image/tone.hpp"
#include "lippmann/layout/interlace.hpp"
#include "lippmann/layout/precompensate.hpp"
#include "lippmann/optics/crosstalk.hpp"
#include "lippmann/optics/viewing.hpp"
#include "lippmann/replay/disparity.hpp"
#include "lippmann/replay/epipolar_image.hpp"
#include "lippmann/replay/eye_view.hpp"
#include "lippmann/replay/light_field_frames.hpp"
#include "lippmann/replay/refocus.hpp"

namespace lippmann::python {
namespace {

using SharedField = std::shared_ptr<LightField>;
using SharedPanel = std::shared_ptr<RenderedPanel>;
using Pair = std::array<int, 2>;  ///< (rows, columns) of a grid, or (height, width) of a picture

std::vector<py::ssize_t> shape_of(const LightField& field) {
  return {field.grid.rows, field.grid.columns, field.view_size.y, field.view_size.x};
}

/// Returns the views as an array (rows, columns, y, x, channel) without a copy. Row 0 is the lowest.
py::array views_array(const SharedField& field) {
  std::vector<py::ssize_t> shape = shape_of(*field);
  shape.push_back(3);
  if (const auto* image = std::get_if<Image>(&field->stack)) return view_of(image->data.data(), shape, field);
  if (const auto* codes = std::get_if<Image16>(&field->stack)) return view_of(codes->rgb.data(), shape, field);
  return view_of(std::get<Image8>(field->stack).rgb.data(), shape, field);
}

py::object depth_of_views(const SharedField& field) {
  if (!field->depth) return py::none();
  return view_of(field->depth->data.data(), shape_of(*field), field);
}

/// Returns (camera distance in mm, pixel (height, width) in mm, eyes (rows, columns, 2)), or None if the cameras are unknown.
py::object cameras_of(const LightField& field) {
  if (!field.cameras) return py::none();
  std::vector<double> eyes;
  for (const Vec2d& eye : field.cameras->eyes_mm) eyes.push_back(eye.x), eyes.push_back(eye.y);
  const Vec2d pixel = field.cameras->pixel_mm;
  return py::make_tuple(field.cameras->distance_mm, py::make_tuple(pixel.y, pixel.x),
                        moved(std::move(eyes), {field.grid.rows, field.grid.columns, 2}));
}

/// Returns (rows, columns, 4, 4) transforms from each camera to world space, and (rows, columns, 4) focal lengths and principal
/// points. Returns None if the poses are unknown.
py::object poses_of(const LightField& field) {
  if (!field.cameras && !field.poses) return py::none();
  std::vector<double> matrices, intrinsics;
  for (const PosedCamera& camera : posed_cameras(field, "cameras")) {
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) matrices.push_back(camera.rotation[column][row]);
      matrices.push_back(camera.position_mm[row]);
    }
    matrices.insert(matrices.end(), {0.0, 0.0, 0.0, 1.0});
    for (const Vec2d& pair : {camera.focal_px, camera.principal_px}) intrinsics.push_back(pair.x), intrinsics.push_back(pair.y);
  }
  return py::make_tuple(moved(std::move(matrices), {field.grid.rows, field.grid.columns, 4, 4}),
                        moved(std::move(intrinsics), {field.grid.rows, field.grid.columns, 4}));
}

template <class T>
void copy_codes(const py::array& views, T& image) {
  using Sample = typename decltype(image.rgb)::value_type;
  const auto samples = Array<Sample>(views);
  image.rgb.assign(samples.data(), samples.data() + samples.size());
}

Picture stack_of(const py::array& views, Vec2i size) {
  if (py::isinstance<py::array_t<std::uint8_t>>(views)) {
    Image8 codes{size.x, size.y, {}};
    return copy_codes(views, codes), codes;
  }
  if (py::isinstance<py::array_t<std::uint16_t>>(views)) {
    Image16 codes{size.x, size.y, {}};
    return copy_codes(views, codes), codes;
  }
  const auto samples = Array<float>(views);
  Image image(size.x, size.y, 3);
  std::copy_n(samples.data(), image.data.size(), image.data.begin());
  return image;
}

/// Requires arrays that lippmann.LightField has checked. views: (rows, columns, y, x, 3). depth: (rows, columns, y, x).
SharedField field_of(const py::array& views, const std::optional<Array<float>>& depth) {
  require_shape(views, {-1, -1, -1, -1, 3}, "views");
  auto field = std::make_shared<LightField>();
  field->grid = {static_cast<int>(views.shape(1)), static_cast<int>(views.shape(0))};
  field->view_size = {static_cast<int>(views.shape(3)), static_cast<int>(views.shape(2))};
  field->aspect = static_cast<double>(field->view_size.x) / field->view_size.y;
  const Vec2i size = stack_size(*field);
  field->stack = stack_of(views, size);
  if (!depth) return field;
  require_shape(*depth, {views.shape(0), views.shape(1), views.shape(2), views.shape(3)}, "depth");
  field->depth = Image(size.x, size.y, 1);
  std::copy_n(depth->data(), field->depth->data.size(), field->depth->data.begin());
  return field;
}

void set_cameras(LightField& field, double distance_mm, std::array<double, 2> baseline_mm, double pixel_mm) {
  ViewCameras cameras;
  cameras.distance_mm = distance_mm;
  cameras.pixel_mm = Vec2d(pixel_mm);
  cameras.centre_px = 0.5 * Vec2d(field.view_size);
  for (int row = 0; row < field.grid.rows; ++row)
    for (int column = 0; column < field.grid.columns; ++column)
      cameras.eyes_mm.push_back(
          {(column - 0.5 * (field.grid.columns - 1)) * baseline_mm[1], (row - 0.5 * (field.grid.rows - 1)) * baseline_mm[0]});
  field.cameras = std::move(cameras);
}

/// world_from_camera: a matrix (4, 4) for each view. intrinsics: fx, fy, cx, cy of each view.
void set_poses(LightField& field, const Array<double>& world_from_camera, const Array<double>& intrinsics) {
  const int views = field.grid.count();
  require_shape(world_from_camera, {views, 4, 4}, "world_from_camera");
  require_shape(intrinsics, {views, 4}, "intrinsics_px");
  std::vector<PosedCamera> cameras;
  for (int view = 0; view < views; ++view) {
    const double* matrix = world_from_camera.data() + 16 * view;
    const double* lengths = intrinsics.data() + 4 * view;
    const double rows[9] = {matrix[0], matrix[1], matrix[2], matrix[4], matrix[5], matrix[6], matrix[8], matrix[9], matrix[10]};
    const std::string where = "world_from_camera: (" + std::to_string(view / field.grid.columns) + ", " +
                              std::to_string(view % field.grid.columns) + ")";
    cameras.push_back({field.view_size,
                       {lengths[0], lengths[1]},
                       {lengths[2], lengths[3]},
                       checked_rotation(rows, where),
                       {matrix[3], matrix[7], matrix[11]}});
  }
  field.poses = std::move(cameras);
}

/// Names of Split, in its order.
constexpr std::array kSplitNames{"train", "validation", "test"};

/// Returns the name of each view's split, or None if the file has no split.
py::object splits_of(const LightField& field) {
  if (!field.splits) return py::none();
  py::list names;
  for (const Split split : *field.splits) names.append(kSplitNames[static_cast<std::size_t>(split)]);
  return names;
}

/// Requires one of kSplitNames for each view.
void set_splits(LightField& field, const std::vector<std::string>& names) {
  field.splits.emplace();
  for (const std::string& name : names)
    field.splits->push_back(static_cast<Split>(std::find(kSplitNames.begin(), kSplitNames.end(), name) - kSplitNames.begin()));
}

/// Returns a sentence on the optics that panel_of_field() assumes for cameras that do not share a plane and a window, or an
/// empty text for other cameras.
std::string assumption_about_poses(const LightField& field, const std::string& where) {
  if (!field.poses || field.grid.count() == 1) return {};
  return describe_assumed_optics(field, assumed_optics(field, std::nullopt), std::nullopt, where) + ".";
}

/// Converts the views from linear floats to codes of 8 or 16 bits.
SharedField with_codes(const LightField& field, int bits, const Tone& tone) {
  auto copy = std::make_shared<LightField>(field);
  Image linear = to_linear(std::move(copy->stack));
  apply_tone(tone, linear);
  if (bits == 8)
    copy->stack = to_codes(linear, Encoding::kSrgb);
  else
    copy->stack = to_codes16(linear, Encoding::kSrgb);
  return copy;
}

std::optional<ViewGrid> grid_of(const std::optional<Pair>& pair) {
  return pair ? std::optional(ViewGrid{(*pair)[1], (*pair)[0]}) : std::nullopt;
}

FormatOptions format_options(const std::optional<Pair>& views, const std::optional<Pair>& tiles,
                             const std::optional<Display>& display) {
  FormatOptions options;
  options.views = grid_of(views), options.tiles = grid_of(tiles), options.display = display;
  options.with_depth = true;
  return options;
}

void set_stated_cameras(FormatOptions& options, double baseline_mm, double focal_length_mm, double sensor_width_mm,
                        double focus_distance_mm) {
  options.cameras = StatedCameras{baseline_mm, focal_length_mm, sensor_width_mm, focus_distance_mm};
}

void set_plenoptic(FormatOptions& options, const PlenopticSettings& settings) {
  const py::gil_scoped_release release;
  options.plenoptic = read_plenoptic_settings(settings).calibration;
}

std::vector<std::filesystem::path> save(const LightField& field, const std::filesystem::path& path, const std::string& format,
                                        const FormatOptions& options) {
  const py::gil_scoped_release release;
  return find_output_format(format, "format").write(field, path, options);
}

/// Returns descriptions of the data that save() leaves out.
std::vector<std::string> lost(const LightField& field, const std::string& format) {
  std::vector<std::string> descriptions;
  for (LostData& data : lost_data(field, find_output_format(format, "format").name))
    descriptions.push_back(std::move(data.description));
  return descriptions;
}

py::tuple open(const std::filesystem::path& path, const std::string& format, FormatOptions options) {
  OpenedLightField opened;
  Interruptible(0).run(py::none(), [&](const Context& context) {
    options.warn = context.warn;
    opened = open_light_field(path, format, options);
  });
  return py::make_tuple(std::make_shared<LightField>(std::move(opened.field)), opened.optics, std::string(opened.format));
}

/// If `optics` is empty, derives optics from the cameras of the views, or assumes some if the cameras are unknown.
SharedPanel panel_of_field(const LightField& field, const std::optional<Optics>& optics,
                           const std::optional<double>& view_angle_deg) {
  const py::gil_scoped_release release;
  const Optics shown = optics                   ? *optics
                       : has_camera_grid(field) ? optics_of_cameras(field, "cameras")
                                                : assumed_optics(field, view_angle_deg);
  return std::make_shared<RenderedPanel>(panel_of(field, shown, "views"));
}

Vec2i size_of(const std::optional<Pair>& size) { return size ? Vec2i((*size)[1], (*size)[0]) : Vec2i(0, 0); }

void require_size(const std::optional<Pair>& size) {
  constexpr int kMost = 32768;
  if (!size) return;
  for (const int side : *size)
    if (side < 1 || side > kMost)
      throw Error("size", "has a side of " + std::to_string(side) + " pixels", "(height, width), 1 to 32768 pixels each");
}

py::array refocused(const RenderedPanel& panel, double z_mm, const std::optional<Pair>& size) {
  require_size(size);
  validate_depth(panel.optics, z_mm, "z_mm");
  Image picture;
  Interruptible(0).run(py::none(), [&](const Context& context) {
    picture = refocus(panel, z_mm, size_of(size), ThreadPool(resolved_threads(context)), nullptr, context);
  });
  return moved(std::move(picture));
}

py::array seen(const RenderedPanel& panel, const std::array<double, 3>& eye_mm, const std::optional<Pair>& size,
               double pupil_mm, double focus_mm, bool nearest, double crosstalk_px) {
  require_size(size);
  EyeView view;
  view.eye_mm = {eye_mm[0], eye_mm[1], eye_mm[2]};
  view.size = size_of(size);
  view.pupil_mm = pupil_mm, view.focus_mm = focus_mm;
  view.crosstalk_px = crosstalk_px;
  view.filter = nearest ? SampleFilter::kNearest : SampleFilter::kLinear;
  validate(view);
  Image picture;
  Interruptible(0).run(py::none(), [&](const Context& context) {
    picture = eye_view(panel, view, ThreadPool(resolved_threads(context)), context);
  });
  return moved(std::move(picture));
}

py::array panel_array(const SharedPanel& panel) {
  const Image& picture = panel->picture;
  return view_of(picture.data.data(), {picture.height, picture.width, picture.channels}, panel);
}

/// Writes .exr files with linear floats, and all other files with sRGB codes. `tone` has no effect on .exr files.
void write_panel(const RenderedPanel& panel, const std::filesystem::path& path, const Tone& tone,
                 std::optional<double> crosstalk_px) {
  const py::gil_scoped_release release;
  const bool is_linear = path.extension() == ".exr";
  Image picture = panel.picture;
  if (!is_linear) apply_tone(tone, picture);
  if (crosstalk_px) precompensate(panel.optics, *crosstalk_px, "precompensate", picture);
  if (is_linear) return write_picture(path, picture);
  write_picture(path, to_codes(picture, Encoding::kSrgb));
}

template <class Function>
py::array epipolar(const RenderedPanel& panel, int line, Function function) {
  Image picture;
  Interruptible(0).run(py::none(),
                       [&](const Context& context) { picture = function(panel, line, SampleFilter::kLinear, context); });
  return moved(std::move(picture));
}

std::vector<std::pair<std::string, std::string>> format_lines() {
  std::vector<std::pair<std::string, std::string>> lines;
  for (const LightFieldFormat& format : light_field_formats()) lines.emplace_back(format.name, format.description);
  return lines;
}

py::array codes_of(const Array<float>& linear, const Tone& tone) {
  Image toned = image_of(linear, 3, "picture");
  apply_tone(tone, toned);
  const Image8 codes = to_codes(toned, Encoding::kSrgb);
  return moved(std::vector<std::uint8_t>(codes.rgb), {codes.height, codes.width, 3});
}

Tone tone_named(float exposure_ev, const std::string& curve) {
  const auto found = std::find(kToneNames.begin(), kToneNames.end(), curve);
  if (found == kToneNames.end()) throw Error("tone", "is '" + curve + "'", "none, neutral or agx");
  return {exposure_ev, static_cast<ToneCurve>(found - kToneNames.begin())};
}

void bind_options(py::module_& module) {
  py::class_<Tone>(module, "Tone").def(py::init(&tone_named)).def_property_readonly("is_identity", &Tone::is_identity);
  module.attr("split_names") = py::tuple(py::cast(std::vector<std::string>(kSplitNames.begin(), kSplitNames.end())));
  module.attr("tone_names") = py::tuple(py::cast(std::vector<std::string>(kToneNames.begin(), kToneNames.end())));
  py::class_<PlenopticSettings>(module, "PlenopticSettings")
      .def(py::init())
      .def_readwrite("white", &PlenopticSettings::white)
      .def_readwrite("pitch_px", &PlenopticSettings::pitch_px)
      .def_readwrite("row_pitch_px", &PlenopticSettings::row_pitch_px)
      .def_readwrite("rotation_deg", &PlenopticSettings::rotation_deg)
      .def("set_offset_px",
           [](PlenopticSettings& settings, double x, double y) {
             settings.offset_px = {x, y};
           })
      .def_readwrite("arrangement", &PlenopticSettings::arrangement)
      .def_readwrite("lanczos", &PlenopticSettings::lanczos)
      .def_readwrite("inverted", &PlenopticSettings::inverted);
  py::class_<FormatOptions>(module, "FormatOptions")
      .def(py::init(&format_options))
      .def_readwrite("binary", &FormatOptions::binary)
      .def_readwrite("png", &FormatOptions::png)
      .def("set_cameras", &set_stated_cameras)
      .def("set_plenoptic", &set_plenoptic);
}

}  // namespace

void bind_light_field(py::module_& module) {
  bind_options(module);
  py::class_<LightField, SharedField>(module, "Views")
      .def(py::init(&field_of))
      .def(pickled<LightField>())
      .def("set_cameras", &set_cameras)
      .def("set_poses", &set_poses)
      .def("set_splits", &set_splits)
      .def("assumption_about_poses", &assumption_about_poses)
      .def_property_readonly("views", &views_array)
      .def_property_readonly("depth", &depth_of_views)
      .def_property_readonly("cameras", &cameras_of)
      .def_property_readonly("poses", &poses_of)
      .def_property_readonly("splits", &splits_of)
      .def_property_readonly("aspect", [](const LightField& f) { return f.aspect; })
      .def("with_codes", &with_codes)
      .def("save", &save)
      .def("lost", &lost)
      .def("panel", &panel_of_field);

  py::class_<RenderedPanel, SharedPanel>(module, "Panel")
      .def(pickled<RenderedPanel>())
      .def_property_readonly("picture", &panel_array)
      .def_property_readonly("optics", [](const RenderedPanel& p) { return p.optics; })
      .def("write", &write_panel)
      .def("refocus", &refocused)
      .def("depth_of_disparity", [](const RenderedPanel& p,
                                    double disparity_px) { return depth_of_disparity_px(p.optics, disparity_px, "disparity"); })
      .def("eye", &seen)
      .def("epi_row", [](const RenderedPanel& p, int row) { return epipolar(p, row, epipolar_row); })
      .def("epi_column", [](const RenderedPanel& p, int column) { return epipolar(p, column, epipolar_column); });

  module.def("open_light_field", &open);
  module.def("light_fields_in", &light_fields_in);
  module.def("formats", &format_lines);
  module.def("codes_of", &codes_of);
  module.def("read_crosstalk", [](const std::string& text) { return read_crosstalk(text, "crosstalk"); });
  module.def("write_picture", [](const Array<float>& picture, const std::filesystem::path& path) {
    const Image linear = image_of(picture, 3, "picture");
    const py::gil_scoped_release release;
    if (path.extension() == ".exr") return write_picture(path, linear);
    write_picture(path, to_codes(linear, Encoding::kSrgb));
  });
}

}  // namespace lippmann::python
