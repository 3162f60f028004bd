#include "layout/convert.hpp"

#include <algorithm>
#include <utility>

#include "core/error.hpp"
#include "layout/cameras.hpp"
#include "layout/quilt_name.hpp"
#include "layout/rendered.hpp"
#include "layout/view_files.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

/// The frames of an animation in a folder: pictures, or folders for formats that are folders. None: the folder is one itself.
std::vector<fs::path> frames_in(const fs::path& folder, bool are_folders) {
  std::vector<fs::path> frames;
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
    const bool fits = are_folders ? entry.is_directory() : entry.is_regular_file();
    if (fits && entry.path().filename().string().starts_with("frame_") && entry.path().extension() != ".json")
      frames.push_back(entry.path());
  }
  std::sort(frames.begin(), frames.end());
  return frames;
}

/// What is known of a light field from beside it.
struct Source {
  const LightFieldFormat* format = nullptr;
  FormatOptions options;
  std::optional<RenderedViews> rendered;
};

/// The name of the format that a picture or a folder of views is rendered in.
std::string format_of(const fs::path& in, const std::optional<RenderedViews>& rendered, const std::string& layout) {
  std::error_code ignored;
  if (fs::is_directory(in, ignored)) return "views";
  if (parse_quilt_name(in)) return "quilt";
  if (!layout.empty()) return layout;
  if (!rendered) throw usage_error("--from", "nothing says what " + in.string() + " is", "the name of a format");
  switch (rendered->film.kind) {
    case LayoutKind::kQuilt:
      return "quilt";
    case LayoutKind::kStack:
      throw usage_error("--from", in.string() + " is a single view", "pictures of several");
    default:
      return "integral";
  }
}

/// Flags go over what the report says.
Source source_of(const fs::path& in, const ConvertParams& params, bool with_depth) {
  Source source{nullptr, params.options, {}};
  const bool may_be_rendered =
      params.from.empty() || params.from == "integral" || params.from == "quilt" || params.from == "views";
  const std::optional<Rendering> rendering = may_be_rendered ? rendering_of(in) : std::nullopt;
  if (rendering) source.rendered = rendered_views(with_parallax(rendering->optics, rendering->depth_scale));
  const std::string layout = rendering ? rendering->layout : std::string();
  source.format = &find_format(params.from.empty() ? format_of(in, source.rendered, layout) : params.from, "--from");
  source.options.with_depth = with_depth;
  if (!source.rendered) return source;
  const ViewLayout& film = source.rendered->film;
  if (!source.options.views) source.options.views = film.grid;
  const bool said_by_name = parse_quilt_name(in).has_value();
  if (!source.options.tiles && film.kind == LayoutKind::kQuilt && !said_by_name) source.options.tiles = film.tiles;
  return source;
}

/// A folder that is to be made: where nothing is in it in the end and it was not there before, it goes again.
class NewFolder {
 public:
  explicit NewFolder(fs::path path) : path_(std::move(path)) {
    std::error_code ignored;
    was_there_ = fs::exists(path_, ignored);
  }
  ~NewFolder() {
    std::error_code ignored;
    if (!was_there_ && fs::is_directory(path_, ignored)) fs::remove(path_, ignored);  // fails where anything is in it
  }
  NewFolder(const NewFolder&) = delete;
  NewFolder& operator=(const NewFolder&) = delete;

 private:
  fs::path path_;
  bool was_there_ = false;
};

class Conversion {
 public:
  explicit Conversion(const ConvertParams& params) : params_(params), to_(find_format(params.to, "--to")) {}

  void convert_one(const fs::path& in, const fs::path& out, Converted& result) const {
    const Source source = source_of(in, params_, to_.uses_cameras);
    LightField field = source.format->read(in, source.options);
    if (to_.uses_cameras && source.rendered && source.rendered->film.grid == field.grid)
      field.cameras = source.rendered->cameras;
    if (params_.keep) keep(field, *params_.keep, "--keep");
    if (params_.crop) crop(field, *params_.crop, "--crop");
    FormatOptions writing = params_.options;
    if (source.format->name == "quilt") writing.tiles.reset();  // they are the source's
    fs::path path = out;
    if (!to_.is_folder && !path.has_extension()) path += std::string(".") + exact_ending(field.stack);
    const NewFolder folder(path);
    for (fs::path& file : to_.write(field, path, writing)) result.written.push_back(std::move(file));
    result.views = field.grid, result.view_size = field.view_size;
    result.lacks_cameras = to_.uses_cameras && !field.cameras;
    result.lacks_depth = to_.uses_cameras && field.cameras && !field.depth;
  }

  /// What a frame is called there.
  fs::path name_of(const fs::path& frame) const { return to_.is_folder ? frame.stem() : frame.filename(); }

 private:
  const ConvertParams& params_;
  const LightFieldFormat& to_;
};

/// The frames in a folder: for formats that are folders, folders; for others, pictures; where nothing is said, what there is.
std::vector<fs::path> frames_in(const fs::path& folder, const ConvertParams& params) {
  if (!params.from.empty()) return frames_in(folder, find_format(params.from, "--from").is_folder);
  const std::vector<fs::path> pictures = frames_in(folder, false);
  return pictures.empty() ? frames_in(folder, true) : pictures;
}

}  // namespace

Converted convert(const fs::path& in, const fs::path& out, const ConvertParams& params) {
  const Conversion conversion(params);
  Converted result;
  std::error_code ignored;
  const bool is_folder = fs::is_directory(in, ignored);
  const std::vector<fs::path> frames = is_folder ? frames_in(in, params) : std::vector<fs::path>();
  const bool may_be_one = params.from.empty() || find_format(params.from, "--from").is_folder || !is_folder;
  if (frames.empty() && !may_be_one)
    throw Error(in.string(), "there are no frames in it", "frame_0000.png, frame_0001.png, ...");
  if (frames.empty()) {
    conversion.convert_one(in, out, result);
    return result;
  }
  const NewFolder folder(out);
  make_folder(out);
  for (const fs::path& frame : frames) conversion.convert_one(frame, out / conversion.name_of(frame), result);
  return result;
}

}  // namespace lippmann
