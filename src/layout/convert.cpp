#include "layout/convert.hpp"

#include <algorithm>

#include "core/error.hpp"
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

class Conversion {
 public:
  explicit Conversion(const ConvertParams& params)
      : params_(params),
        from_(find_format(params.from, "--from")),
        to_(find_format(params.to, "--to")),
        writing_(params.options) {
    if (params.from == "quilt") writing_.tiles.reset();  // they are the source's
  }

  const LightFieldFormat& from() const { return from_; }
  const LightFieldFormat& to() const { return to_; }

  void convert_one(const fs::path& in, const fs::path& out, Converted& result) const {
    LightField field = from_.read(in, params_.options);
    if (params_.keep) keep(field, *params_.keep, "--keep");
    if (params_.crop) crop(field, *params_.crop, "--crop");
    fs::path path = out;
    if (!to_.is_folder && !path.has_extension()) path += std::string(".") + exact_ending(field.stack);
    for (fs::path& file : to_.write(field, path, writing_)) result.written.push_back(std::move(file));
    result.views = field.grid, result.view_size = field.view_size;
  }

 private:
  const ConvertParams& params_;
  const LightFieldFormat &from_, &to_;
  FormatOptions writing_;
};

}  // namespace

Converted convert(const fs::path& in, const fs::path& out, const ConvertParams& params) {
  const Conversion conversion(params);
  Converted result;
  std::error_code ignored;
  const bool is_folder = fs::is_directory(in, ignored);
  const std::vector<fs::path> frames = is_folder ? frames_in(in, conversion.from().is_folder) : std::vector<fs::path>();
  if (is_folder && frames.empty() && !conversion.from().is_folder)
    throw Error(in.string(), "there are no frames in it", "frame_0000.png, frame_0001.png, ...");
  if (frames.empty()) {
    conversion.convert_one(in, out, result);
    return result;
  }
  make_folder(out);
  for (const fs::path& frame : frames)
    conversion.convert_one(frame, out / (conversion.to().is_folder ? frame.stem() : frame.filename()), result);
  return result;
}

}  // namespace lippmann
