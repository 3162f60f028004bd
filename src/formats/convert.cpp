#include "lippmann/formats/convert.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "core/folder.hpp"
#include "formats/frame_names.hpp"
#include "formats/light_field_source.hpp"
#include "formats/quad_name.hpp"
#include "formats/quilt_side_file.hpp"
#include "formats/rgbd_name.hpp"
#include "formats/stated_cameras.hpp"
#include "formats/view_files.hpp"
#include "image/print_file.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/formats/kept_data.hpp"
#include "lippmann/formats/open_light_field.hpp"
#include "lippmann/formats/quilt_name.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

/// Replaces 0, the default, by the number of processors.
int resolved_threads(int threads) {
  Context context;
  context.threads = threads;
  return lippmann::resolved_threads(context);
}

Picture cropped(Picture view, const Crop& window) {
  LightField one;
  one.grid = {1, 1}, one.view_size = size_of(view), one.stack = std::move(view);
  crop(one, window, "crop");
  return std::move(one.stack);
}

/// Files of prints state their resolution. `profile`: the printer's colour profile; null: none.
std::vector<fs::path> write_display_picture(const Picture& picture, const Display& display, DisplayTarget target,
                                            const fs::path& path, const OutputProfile* profile) {
  if (target == DisplayTarget::kQuilt) {
    const QuiltName quilt = quilt_name_of(*display.quilt);
    const fs::path named = with_quilt_name(path, quilt);
    write_picture(named, picture);
    write_quilt_side_file(named, {quilt, quilt.tiles.count(), false});
    return {named, quilt_side_path(named)};
  }
  write_print(path, picture, display.dpi, profile);
  return {path};
}

/// Frames of an animation usually lose the same data.
void add_left_out(std::string description, Converted& result) {
  if (std::ranges::find(result.left_out, description) == result.left_out.end())
    result.left_out.push_back(std::move(description));
}

class Conversion {
 public:
  explicit Conversion(const ConvertParams& params) : params_(params), to_(find_output_format(params.to, "to")) {
    if (!params.icc.empty()) profile_.emplace(params.icc);
    if (params.display_picture) pool_ = std::make_unique<ThreadPool>(resolved_threads(params.threads));
  }

  /// `is_frame`: whether `in` is a frame in a folder. The ending of `out` is then not the user's choice, and is replaced.
  void convert_one(const fs::path& in, const fs::path& out, bool is_frame, Converted& result) const {
    if (params_.display_picture) return convert_for_display(in, out, is_frame, result);
    FormatOptions reading = params_.options;
    reading.with_depth = true;                         // also if the output format loses it, which is reported
    if (to_.name == "stereo") reading.stereo.reset();  // `stereo` describes the output; the input's name describes the input
    OpenedLightField opened = open(in, reading);
    LightField& field = opened.field;
    if (params_.keep) keep(field, *params_.keep, "keep");
    if (params_.crop) crop(field, *params_.crop, "crop");
    FormatOptions writing = params_.options;
    if (opened.format == "quilt") writing.tiles.reset();  // `tiles` describes the input, not the output
    fs::path path = out;
    if (to_.name != "quilt" && parse_quilt_name(path))
      throw usage_error("OUT", path.string() + " is a quilt name, but the format is " + std::string(to_.name),
                        "a name without _qs..., or `to` quilt");
    if (!to_.is_folder && (is_frame || !path.has_extension())) path.replace_extension(exact_ending(field.stack));
    const NewFolder folder(to_.is_folder ? path : path.parent_path());
    for (fs::path& file : to_.write(field, path, writing)) result.written.push_back(std::move(file));
    result.views = field.grid, result.view_size = field.view_size;
    for (LostData& lost : lost_data(field, to_.name)) add_left_out(std::move(lost.description), result);
    const bool has_depth = field.depth || field.view_depth || field.lacks_some_depth;
    result.lacks_cameras = keeps(to_.name, DataKind::kHciNotes) && !field.cameras && !field.poses;
    result.lacks_depth = keeps(to_.name, DataKind::kDepth) && writes_cameras(field) && !has_depth;
  }

