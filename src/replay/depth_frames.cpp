#include "replay/depth_frames.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "core/folder.hpp"
#include "formats/depth_map.hpp"
#include "formats/light_field_source.hpp"
#include "formats/rgbd_name.hpp"
#include "formats/rgbd_picture.hpp"
#include "formats/rgbd_side_file.hpp"
#include "formats/view_files.hpp"
#include "layout/lens_interlace.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/formats/open_light_field.hpp"
#include "lippmann/replay/light_field_frames.hpp"
#include "replay/depth_views.hpp"
#include "replay/pair_depth.hpp"
#include "video/video_reader.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

struct RgbdFrame {
  fs::path name;  ///< frames of a video are named frame_0000.png, frame_0001.png, ...
  LightField field;
};

/// Reads RGB-D images, an RGB-D video, stereo images, or an image with a depth map, one frame at a time.
class RgbdFrames {
 public:
  /// Throws Error if the file does not exist, or if the folder has no frames.
  explicit RgbdFrames(const DepthConversion& params);

  /// Returns nullopt after the last frame. Throws Error naming the file.
  std::optional<RgbdFrame> next();

  const fs::path& first() const { return files_.front(); }
  bool is_one_picture() const { return one_; }

 private:
  std::optional<RgbdFrame> next_of_video();
  LightField read(const fs::path& file) const;
  LightField read_pair(const fs::path& file) const;

  std::vector<fs::path> files_;
  const DepthConversion& params_;
  bool one_;
  std::optional<VideoReader> video_;
  std::size_t count_ = 0;
};

std::vector<fs::path> files_with_depth(const DepthConversion& params) {
  if (params.is_pair) return light_fields_in(params.in, "stereo");
  if (params.depth.empty()) return light_fields_in(params.in, "rgbd");
  std::error_code ignored;
  if (fs::is_directory(params.in, ignored) || is_video_name(params.in))
    throw usage_error("depth", params.in.string() + " is not a single picture", "a picture and its depth map");
  return {params.in};
}

RgbdFrames::RgbdFrames(const DepthConversion& params)
    : files_(files_with_depth(params)), params_(params), one_(files_.front() == params.in && !is_video_name(params.in)) {
  if (files_.front() == params.in && is_video_name(params.in)) video_.emplace(params.in);
}

std::optional<RgbdFrame> RgbdFrames::next() {
  if (video_) return next_of_video();
  if (count_ == files_.size()) return std::nullopt;
  const fs::path& file = files_[count_++];
  return RgbdFrame{file.filename(), read(file)};
}

LightField RgbdFrames::read(const fs::path& file) const {
  if (params_.is_pair) return read_pair(file);
  if (params_.depth.empty()) return rgbd_format().read(file, params_.options);
  Picture colours = read_picture(file, params_.options.warn);
  const std::optional<RgbdSideFile> side = read_rgbd_side_file(file);
  const DepthMapCoding usual = default_depth_coding(params_.depth);
  FormatOptions options = params_.options;
  options.near_black = options.near_black.value_or(side ? side->coding.near_black : usual.near_black);
  options.even_in_depth = options.even_in_depth.value_or(side ? side->coding.even_in_depth : usual.even_in_depth);
  Image greys = read_depth_map(params_.depth, size_of(colours), *options.near_black);
  return light_field_of_colours(std::move(colours), std::move(greys), file, options);
}

LightField RgbdFrames::read_pair(const fs::path& file) const {
  LightField pair = stereo_format().read(file, params_.options);
  const Vec2d view(pair.view_size);
  const RgbdSideFile assumed;
  const Vec2d pixel = Vec2d(assumed.size_mm.y * pair.aspect, assumed.size_mm.y) / view;
  pair.cameras = ViewCameras{assumed.distance_mm, pixel, 0.5 * view, {Vec2d(0.0), Vec2d(0.0)}};
  return pair;
}

std::optional<RgbdFrame> RgbdFrames::next_of_video() {
  std::optional<Image8> picture = video_->next();
  if (!picture) return std::nullopt;
  const std::string where = fmt::format("{}, frame {}", first().string(), count_);
  return RgbdFrame{fmt::format("frame_{:04}.png", count_++),
                   light_field_of_rgbd(*std::exchange(picture, {}), first(), where, params_.options)};
}

/// Returns whether the display is a lenticular sheet or a microlens array.
bool has_lenses(const Display& display) { return display.kind != DisplayKind::kSlantedPanel; }

bool is_behind_lenses(const DepthConversion& params) {
  return params.to == "integral" && params.options.display && has_lenses(*params.options.display);
}

/// Returns two eyes in front of the display or, without a display, in front of the screen that the image was made for.
Optics eyes_optics(const LightField& source, const DepthConversion& params) {
  const ViewCameras& camera = *source.cameras;
  MultiView eyes{2, 1};
  eyes.baseline_mm = static_cast<float>(params.ipd_mm);
  const Display* display = params.options.display ? &*params.options.display : nullptr;
  const Vec2i view = display ? display->pixels : source.view_size;
  const Vec2d pixel = display ? Vec2d(display->pixel_mm()) : camera.pixel_mm;
  eyes.distance_mm = static_cast<float>(display ? viewing_distance_mm(*display) : camera.distance_mm);
  eyes.pixel_height = static_cast<float>(pixel.y / pixel.x);
  return {{2 * view.x, view.y, static_cast<float>(pixel.x)}, eyes};
}

