#include "lippmann/replay/rendered_frames.hpp"

#include <fmt/format.h>

#include <cctype>
#include <variant>

#include "core/printable.hpp"
#include "formats/frame_names.hpp"
#include "formats/rendered.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/formats/quilt_name.hpp"
#include "lippmann/image/picture_file.hpp"
#include "lippmann/optics/viewing.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;
/// Throws for rearranged views of lens arrays, which cannot be replayed.
void check_layout(const Rendering& rendering, const std::string& where) {
  if (rendering.mirrored)
    throw Error(where, "the pictures are mirrored, to be printed on the back of a sheet", "a render without `mirror`");
  const std::string& layout = rendering.layout;
  const bool is_quilt = view_tiles(rendering.optics).has_value();
  if (layout == "views" || layout == "eslf" || (layout == "quilt" && !is_quilt) || (layout == "integral" && is_quilt))
    throw Error(where, "the pictures have the layout " + shown(layout) + ", not the layout of the panel",
                "a render without `layout`, or a conversion of the pictures to integral");
}

std::vector<fs::path> pictures_in(const fs::path& folder) {
  std::vector<fs::path> files = frame_pictures_in(folder);
  if (files.empty()) throw Error(folder.string(), "contains no frames", "frame_0000.png, frame_0001.png, ...");
  return files;
}

}  // namespace

std::vector<fs::path> pictures_of(const fs::path& in) {
  std::error_code ignored;
  if (!fs::exists(in, ignored)) throw Error(in.string(), "there is no such file or folder");
  return fs::is_directory(in, ignored) ? pictures_in(in) : std::vector{in};
}

RenderedFrames find_rendered_frames(const fs::path& in, const fs::path& report) {
  std::error_code ignored;
  RenderedFrames frames;
  frames.files = pictures_of(in);
  const bool folder = fs::is_directory(in, ignored);
  const fs::path report_path = report.empty() ? (folder ? in : in.parent_path()) / "report.json" : report;
  const Rendering rendering = read_rendering(report_path);
  check_layout(rendering, report_path.string());
  frames.optics = rendering.optics;
  frames.frames_per_second = rendering.frames_per_second.value_or(frames.frames_per_second);
  return frames;
}

Picture read_panel_picture(const RenderedFrames& frames, const fs::path& file) {
  Picture picture = read_picture(file);
  const Vec2i panel = picture_size(frames.optics);
  const Vec2i size = std::visit([](const auto& image) { return Vec2i(image.width, image.height); }, picture);
  if (size != panel)
    throw Error(file.string(),
                fmt::format("has {}x{} pixels, but its report states a panel of {}x{}", size.x, size.y, panel.x, panel.y),
                "the pictures as the render wrote them");
  return picture;
}

RenderedPanel read_rendered_panel(const RenderedFrames& frames, std::size_t index) {
  return {frames.optics, to_linear(read_panel_picture(frames, frames.files[index]))};
}

std::string frame_label(const fs::path& file) {
  // Removes the tiles and aspect from a quilt's name, because images made from a quilt are not quilts.
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored) && !file.filename().string().starts_with("frame_"))
    return file.filename().string();
  const std::string stem = without_quilt_name(file).stem().string();
  if (!stem.starts_with("frame_")) return stem;
  std::size_t end = 6;
  while (end < stem.size() && std::isdigit(static_cast<unsigned char>(stem[end]))) ++end;
  return end > 6 ? stem.substr(6, end - 6) : stem;
}

}  // namespace lippmann
