#include "lippmann/layout/convert.hpp"

#include <utility>

#include "core/folder.hpp"
#include "layout/light_field_source.hpp"
#include "layout/rgbd_name.hpp"
#include "layout/view_files.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/layout/open_light_field.hpp"
#include "lippmann/layout/quilt_name.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

class Conversion {
 public:
  explicit Conversion(const ConvertParams& params) : params_(params), to_(find_format(params.to, "to")) {}

  /// `is_frame`: the ending of `out` is that of `in`, not a wish.
  void convert_one(const fs::path& in, const fs::path& out, bool is_frame, Converted& result) const {
    FormatOptions reading = params_.options;
    reading.with_depth = to_.uses_cameras;
    if (to_.name == "stereo") reading.stereo.reset();  // it is what is made; pictures that are read have names
    OpenedLightField opened = open_light_field(in, params_.from, reading);
    LightField& field = opened.field;
    if (params_.keep) keep(field, *params_.keep, "keep");
    if (params_.crop) crop(field, *params_.crop, "crop");
    FormatOptions writing = params_.options;
    if (opened.format == "quilt") writing.tiles.reset();  // they are the source's
    fs::path path = out;
    if (to_.name != "quilt" && parse_quilt_name(path))
      throw usage_error("OUT", path.string() + " is the name of a quilt, and the format is " + std::string(to_.name),
                        "a name without _qs..., or `to` quilt");
    if (!to_.is_folder && (is_frame || !path.has_extension())) path.replace_extension(exact_ending(field.stack));
    const NewFolder folder(to_.is_folder ? path : path.parent_path());
    for (fs::path& file : to_.write(field, path, writing)) result.written.push_back(std::move(file));
    result.views = field.grid, result.view_size = field.view_size;
    result.drops_positions = field.positions && to_.name != "stanford" && !(to_.uses_cameras && field.cameras);
    result.lacks_cameras = to_.uses_cameras && !field.cameras;
    result.lacks_depth = to_.uses_cameras && field.cameras && !field.depth;
  }

  /// What a frame is called there. Only a quilt is named like one: `to_` names its own.
  fs::path name_of(const fs::path& frame) const {
    const fs::path bare = without_rgbd_name(without_stereo_name(without_quilt_name(frame.filename())));
    return to_.is_folder ? bare.stem() : bare;
  }

 private:
  const ConvertParams& params_;
  const LightFieldFormat& to_;
};

}  // namespace

Converted convert(const fs::path& in, const fs::path& out, const ConvertParams& params) {
  const Conversion conversion(params);
  Converted result;
  std::error_code ignored;
  const bool is_folder = fs::is_directory(in, ignored);
  const std::vector<fs::path> frames = is_folder ? light_field_frames(in, params.from) : std::vector<fs::path>();
  const bool may_be_one = params.from.empty() || find_format(params.from, "from").is_folder || !is_folder;
  if (frames.empty() && !may_be_one) throw Error(in.string(), "contains no frames", "frame_0000.png, frame_0001.png, ...");
  if (frames.empty()) {
    conversion.convert_one(in, out, false, result);
    return result;
  }
  const NewFolder folder(out);
  for (const fs::path& frame : frames) conversion.convert_one(frame, out / conversion.name_of(frame), true, result);
  return result;
}

}  // namespace lippmann
