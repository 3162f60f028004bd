#include "job/params_table.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <array>
#include <limits>
#include <span>
#include <string>
#include <utility>

#include "core/suggest.hpp"
#include "formats/frame_names.hpp"
#include "job/param_text.hpp"
#include "job/removed_params.hpp"
#include "job/reuse_params.hpp"
#include "job/scene_light.hpp"
#include "lippmann/formats/formats.hpp"
#include "lippmann/image/tone.hpp"
#include "lippmann/optics/crosstalk.hpp"
#include "lippmann/trace/aovs.hpp"
#include "optics/optics_kind.hpp"
#include "stage/read_view_wish.hpp"

namespace lippmann {
namespace {

using Values = std::vector<std::string>;

constexpr std::array<std::string_view, 6> kUpNames{"y", "x", "z", "-x", "-y", "-z"};
constexpr std::array<std::string_view, 2> kPackingNames{"square", "hexagonal"};
constexpr std::array<std::string_view, 3> kOrderNames{"rows", "columns", "view-tiles"};
constexpr std::array<std::string_view, 4> kReuseNames{"auto", "none", "copy", "interpolate"};
constexpr std::array<std::string_view, 2> kDenoiseNames{"auto", "none"};
constexpr std::array<std::string_view, 2> kAngularNames{"none", "box"};
constexpr std::array<std::string_view, 2> kSplatNames{"lens", "view"};
constexpr std::array<std::string_view, 2> kFillNames{"interpolate", "retrace"};
constexpr std::array<std::string_view, 2> kDebugNames{"none", "missed"};
constexpr std::array<std::string_view, 4> kFormatNames{"png", "png16", "tiff", "exr"};
constexpr std::array<std::string_view, 7> kLayoutNames{"integral", "quilt", "views", "native", "print", "stereo", "rgbd"};
constexpr std::array<std::string_view, 1> kCompanionNames{"single"};
constexpr std::array<std::string_view, 2> kExrPixelNames{"half", "float"};
constexpr std::array<std::string_view, 2> kDepthScaleNames{"disparity", "depth"};
/// All layers except alpha. Alpha is the last layer, and is selected by the parameter `transparent`.
const std::span<const std::string_view> kWantedAovNames(kAovNames.data(), kAovs - 1);

/// Maximum number of pixels or lenses along one side. panel_size() limits the size of the whole panel.
constexpr int kMaxCount = 1 << 20;

template <class T>
struct Codec {
  std::function<T(std::string_view, const std::string& where)> read;
  std::function<std::string(const T&)> write;
  /// Accepted words; empty: values are not from a list of words.
  std::vector<std::string_view> choices = {};
};

Codec<std::string> text() {
  return {[](std::string_view value, const std::string&) { return std::string(value); },
          [](const std::string& value) { return value; }};
}

template <class T>
Codec<T> integer(std::int64_t lowest, std::int64_t highest) {
  return {[=](std::string_view value, const std::string& where) {
            return static_cast<T>(read_integer(value, lowest, highest, where));
          },
          [](const T& value) { return fmt::format("{}", value); }};
}

template <class T>
Codec<T> number(double lowest, double highest) {
  return {[=](std::string_view value, const std::string& where) {
            return static_cast<T>(read_number(value, lowest, highest, where));
          },
          [](const T& value) { return fmt::format("{}", value); }};
}

Codec<bool> flag() {
  return {read_flag, [](const bool& value) { return std::string(value ? "true" : "false"); }};
}

template <class T>
Codec<Extent<T>> extent(T lowest, T highest) {
  return {[=](std::string_view value, const std::string& where) { return read_extent(value, lowest, highest, where); },
          [](const Extent<T>& value) { return value.x == T{0} ? std::string() : write_extent(value); }};
}

/// Reads WxH. A single number sets width and height.
Codec<Extent<int>> full_extent(int highest) {
  Codec<Extent<int>> codec = extent(1, highest);
  codec.read = [highest](std::string_view value, const std::string& where) {
    Extent<int> both = read_extent(value, 1, highest, where);
    if (both.y == 0) both.y = both.x;
    return both;
  };
  return codec;
}

template <class E, std::size_t N>
Codec<E> choice(const std::array<std::string_view, N>& names) {
  return {
      [&names](std::string_view value, const std::string& where) { return static_cast<E>(read_choice(value, names, where)); },
      [&names](const E& value) { return std::string(names[static_cast<std::size_t>(value)]); },
      {names.begin(), names.end()}};
}

/// Also accepts the names in job files of earlier versions.
Codec<ReuseChoice> reuse_choice() {
  Codec<ReuseChoice> codec = choice<ReuseChoice>(kReuseNames);
  codec.read = [by_name = codec.read](std::string_view value, const std::string& where) {
    if (value == "exact") return ReuseChoice::kAuto;
    return value == "forward" ? ReuseChoice::kInterpolate : by_name(value, where);
  };
  return codec;
}

/// Also accepts true and false, as in job files of earlier versions.
Codec<Denoise> denoise_choice() {
  Codec<Denoise> codec = choice<Denoise>(kDenoiseNames);
  codec.read = [by_name = codec.read](std::string_view value, const std::string& where) {
    if (value == "true") return Denoise::kAuto;
    return value == "false" ? Denoise::kNone : by_name(value, where);
  };
  return codec;
}

Codec<std::optional<bool>> optional_flag() {
  return {[](std::string_view value, const std::string& where) { return std::optional(read_flag(value, where)); },
          [](const std::optional<bool>& value) { return value ? std::string(*value ? "true" : "false") : std::string(); }};
}

template <class T>
Codec<std::optional<T>> optional_number(double lowest, double highest) {
  const Codec<T> codec = number<T>(lowest, highest);
  return {[codec](std::string_view value, const std::string& where) { return std::optional<T>(codec.read(value, where)); },
          [codec](const std::optional<T>& value) { return value ? codec.write(*value) : std::string(); }};
}

template <class E, std::size_t N>
Codec<std::optional<E>> optional_choice(const std::array<std::string_view, N>& names) {
  const Codec<E> made = choice<E>(names);
  return {[made](std::string_view value, const std::string& where) { return std::optional<E>(made.read(value, where)); },
          [made](const std::optional<E>& value) { return value ? made.write(*value) : std::string(); }, made.choices};
}

Codec<std::optional<OpticsKind>> optics_kind_name() {
  std::vector<std::string_view> names;
  for (const OpticsKind kind : optics_kinds()) names.push_back(kind.info().name);
  const auto read = [names](std::string_view value, const std::string& where) {
    return std::optional(optics_kinds()[read_choice(value, names, where)]);
  };
  const auto write = [](const std::optional<OpticsKind>& value) {
    return value ? std::string(value->info().name) : std::string();
  };
  return {read, write, names};
}

Codec<std::optional<Integrator>> integrator_name() {
  std::vector<std::string_view> names;
  for (const Integrator integrator : integrators()) names.push_back(integrator.facts().name);
  const auto read = [names](std::string_view value, const std::string& where) {
    return std::optional(integrators()[read_choice(value, names, where)]);
  };
  const auto write = [](const std::optional<Integrator>& value) {
    return value ? std::string(value->facts().name) : std::string();
  };
  return {read, write, names};
}

Codec<std::optional<CameraSet>> camera_set() {
  return {[](std::string_view value, const std::string& where) {
            return std::optional(read_camera_set(std::string(value), where));
          },
          [](const std::optional<CameraSet>& value) { return value ? write_camera_set(*value) : std::string(); }};
}

Codec<std::string> light_field_name() {
  return {[](std::string_view value, const std::string& where) { return std::string(find_output_format(value, where).name); },
          [](const std::string& value) { return value; }};
}

struct Documentation {
  std::string_view name, group, type, doc;
};

template <class T>
T& member_of(T& value) {
  return value;
}
template <class T, class Group, class M, class... Rest>
auto& member_of(T& value, M Group::*member, Rest... rest) {
  return member_of(value.*member, rest...);
}

/// `members` is the path of member pointers from RenderParams to the value. If the codec's `write` returns an empty
/// text, the parameter counts as not given.
template <class T, class... Members>
ParamInfo row_of(ParamKind kind, Codec<T> codec, Documentation words, Members... members) {
  ParamInfo info{words.name, words.group, words.type, words.doc, kind, true, false, {}, {}};
  info.set = [=, read = codec.read](RenderParams& params, const Values& values, const std::string& where) {
    const std::string_view value = values.empty() ? std::string_view() : std::string_view(values.back());
    if (const auto removed = removal_of(words.name, value, where)) throw *removed;
    member_of(params, members...) = read(value, where);
  };
  info.get = [=, write = codec.write](const RenderParams& params) {
    std::string value = write(member_of(params, members...));
    return value.empty() ? Values{} : Values{std::move(value)};
  };
  info.choices = std::move(codec.choices);
  return info;
}

template <class T>
ParamInfo row(ParamKind kind, T RenderParams::*member, Codec<T> codec, Documentation words) {
  return row_of(kind, codec, words, member);
}
template <class P, class G, class T>
ParamInfo row(ParamKind kind, G P::*group, T G::*member, Codec<T> codec, Documentation words) {
  return row_of(kind, codec, words, group, member);
}
template <class P, class G, class T>
ParamInfo row(ParamKind kind, P RenderParams::*group, G P::*part, T G::*member, Codec<T> codec, Documentation words) {
  return row_of(kind, codec, words, group, part, member);
}

ParamInfo runs_only(ParamInfo info) {
  info.changes_pictures = false;
  return info;
}

ParamInfo path(ParamInfo info) {
  info.is_path = true;
  return info;
}

ParamInfo with_bare_value(ParamInfo info, std::string_view value) {
  info.bare_value = value;
  return info;
}

ParamInfo with_opposite(ParamInfo info, std::string_view name, std::string_view doc) {
  info.opposite = name, info.opposite_doc = doc;
  return info;
}

ParamInfo frames_row() {
  ParamInfo info{
      "frames",
      "Scene",
      "A-B",
      "Frames A to B, both included, counted from 0; also lists and steps: 0,2,4 or 0-10:2; default: the whole animation",
      ParamKind::kText,
      false,
      false,
      {},
      {}};
  info.set = [](RenderParams& params, const Values& values, const std::string& where) {
    params.output.frames = read_frames(values.empty() ? "" : values.back(), where);
  };
  info.get = [](const RenderParams& params) {
    return params.output.frames ? Values{write_frames(*params.output.frames)} : Values{};
  };
  return info;
}

ParamInfo aov_row() {
  static const std::string doc = fmt::format(
      "Extra layers for every frame: {} (the last two need --integrator path); written into EXR pictures, or into an EXR file "
      "beside other pictures",
      fmt::join(kWantedAovNames, ", "));
  ParamInfo info{"aov", "Files", "LAYER,...", doc, ParamKind::kList, true, false, {}, {}};
  info.set = [](RenderParams& params, const Values& values, const std::string& where) {
    params.sampling.aov.clear();
    for (const std::string& value : values)
      for (std::size_t start = 0; start <= value.size();) {
        const std::size_t comma = std::min(value.find(',', start), value.size());
        const auto layer =
            static_cast<Aov>(read_choice(std::string_view(value).substr(start, comma - start), kWantedAovNames, where));
        if (std::find(params.sampling.aov.begin(), params.sampling.aov.end(), layer) == params.sampling.aov.end())
          params.sampling.aov.push_back(layer);
        start = comma + 1;
      }
  };
  info.choices = {kWantedAovNames.begin(), kWantedAovNames.end()};
  info.get = [](const RenderParams& params) {
    Values names;
    for (const Aov layer : params.sampling.aov) names.emplace_back(kAovNames[static_cast<std::size_t>(layer)]);
    return names;
  };
  return info;
}

ParamInfo video_row() {
  ParamInfo info{"video",
                 "Files",
                 "FILE",
                 "Also write a video: .mp4, .mov, .webm or .mkv (lossless); can be given several times",
                 ParamKind::kList,
                 false,
                 true,
                 {},
                 {}};
  info.set = [](RenderParams& params, const Values& values, const std::string&) { params.output.video = values; };
  info.get = [](const RenderParams& params) { return params.output.video; };
  return info;
}

ParamInfo stereo_row() {
  return row_of(ParamKind::kText, choice<StereoPacking>(kStereoPackingNames),
                {"stereo", "Files", "PACKING",
                 "With --layout stereo: side by side (sbs), one above the other (over-under), the same squeezed to half "
                 "(half-sbs, half-over-under), or alternating rows (rows)"},
                &RenderParams::output, &OutputParams::pictures, &PictureParams::stereo, &StereoLayout::packing);
}

ParamInfo right_first_row() {
  return row_of(
      ParamKind::kFlag, flag(),
      {"right-first", "Files", "", "With --layout stereo: put the right eye's view at the left, on top, or in the first row"},
      &RenderParams::output, &OutputParams::pictures, &PictureParams::stereo, &StereoLayout::right_first);
}

ParamInfo depth_range_row() {
  const Codec<std::optional<DepthRange>> range{
      [](std::string_view value, const std::string& where) { return std::optional(read_depth_range(value, where)); },
      [](const std::optional<DepthRange>& value) {
        return value ? fmt::format("{}:{}", value->near_mm, value->far_mm) : std::string();
      }};
  return row_of(ParamKind::kText, range,
                {"depth-range", "Files", "NEAR:FAR",
                 "With --layout rgbd: depths of the nearest and the farthest grey in mm, positive in front of the screen; "
                 "default: the depth range of the scene over its whole animation"},
                &RenderParams::output, &OutputParams::pictures, &PictureParams::depth, &DepthParams::range);
}

ParamInfo depth_coding_row() {
  return row_of(ParamKind::kText, optional_choice<DepthScale>(kDepthScaleNames),
                {"depth-coding", "Files", "SCALE", "With --layout rgbd: grey is linear in disparity (default) or in depth"},
                &RenderParams::output, &OutputParams::pictures, &PictureParams::depth, &DepthParams::linear);
}

ParamInfo near_black_row() {
  return row_of(ParamKind::kFlag, flag(),
                {"near-black", "Files", "", "With --layout rgbd: black is near; default: white is near"}, &RenderParams::output,
                &OutputParams::pictures, &PictureParams::depth, &DepthParams::near_black);
}

std::vector<ParamInfo> scene_rows() {
  using P = RenderParams;
  const Codec<Orbit> orbit{read_orbit, write_orbit};
  const Codec<std::optional<double>> point_size{
      [](std::string_view value, const std::string& where) -> std::optional<double> {
        if (value == "auto") return std::nullopt;
        return read_number(value, 1e-12, 1e12, where);
      },
      [](const std::optional<double>& value) { return value ? fmt::format("{}", *value) : std::string("auto"); }};
  return {
      path(runs_only(row(ParamKind::kText, &P::scene, &SceneParams::name, text(),
                         {"scene", "Scene", "SCENE", "A built-in scene or a scene file"}))),
      path(runs_only(row(ParamKind::kText, &P::scene, &SceneParams::camera_path, text(),
                         {"camera-path", "Scene", "FILE", "A Tachyon camera path (.cam) for a .dat scene"}))),
      runs_only(row(ParamKind::kText, &P::scene, &SceneParams::animation, text(),
                    {"animation", "Scene", "NAME|INDEX",
                     "Animation of a glTF file to play; default: the first ('lippmann info' lists them)"})),
      runs_only(
          row(ParamKind::kText, &P::scene, &SceneParams::variant, text(),
              {"variant", "Scene", "NAME|INDEX",
               "Material variant of a glTF file; default: the file's own materials ('lippmann info' lists the variants)"})),
      path(runs_only(
          row(ParamKind::kText, &P::scene, &SceneParams::asset_root, text(),
              {"asset-root", "Scene", "DIR",
               "Folder below which the scene may read textures and other files; default: the folder of the scene file"}))),
      runs_only(row(ParamKind::kNumber, &P::scene, &SceneParams::texture_memory, integer<int>(1, 1 << 20),
                    {"texture-memory", "Scene", "MB",
                     "Memory for decoded textures, 4 bytes per texel; the largest textures are halved until all fit"})),
      runs_only(row(ParamKind::kText, &P::scene, &SceneParams::point_size, point_size,
                    {"points", "Scene", "SIZE|auto",
                     "Diameter of points in a PLY point cloud, in its units; auto: chosen from their spacing"})),
      runs_only(row(ParamKind::kText, &P::scene, &SceneParams::camera, text(),
                    {"camera", "Scene", "NAME|INDEX",
                     "Camera of the file to render from; default: the first ('lippmann info' lists them)"})),
      runs_only(row(ParamKind::kText, &P::scene, &SceneParams::up, choice<UpAxis>(kUpNames),
                    {"up", "Scene", "AXIS", "Axis of the file that points up: x, y, z, -x, -y or -z"})),
      row(ParamKind::kText, &P::scene, &SceneParams::cameras, camera_set(),
          {"cameras", "Scene", "PATH:N",
           "Render a data set of the still scene with N cameras around it: sphere, hemisphere or circle; one camera per frame, "
           "with --to nerf (default), colmap or llff. An eighth of the cameras, chosen by --seed, is for testing"}),
      row(ParamKind::kText, &P::scene, &SceneParams::view, &ViewWish::focus, text(),
          {"focus", "Scene", "NODE|X,Y,Z|DISTANCE",
           "Place the display plane at a node, at a point, or at a distance from the viewer (scene units)"}),
      row(ParamKind::kText, &P::scene, &SceneParams::view, &ViewWish::fit_to, text(),
          {"fit-to", "Scene", "NODE|all",
           "Fit the view to this node and its children, or to the whole scene (all), seen from the camera's direction; "
           "default: the camera's own view, or the scene without its ground, walls and sky"}),
      row(ParamKind::kNumber, &P::scene, &SceneParams::view, &ViewWish::zoom, number<float>(1e-3, 1e3),
          {"zoom", "Scene", "FACTOR", "Enlarge the middle of the view by this factor"}),
      row(ParamKind::kText, &P::scene, &SceneParams::view, &ViewWish::orbit, orbit,
          {"orbit", "Scene", "YAW[,PITCH]",
           "Rotate the view around its subject, in degrees: positive values move the viewer right and up"}),
      frames_row(),
      row(ParamKind::kNumber, &P::scene, &SceneParams::fps, number<double>(0.0, 1000.0),
          {"fps", "Scene", "N", "Frames per second of the animation and of videos; 0: as in the scene"}),
      runs_only(row(ParamKind::kNumber, &P::scene, &SceneParams::light_scale, number<float>(0.0, 1e6),
                    {"light-scale", "Scene", "X", "Multiply the intensity of all lamps, for files in other units"})),
  };
}

std::vector<ParamInfo> optics_rows() {
  using P = RenderParams;
  const Codec<std::optional<double>> crosstalk{
      [](std::string_view value, const std::string& where) { return std::optional(read_crosstalk(value, where)); },
      [](const std::optional<double>& value) { return value ? fmt::format("{}", *value) : std::string(); }};
  const Codec<std::optional<float>> distance{read_distance, [](const std::optional<float>& v) { return write_distance(v); }};
  const Codec<std::optional<EyeHeight>> eye_height{
      [](std::string_view value, const std::string& where) { return std::optional(read_eye_height(value, where)); },
      [](const std::optional<EyeHeight>& value) { return value ? write_eye_height(*value) : std::string(); }};
  static const std::string kKindDoc = fmt::format("{}; default: that of --display, else lenticular", optics_kinds_help());
  return {
      path(runs_only(
          row(ParamKind::kText, &P::optics, &OpticsParams::display, text(),
              {"display", "Optics", "NAME|FILE",
               "Display to render for: a preset (see: lippmann displays), your own .toml file, or a calibration .json"}))),
      row(ParamKind::kText, &P::optics, &OpticsParams::kind, optics_kind_name(), {"optics", "Optics", "KIND", kKindDoc}),
      row(ParamKind::kText, &P::optics, &OpticsParams::packing, choice<LensPacking>(kPackingNames),
          {"packing", "Optics", "KIND", "Packing of microlenses: square or hexagonal"}),
      row(ParamKind::kText, &P::optics, &OpticsParams::lenses, extent(1, kMaxCount),
          {"lenses", "Optics", "N[xM]",
           "Lenses across and down; default: 64 across, and down as many as make the panel square"}),
      row(ParamKind::kText, &P::optics, &OpticsParams::lens_pixels, extent(1.0f, static_cast<float>(kMaxCount)),
          {"lens-pixels", "Optics", "N[xM]", "Pixels per lens, across and down; need not be whole; default: 8"}),
      row(ParamKind::kText, &P::optics, &OpticsParams::size, full_extent(kMaxCount),
          {"size", "Optics", "WxH", "Size of the picture in pixels; default: lenses times lens-pixels"}),
      row(ParamKind::kText, &P::optics, &OpticsParams::views, full_extent(4096),
          {"views", "Optics", "CxR", "With --optics multiview: columns and rows of views in the quilt; default: 8x6"}),
      row(ParamKind::kFlag, &P::optics, &OpticsParams::camera_grid, flag(),
          {"camera-grid", "Optics", "",
           "With --optics multiview: parallel cameras on a regular grid, as in light-field data sets"}),
      row(ParamKind::kFlag, &P::optics, &OpticsParams::cone_ends, flag(),
          {"cone-ends", "Optics", "",
           "With --optics multiview: the outermost views are seen from the ends of the viewing zone, N - 1 steps apart; "
           "default: half a step inside"}),
      row(ParamKind::kNumber, &P::optics, &OpticsParams::view_angle_deg, optional_number<float>(0.1, 170.0),
          {"view-angle", "Optics", "DEG",
           "Full angle of the viewing zone; sets the gap between lenses and panel; default: that of --display, else 28"}),
      row(ParamKind::kText, &P::optics, &OpticsParams::viewing_distance_mm, distance,
          {"viewing-distance", "Optics", "MM|inf|auto",
           "Distance at which the lenses' viewing zones coincide; auto: that of --display, else the camera's distance. With "
           "--optics plenoptic: from the main lens to the plane in focus; auto: the camera's distance, in scenes in metres"}),
      row(ParamKind::kText, &P::optics, &OpticsParams::eye_height, eye_height,
          {"eye-height", "Optics", "MM|DEGdeg",
           "Height of the viewer's eyes above the middle of the display, such as 150, or 30deg seen from there; below 0: below "
           "it"}),
      row(ParamKind::kNumber, &P::optics, &OpticsParams::sensor_width_mm, optional_number<float>(0.1, 1e4),
          {"sensor-width", "Optics", "MM", "With --optics plenoptic: width of the sensor; default: 36"}),
      row(ParamKind::kNumber, &P::optics, &OpticsParams::focal_length_mm, optional_number<float>(0.1, 1e5),
          {"focal-length", "Optics", "MM",
           "With --optics plenoptic: focal length of the main lens; default: the field of view of the scene's camera"}),
      row(ParamKind::kNumber, &P::optics, &OpticsParams::gap_mm, optional_number<float>(1e-4, 1e4),
          {"gap", "Optics", "MM",
           "With --optics plenoptic: distance between microlenses and sensor; default: the images below the lenses touch"}),
      row(ParamKind::kNumber, &P::optics, &OpticsParams::lens_focal_length_mm, optional_number<float>(1e-4, 1e4),
          {"lens-focal-length", "Optics", "MM",
           "With --optics plenoptic: focal length of the microlenses; default: the gap (plenoptic 1.0). Other values place the "
           "array before or behind the main lens's image (2.0)"}),
      row(ParamKind::kNumber, &P::optics, &OpticsParams::slant_deg, number<float>(-80.0, 80.0),
          {"slant", "Optics", "DEG", "Angle of a lenticular sheet's lenses from the vertical"}),
      row(ParamKind::kNumber, &P::optics, &OpticsParams::ipd_mm, optional_number<double>(0.1, 1000.0),
          {"ipd", "Optics", "MM", "With --layout stereo: distance between the eyes; default: 63"}),
      row(ParamKind::kNumber, &P::optics, &OpticsParams::screen_width_mm, optional_number<double>(1.0, 1e6),
          {"screen-width", "Optics", "MM",
           "With --layout stereo: width of the picture on the screen; default: the display's width, else 600 (27 inch)"}),
      row(ParamKind::kText, &P::optics, &OpticsParams::crosstalk_px, crosstalk,
          {"crosstalk", "Optics", "PIXELS|C%",
           "With --precompensate: blur of the lenses, as the sigma of a Gaussian in pixels (quilts: in views) or the share of "
           "each neighbour, such as 0.4 or 10%; default: that of --display"}),
      row(ParamKind::kFlag, &P::optics, &OpticsParams::precompensate, flag(),
          {"precompensate", "Optics", "",
           "Sharpen pictures in advance to cancel the crosstalk of the lenses, within the range of pixel values"}),
      with_opposite(row(ParamKind::kFlag, &P::optics, &OpticsParams::fit_depth, optional_flag(),
                        {"fit-depth", "Optics", "",
                         "Scale the scene's depth down to what the display can resolve; the default for lens arrays and for "
                         "every --display"}),
                    "full-depth", "Keep the scene's full depth, blurred or stepped where the display cannot resolve it"),
  };
}

std::vector<ParamInfo> rendering_rows() {
  using P = RenderParams;
  const Codec<std::string> environment{read_environment_choice, [](const std::string& value) { return value; }};
  return {
      row(ParamKind::kText, &P::sampling, &Sampling::integrator, integrator_name(),
          {"integrator", "Rendering", "NAME",
           "whitted (sharp shadows, mirrors, refraction) or path (path tracing: all light); default: path for glTF, OBJ and "
           "PLY files, else whitted"}),
      row(ParamKind::kNumber, &P::sampling, &Sampling::spp, integer<int>(0, 1 << 16),
          {"spp", "Rendering", "N", "Samples per pixel; 0: 1 (whitted) or 16 (path)"}),
      row(ParamKind::kText, &P::sampling, &Sampling::angular_filter, optional_choice<AngularFilter>(kAngularNames),
          {"angular-filter", "Rendering", "NAME",
           "With --optics multiview: a view is seen from one eye (none) or from the whole range between its neighbours (box), "
           "so that depth beyond the budget blurs instead of doubling; default: box for quilts of a --display"}),
      row(ParamKind::kNumber, &P::sampling, &Sampling::lens, &ViewLens::aperture_mm, number<float>(0.0, 1e6),
          {"aperture", "Rendering", "MM",
           "Depth of field for single views and quilts: diameter of each view's lens, in millimetres of the display; 0: a "
           "pinhole"}),
      row(ParamKind::kNumber, &P::sampling, &Sampling::lens, &ViewLens::f_number, number<float>(0.0, 1e6),
          {"f-number", "Rendering", "N",
           "Depth of field as an f-number, for a sensor 36 mm wide (as in Blender) and scenes in metres; 0: a pinhole. With "
           "--optics plenoptic: of the main lens; default: 2, or that of the microlenses if --gap is given"}),
      row(ParamKind::kNumber, &P::sampling, &Sampling::lens, &ViewLens::focal_plane_mm, number<float>(-1e6, 1e6),
          {"focal-plane", "Rendering", "MM",
           "Depth that is sharp with depth of field: distance in front of the display plane (see --focus), negative behind "
           "it"}),
      row(ParamKind::kNumber, &P::sampling, &Sampling::shutter, number<float>(0.0, 1.0),
          {"shutter", "Rendering", "SHARE",
           "Motion blur: share of the frame interval that the shutter is open, centred on the frame; 0.5 as in Blender; 0: "
           "off"}),
      row(ParamKind::kNumber, &P::sampling, &Sampling::max_depth, integer<int>(0, 1024),
          {"max-depth", "Rendering", "N", "Maximum number of path vertices; 1: no mirrors; 0: the scene's own limit"}),
      row(ParamKind::kNumber, &P::sampling, &Sampling::seed,
          integer<std::uint32_t>(0, std::numeric_limits<std::uint32_t>::max()),
          {"seed", "Rendering", "N", "Seed of the random numbers (positions of samples, paths)"}),
      row(ParamKind::kNumber, &P::sampling, &Sampling::clamp_indirect, number<float>(0.0, 1e6),
          {"clamp-indirect", "Rendering", "X",
           "With --integrator path: limit the indirect light of a sample to X, which removes bright specks but loses light; 0: "
           "off"}),
      with_bare_value(row(ParamKind::kText, &P::sampling, &Sampling::denoise, denoise_choice(),
                          {"denoise", "Rendering", "auto|none",
                           "Remove the noise of path tracing by averaging over pixels and views that show the same surface: "
                           "auto (with 2 or more samples per pixel) or none"}),
                      "auto"),
      path(row(ParamKind::kText, &P::scene, &SceneParams::environment, environment,
               {"environment", "Rendering", "none|studio|COLOUR|FILE",
                "Surroundings that light the scene: none, the built-in studio, a colour (#rrggbb, or R,G,B in linear light) or "
                "a panorama (.hdr, .exr, .pfm, .tif); default: the scene's own; for path-traced glTF, OBJ and PLY files "
                "without one, the studio (dimmed if the file has lamps)"})),
      row(ParamKind::kNumber, &P::scene, &SceneParams::environment_strength, number<float>(0.0, 1e6),
          {"environment-strength", "Rendering", "X", "Multiply the light of the surroundings"}),
      row(ParamKind::kNumber, &P::scene, &SceneParams::environment_rotation_deg, number<float>(-360.0, 360.0),
          {"environment-rotation", "Rendering", "DEG", "Rotate the surroundings about the vertical axis"}),
      row(ParamKind::kFlag, &P::sampling, &Sampling::transparent, flag(),
          {"transparent", "Rendering", "", "Write pictures with alpha: the surroundings light the scene but are not visible"}),
      row(ParamKind::kNumber, &P::output, &OutputParams::pictures, &PictureParams::exposure_ev, number<float>(-64.0, 64.0),
          {"exposure", "Rendering", "EV", "Exposure of pictures and videos in stops; EXR files stay linear"}),
      row(ParamKind::kText, &P::output, &OutputParams::pictures, &PictureParams::tone, choice<ToneCurve>(kToneNames),
          {"tone", "Rendering", "CURVE",
           "Tone curve for light brighter than white, except in EXR files: none (clipped), neutral (keeps hues) or agx (as "
           "film does)"}),
      runs_only(row(ParamKind::kText, &P::sampling, &Sampling::order, choice<RayOrder>(kOrderNames),
                    {"order", "Rendering", "ORDER",
                     "Order in which pixels are traced; changes speed only: rows, columns (below a lens) or view-tiles"})),
  };
}

std::vector<ParamInfo> reuse_rows() {
  using P = RenderParams;
  const Codec<std::optional<int>> keyframes{
      [](std::string_view value, const std::string& where) { return read_integer_or_auto(value, 2, kMaxKeyframes, where); },
      [](const std::optional<int>& value) { return value ? fmt::format("{}", *value) : std::string("auto"); }};
  const Codec<std::optional<double>> min_psnr{
      [](std::string_view value, const std::string& where) -> std::optional<double> {
        return read_number(value, kMinPsnr, kMaxPsnr, where);
      },
      [](const std::optional<double>& value) { return value ? fmt::format("{}", *value) : std::string(); }};
  return {
      row(ParamKind::kText, &P::reuse, &ReuseParams::choice, reuse_choice(),
          {"reuse", "Reuse", "NAME",
           "How frames share work. none; copy: copy pixels that cannot have changed, for the same pictures as none; "
           "interpolate: make frames from the points of key frames (the paper's method); auto: copy, or none for path "
           "tracing"}),
      row(ParamKind::kText, &P::reuse, &ReuseParams::keyframes, keyframes,
          {"keyframes", "Reuse", "K|auto",
           "With --reuse copy or interpolate: trace a key frame every K frames; auto: chosen by cost, or 8 for interpolate "
           "without --min-psnr"}),
      row(ParamKind::kNumber, &P::reuse, &ReuseParams::min_psnr_db, min_psnr,
          {"min-psnr", "Reuse", "DB",
           "With --reuse interpolate: lowest PSNR of a frame; pixels are traced until it is reached"}),
      row(ParamKind::kText, &P::reuse, &ReuseParams::splat, choice<SplatMode>(kSplatNames),
          {"splat", "Reuse", "WHERE",
           "With --reuse interpolate: project points within their lens (as in the paper) or within their directional view"}),
      row(ParamKind::kText, &P::reuse, &ReuseParams::fill, choice<MissedFill>(kFillNames),
          {"fill", "Reuse", "HOW",
           "With --reuse interpolate: fill missed pixels from their neighbours (interpolate) or trace them (retrace)"}),
      row(ParamKind::kFlag, &P::reuse, &ReuseParams::halving, flag(),
          {"halving", "Reuse", "",
           "With --reuse interpolate: make the middle frame first, then use it for the others (the paper's recursion)"}),
      row(ParamKind::kFlag, &P::reuse, &ReuseParams::no_z_buffer, flag(),
          {"no-z-buffer", "Reuse", "",
           "With --reuse interpolate: let points overwrite each other in pixel order, without a depth test (wrong; for "
           "experiments)"}),
      row(ParamKind::kText, &P::reuse, &ReuseParams::debug, choice<DebugPicture>(kDebugNames),
          {"debug", "Reuse", "PICTURE", "With --reuse interpolate: missed leaves missed pixels black"}),
  };
}

std::vector<ParamInfo> file_rows() {
  using P = RenderParams;
  const Codec<std::optional<VideoCodec>> video_codec{
      [](std::string_view value, const std::string& where) -> std::optional<VideoCodec> {
        return static_cast<VideoCodec>(read_choice(value, kVideoCodecNames, where));
      },
      [](const std::optional<VideoCodec>& value) { return value ? std::string(name_of(*value)) : std::string(); },
      {kVideoCodecNames.begin(), kVideoCodecNames.end()}};
  const Codec<std::optional<int>> crf{
      [](std::string_view value, const std::string& where) -> std::optional<int> {
        return static_cast<int>(read_integer(value, 0, 63, where));
      },
      [](const std::optional<int>& value) { return value ? fmt::format("{}", *value) : std::string(); }};
  static const std::string to_doc =
      fmt::format("Write each frame as a light field, with cameras and depth where the format has them: {}",
                  fmt::join(output_format_names(), ", "));
  return {
      path(runs_only(
          row(ParamKind::kText, &P::output, &OutputParams::folder, text(),
              {"output", "Files", "DIR",
               "Output folder; default: out/<scene name>, or that name with -2, -3, ... if it holds another render"}))),
      row(ParamKind::kText, &P::output, &OutputParams::pictures, &PictureParams::layout,
          optional_choice<PictureLayout>(kLayoutNames),
          {"layout", "Files", "LAYOUT",
           "Layout of each frame's picture: integral (behind the lenses), quilt (views side by side), views (a folder of "
           "views), native (the display's own frame), print (TIFF at the display's resolution), stereo (a view for each eye) "
           "or rgbd (a view and its depth); default: the native layout of the optics"}),
      row(ParamKind::kText, &P::output, &OutputParams::pictures, &PictureParams::to, light_field_name(),
          {"to", "Files", "FORMAT", to_doc}),
      row(ParamKind::kFlag, &P::output, &OutputParams::pictures, &PictureParams::binary, flag(),
          {"binary", "Files", "", "With --to colmap: write binary files in place of text"}),
      row(ParamKind::kFlag, &P::output, &OutputParams::pictures, &PictureParams::pseudoscopic, flag(),
          {"pseudoscopic", "Files", "",
           "With --layout integral: rotate every elemental image by 180 degrees, as a real lens array records it; inverts "
           "depth"}),
      row(ParamKind::kFlag, &P::output, &OutputParams::pictures, &PictureParams::mirror, flag(),
          {"mirror", "Files", "", "With --layout print: mirror the picture, for printing on the back of the sheet"}),
      row(ParamKind::kText, &P::output, &OutputParams::pictures, &PictureParams::quilt, full_extent(4096),
          {"quilt", "Files", "CxR",
           "With --layout quilt: columns and rows of tiles; default: those of the views, or nearly square"}),
      stereo_row(),
      right_first_row(),
      depth_range_row(),
      depth_coding_row(),
      near_black_row(),
      row(ParamKind::kText, &P::output, &OutputParams::pictures, &PictureParams::format, choice<PictureFormat>(kFormatNames),
          {"format", "Files", "FORMAT",
           "File format of the pictures: png (8 bit), png16, tiff (8 bit, with its resolution) or exr (linear)"}),
      row(ParamKind::kText, &P::output, &OutputParams::pictures, &PictureParams::exr_pixels, choice<ExrPixels>(kExrPixelNames),
          {"exr-pixels", "Files", "TYPE", "Number type of EXR colours: half or float"}),
      aov_row(),
      video_row(),
      runs_only(row(ParamKind::kText, &P::output, &OutputParams::video_codec, video_codec,
                    {"video-codec", "Files", "NAME",
                     "Codec of videos: h264, hevc, vp9, av1 or ffv1; default: .mp4 h264 (hevc above 4096 pixels a side), .webm "
                     "vp9, .mkv ffv1"})),
      runs_only(
          row(ParamKind::kText, &P::output, &OutputParams::crf, crf,
              {"crf", "Files", "N", "Quality of videos, 0 (best) to 51 (h264, hevc) or 63; default 18, hevc 20, else 24"})),
      runs_only(row(ParamKind::kText, &P::output, &OutputParams::also, optional_choice<Companion>(kCompanionNames),
                    {"also", "Files", "WHAT", "single: also render the frames as one eye sees them, into DIR/single"})),
      runs_only(row(
          ParamKind::kFlag, &P::output, &OutputParams::page, flag(),
          {"page", "Files", "", "Also write DIR/page, a page that shows the light field in any browser (docs/guide/view.md)"})),
  };
}

std::vector<ParamInfo> running_rows() {
  using P = RenderParams;
  return {
      row(ParamKind::kNumber, &P::strips, integer<int>(1, kMostStrips),
          {"strips", "Running", "N",
           "Render each frame in N strips of rows, for huge stills: units and ranks share the strips, 'lippmann finish' joins "
           "them"}),
      runs_only(row(ParamKind::kNumber, &P::threads, integer<int>(0, 1024),
                    {"threads", "Running", "N", "Number of rendering threads; 0: one per processor"})),
      runs_only(row(ParamKind::kFlag, &P::resume, flag(),
                    {"resume", "Running", "", "Continue an earlier run of the same job: keep its finished frames"})),
  };
}

}  // namespace

const std::vector<ParamInfo>& params_table() {
  static const std::vector<ParamInfo> table = [] {
    std::vector<ParamInfo> all;
    for (auto rows : {scene_rows(), optics_rows(), rendering_rows(), reuse_rows(), file_rows(), running_rows()})
      for (ParamInfo& info : rows) all.push_back(std::move(info));
    return all;
  }();
  return table;
}

const ParamInfo* find_param(std::string_view name) {
  for (const ParamInfo& info : params_table())
    if (info.name == name) return &info;
  return nullptr;
}

std::string flag_of(std::string_view name) { return fmt::format("--{}", name); }

const ParamInfo* find_opposite(std::string_view name) {
  for (const ParamInfo& info : params_table())
    if (!info.opposite.empty() && info.opposite == name) return &info;
  return nullptr;
}

std::string did_you_mean(std::string_view name) {
  std::vector<std::string_view> names;
  for (const ParamInfo& info : params_table())
    for (const std::string_view known : {info.name, info.opposite})
      if (!known.empty()) names.push_back(known);
  return did_you_mean(name, names);
}

}  // namespace lippmann