/// Returns the display's quilt. For a display with lenses but no quilt, returns as many views as the lenses show.
Optics views_for(Display display, const std::optional<ViewGrid>& views) {
  if (has_lenses(display) && !display.quilt) return lens_views(display, views);
  if (views && display.quilt) display.quilt->columns = views->columns, display.quilt->rows = views->rows;
  if (const std::optional<Optics> optics = quilt_optics(display)) return *optics;
  throw usage_error("display", display.name + " has no quilt", "a display with a quilt, or `views` and no `display`");
}

/// Returns views of the image's size in front of the screen that the image was made for.
Optics own_views(const LightField& source, const DepthConversion& params) {
  LightField wanted;
  wanted.grid = params.options.views.value_or(ViewGrid{48, 1});
  wanted.view_size = source.view_size, wanted.aspect = source.aspect;
  const ViewCameras& camera = *source.cameras;
  MultiView views = assumed_views(wanted, params.view_angle_deg);
  views.baseline_mm *= static_cast<float>(camera.distance_mm) / views.distance_mm;
  views.distance_mm = static_cast<float>(camera.distance_mm);
  views.pixel_height = static_cast<float>(camera.pixel_mm.y / camera.pixel_mm.x);
  const Vec2i film = wanted.view_size * Vec2i(wanted.grid.columns, wanted.grid.rows);
  Optics optics;
  optics.panel = {film.x, film.y, static_cast<float>(camera.pixel_mm.x)};
  optics.model = views;
  validate(optics);
  return optics;
}

Optics wanted_optics(const LightField& source, const DepthConversion& params) {
  if (params.to == "stereo") return eyes_optics(source, params);
  if (is_behind_lenses(params)) return lens_views(*params.options.display, params.options.views);
  if (params.options.display) return views_for(*params.options.display, params.options.views);
  return own_views(source, params);
}

void warn_of_assumptions(const fs::path& first, const DepthConversion& params, const Context& context) {
  if (read_rgbd_side_file(first)) return;
  const DepthRange range = params.options.depth_range.value_or(DepthRange{});
  context.warning(
      fmt::format("The depth range of {} is unknown, because it has no side file. Assumed: black is at {:g} mm and white at "
                  "{:g} mm in front of a picture 100 mm high, seen from 300 mm. `depth-range` sets the range.",
                  first.string(), range.far_mm, range.near_mm));
}

/// Makes the views of a frame. For RGB-D output, returns the frame's image itself as the only view.
DepthViews shown_views(const RgbdFrame& frame, const DepthConversion& params, const ThreadPool& pool, const Context& context) {
  const LightField& source = frame.field;
  if (params.to == kRgbdFormat) return {source};
  const Optics optics = wanted_optics(source, params);
  DepthViews views = params.is_pair ? views_from_depths(pictures_with_depth(source, optics, frame.name.string(), context),
                                                        optics, params.depth_scale, pool)
                                    : views_from_depth(source, optics, params.depth_scale, pool);
  views.field.stack = with_samples_like(source.stack, std::get<Image>(std::move(views.field.stack)));
  return views;
}

fs::path path_for(const DepthConversion& params, const LightFieldFormat& to, const fs::path& name, bool one,
                  const Picture& stack) {
  fs::path path = one ? params.out : params.out / (params.is_pair ? without_stereo_name(name) : without_rgbd_name(name)).stem();
  if (!to.is_folder && (!one || !path.has_extension())) path += std::string(".") + exact_ending(stack);
  return path;
}

std::vector<fs::path> write_frame(const LightField& field, const fs::path& path, const DepthConversion& params,
                                  const ThreadPool& pool) {
  const LightFieldFormat& to = find_output_format(params.to, "to");
  if (!is_behind_lenses(params)) return to.write(field, path, params.options);
  write_picture(path, interlace_behind_lenses(field, *params.options.display, pool));
  return {path};
}

}  // namespace

bool is_rgbd(const fs::path& in) {
  std::error_code ignored;
  fs::path first = in;
  if (fs::is_directory(in, ignored)) {
    const std::vector<fs::path> frames = light_field_frames(in, "");
    if (frames.empty()) return false;
    first = frames.front();
  }
  return has_rgbd_name(first) || read_rgbd_side_file(first);
}

ConvertedDepth convert_depth_frames(const DepthConversion& params, const Context& context) {
  const LightFieldFormat& to = find_output_format(params.to, "to");
  if (is_video_name(params.out))
    throw Error(params.out.string(), "is the name of a video, but frames are written as pictures",
                "a folder; `lippmann encode` makes a video of its frames");
  RgbdFrames frames(params);
  const bool one = frames.is_one_picture();
  const ThreadPool pool(resolved_threads(context));
  if (!params.is_pair) warn_of_assumptions(frames.first(), params, context);
  ConvertedDepth made;
  double filled = 0.0;
  const NewFolder folder(one ? params.out.parent_path() : params.out);
  int count = 0;
  while (const std::optional<RgbdFrame> frame = context.cancelled ? std::nullopt : frames.next()) {
    DepthViews views = shown_views(*frame, params, pool, context);
    const fs::path path = path_for(params, to, frame->name, one, frame->field.stack);
    const NewFolder of_frame(to.is_folder ? path : fs::path());
    for (fs::path& file : write_frame(views.field, path, params, pool)) made.written.push_back(std::move(file));
    made.views = views.field.grid, made.view_size = views.field.view_size;
    filled += views.filled_share, ++count;
  }
  made.filled_share = filled / std::max(count, 1);
  return made;
}

}  // namespace lippmann
