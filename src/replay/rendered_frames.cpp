#include "replay/rendered_frames.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <variant>

#include "core/error.hpp"
#include "core/json_text.hpp"
#include "core/printable.hpp"
#include "image/picture_file.hpp"
#include "layout/rendered.hpp"
#include "optics/optics_json.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::uintmax_t kMaxReportBytes = std::uintmax_t{256} << 20;  ///< a frame takes some 500 bytes

Json read_report(const fs::path& path) {
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored))
    throw Error(path.string(), "there is no such file, so that nothing says for which optics the pictures were rendered",
                "the report.json that `lippmann render` writes beside its pictures");
  if (fs::file_size(path, ignored) > kMaxReportBytes) throw Error(path.string(), "is too large for a report");
  std::ifstream file(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  Json json = json_from_text(text);
  if (!json.is_object()) throw Error(path.string(), "is not a JSON object", "the report.json that `lippmann render` writes");
  if (!json.contains("optics"))
    throw Error(path.string(), "does not say for which optics the pictures were rendered", "an object \"optics\"");
  return json;
}

const Json* setting(const Json& report, const char* name) {
  const auto settings = report.find("settings");
  if (settings == report.end() || !settings->is_object() || !settings->contains(name)) return nullptr;
  return &(*settings)[name];
}

/// Lens arrays are replayed from what lies behind them, views of them are not.
void check_layout(const Json& report, const Optics& optics, const std::string& where) {
  const Json* mirror = setting(report, "mirror");
  if (mirror && mirror->is_boolean() && mirror->get<bool>())
    throw Error(where, "the pictures are mirrored, to be printed on the back of a sheet", "a render without --mirror");
  const Json* layout = setting(report, "layout");
  if (!layout || !layout->is_string()) return;
  const std::string word = layout->get<std::string>();
  const bool is_quilt = std::holds_alternative<MultiView>(optics.model);
  if (word == "views" || (word == "quilt" && !is_quilt) || (word == "integral" && is_quilt))
    throw Error(where, "the pictures are " + shown(word) + ", not what the display itself shows",
                "a render without --layout, or `lippmann convert` and its folder's report");
}

bool is_frame(const fs::directory_entry& entry) {
  const std::string name = entry.path().filename().string(), ending = entry.path().extension().string();
  return name.starts_with("frame_") && entry.is_regular_file() &&
         (ending == ".png" || ending == ".exr" || ending == ".tif" || ending == ".tiff");
}

std::vector<fs::path> frames_in(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code problem;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, problem))
    if (is_frame(entry)) files.push_back(entry.path());
  if (problem) throw Error(folder.string(), "cannot be listed: " + problem.message());
  if (files.empty()) throw Error(folder.string(), "there are no frames in it", "frame_0000.png, frame_0001.png, ...");
  std::sort(files.begin(), files.end(), [](const fs::path& a, const fs::path& b) {
    const std::string x = a.filename().string(), y = b.filename().string();
    return x.size() != y.size() ? x.size() < y.size() : x < y;
  });
  return files;
}

}  // namespace

std::vector<fs::path> pictures_of(const fs::path& in) {
  std::error_code ignored;
  if (!fs::exists(in, ignored)) throw Error(in.string(), "there is no such file or folder");
  return fs::is_directory(in, ignored) ? frames_in(in) : std::vector{in};
}

RenderedFrames find_rendered_frames(const fs::path& in, const fs::path& report) {
  std::error_code ignored;
  RenderedFrames frames;
  frames.files = pictures_of(in);
  const bool folder = fs::is_directory(in, ignored);
  const fs::path report_path = report.empty() ? (folder ? in : in.parent_path()) / "report.json" : report;
  const Json json = read_report(report_path);
  frames.optics = optics_from_json(json["optics"], report_path.string());
  check_layout(json, frames.optics, report_path.string());
  frames.frames_per_second = frame_rate_of(json).value_or(frames.frames_per_second);
  return frames;
}

Picture read_panel_picture(const RenderedFrames& frames, const fs::path& file) {
  Picture picture = read_picture(file);
  const Vec2i panel = picture_size(frames.optics);
  const Vec2i size = std::visit([](const auto& image) { return Vec2i(image.width, image.height); }, picture);
  if (size != panel)
    throw Error(file.string(),
                fmt::format("has {}x{} pixels, but was rendered for a panel of {}x{}, says its report", size.x, size.y, panel.x,
                            panel.y),
                "the pictures as the render wrote them");
  return picture;
}

RenderedPanel read_rendered_panel(const RenderedFrames& frames, std::size_t index) {
  return {frames.optics, to_linear(read_panel_picture(frames, frames.files[index]))};
}

std::string frame_label(const fs::path& file) {
  const std::string stem = file.stem().string();
  if (!stem.starts_with("frame_")) return stem;
  std::size_t end = 6;
  while (end < stem.size() && std::isdigit(static_cast<unsigned char>(stem[end]))) ++end;
  return end > 6 ? stem.substr(6, end - 6) : stem;
}

}  // namespace lippmann
