#include "formats/views_side_file.hpp"

#include <nlohmann/json.hpp>
#include <span>

#include "core/atomic_file.hpp"
#include "core/json_fields.hpp"
#include "core/json_text.hpp"
#include "core/recorded_file.hpp"
#include "core/regular_file.hpp"
#include "formats/camera_json.hpp"

namespace lippmann {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;

fs::path views_side_path(const fs::path& folder) { return folder / "views.json"; }

}  // namespace

std::optional<ViewsSideFile> parse_views_side_file(const std::string& text, const std::string& where) {
  constexpr NumberRange kSides{1, 4096};
  const Json json = json_from_text(text);
  if (json.is_discarded()) throw json_error(text, where);
  if (!json.is_object() || !json.contains("views")) return std::nullopt;
  const JsonFields fields(json["views"], where, "views");
  ViewsSideFile side;
  if (fields.has("columns") || fields.has("rows")) side.grid = {fields.whole("columns", kSides), fields.whole("rows", kSides)};
  if (fields.has("pixel_aspect")) side.pixel_aspect = fields.number("pixel_aspect", {1e-3, 1e3});
  for (const char* key : {"positions", "cameras"})
    if (fields.has(key) && !side.grid) fields.reject(key, "needs columns and rows", "columns and rows beside it");
  if (fields.has("positions")) side.positions = points_in(fields, "positions", side.grid->count());
  if (fields.has("cameras")) side.cameras = cameras_in(fields.inner("cameras"), side.grid->count());
  return side;
}

std::optional<ViewsSideFile> read_views_side_file(const fs::path& folder) {
  constexpr std::uintmax_t kMaxBytes = std::uintmax_t{1} << 26;
  if (!has_views_side_file(folder)) return std::nullopt;
  const fs::path path = views_side_path(folder);
  return parse_views_side_file(read_recorded_text(path, kMaxBytes, "the side file of a folder of views"), path.string());
}

std::string views_side_text(const ViewsSideFile& side) {
  Json views = Json::object();
  if (side.grid) views["columns"] = side.grid->columns, views["rows"] = side.grid->rows;
  if (side.pixel_aspect) views["pixel_aspect"] = *side.pixel_aspect;
  if (side.positions) views["positions"] = points_json(*side.positions);
  if (side.cameras) views["cameras"] = cameras_json(*side.cameras);
  return json_to_text(Json{{"views", views}}, -1) + '\n';
}

fs::path write_views_side_file(const fs::path& folder, const ViewsSideFile& side) {
  const std::string text = views_side_text(side);
  write_file_atomically(views_side_path(folder), std::as_bytes(std::span(text)));
  return views_side_path(folder);
}

bool has_views_side_file(const fs::path& folder) { return is_regular_file_there(views_side_path(folder)); }

}  // namespace lippmann