  /// Views in folders may be large photos, so each view is resized to the display right after it is read.
  void convert_for_display(const fs::path& in, const fs::path& out, bool is_frame, Converted& result) const {
    const Display display = with_bleed(*params_.options.display, params_.display_picture->finish.bleed_mm);
    const DisplayTarget target = display_target(display, to_.name);
    const DisplayPictureParams& shown = *params_.display_picture;
    ViewFitter fitter(display, target, shown.fit.value_or(default_fit(target)), *pool_, shown.view_shift_px);
    FormatOptions reading = params_.options;
    reading.cameras.reset();  // the views are resampled, and display pictures state no cameras
    reading.fit_view = [&](Picture view, double aspect, int number, ViewGrid grid) {
      const Vec2d whole(size_of(view));
      if (params_.crop) view = cropped(std::move(view), *params_.crop);
      const Vec2d share = Vec2d(size_of(view)) / whole;
      if (params_.keep) {
        number = kept_number(number, grid, *params_.keep, "keep").value_or(0);
        grid = kept_grid(grid, *params_.keep, "keep");
      }
      return fitter.fitted(view, aspect * share.x / share.y, number, grid);
    };
    LightField field = open(in, reading).field;
    if (params_.keep) keep(field, *params_.keep, "keep");
    if (!fitter.has_fitted()) {
      if (params_.crop) crop(field, *params_.crop, "crop");
      fitter.fit(field);
    }
    const Picture picture = display_picture(field, display, target, shown, *pool_);
    fs::path path = out;
    if (is_frame || !path.has_extension()) path.replace_extension(exact_ending(picture));
    const NewFolder folder(path.parent_path());
    for (fs::path& file : write_display_picture(picture, display, target, path, profile_ ? &*profile_ : nullptr))
      result.written.push_back(std::move(file));
    result.views = field.grid, result.view_size = field.view_size;
    for (LostData& lost : lost_data(field, to_.name))  // pictures of a display hold nothing but views
      if (lost.kind == DataKind::kPoses) add_left_out(std::move(lost.description), result);
    result.fitted = fitter.description();
    result.too_coarse = fitter.coarseness();
  }

  /// Removes the suffix of the input format, such as _qs8x6a0.75. The writer of the output format adds its own.
  fs::path name_of(const fs::path& frame) const {
    const fs::path bare = without_rgbd_name(without_quad_name(without_stereo_name(without_quilt_name(frame.filename()))));
    return to_.is_folder ? bare.stem() : bare;
  }

 private:
  bool writes_cameras(const LightField& field) const {
    return field.poses ? keeps(to_.name, DataKind::kPoses) : field.cameras.has_value();
  }

  OpenedLightField open(const fs::path& in, const FormatOptions& reading) const {
    if (!params_.read_views) return open_light_field(in, params_.from, reading);
    OpenedLightField opened{.field = params_.read_views(in, reading), .format = "views"};
    if (reading.cameras) state_cameras(opened.field, *reading.cameras, in.string());
    return opened;
  }

  const ConvertParams& params_;
  const LightFieldFormat& to_;
  std::optional<OutputProfile> profile_;
  std::unique_ptr<ThreadPool> pool_;  ///< null unless pictures for a display are made
};

/// Returns whether a folder of pictures may be an animation. For a flip print, the pictures belong to a single print.
bool may_have_frames(const ConvertParams& params) { return !params.display_picture || !params.display_picture->flip; }

}  // namespace

Converted convert(const fs::path& in, const fs::path& out, const ConvertParams& params) {
  const Conversion conversion(params);
  Converted result;
  std::error_code ignored;
  const bool is_folder = fs::is_directory(in, ignored) && may_have_frames(params);
  const std::vector<fs::path> frames = is_folder ? light_field_frames(in, params.from) : std::vector<fs::path>();
  const bool may_be_one = params.from.empty() || find_format(params.from, "from").is_folder || !is_folder;
  if (frames.empty() && !may_be_one) throw Error(in.string(), "contains no frames", "frame_0000.png, frame_0001.png, ...");
  if (frames.empty()) {
    conversion.convert_one(in, out, false, result);
    return result;
  }
  if (is_picture_name(out)) {
    if (frames.size() > 1)
      throw Error(out.string(), fmt::format("is the name of one picture, but {} has {} frames", in.string(), frames.size()),
                  fmt::format("the name of a folder, or one frame, such as {}", frames.front().string()));
    conversion.convert_one(frames.front(), out, false, result);
    return result;
  }
  const NewFolder folder(out);
  for (const fs::path& frame : frames) conversion.convert_one(frame, out / conversion.name_of(frame), true, result);
  return result;
}

}  // namespace lippmann
