#include "formats/eslf_side_file.hpp"

#include <nlohmann/json.hpp>
#include <span>

#include "core/atomic_file.hpp"
#include "core/json_fields.hpp"
#include "core/json_text.hpp"
#include "core/recorded_file.hpp"
#include "core/regular_file.hpp"
#include "formats/camera_json.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;
using EslfJson = nlohmann::ordered_json;

constexpr int kMaxEslfSide = 1024;
constexpr std::string_view kEslfTable = "eslf";

}  // namespace

fs::path eslf_side_path(const fs::path& picture) { return fs::path(picture) += ".json"; }

std::optional<EslfSideFile> read_eslf_side_file(const fs::path& picture) {
  constexpr std::uintmax_t kMaxBytes = std::uintmax_t{1} << 26;
  const fs::path path = eslf_side_path(picture);
  if (!is_regular_file_there(path)) return std::nullopt;
  return parse_eslf_side_file(read_recorded_text(path, kMaxBytes, "the side file of a plenoptic camera's picture"),
                              path.string());
}

std::optional<EslfSideFile> parse_eslf_side_file(const std::string& text, const std::string& where) {
  const EslfJson json = json_from_text(text);
  if (!json.is_object() || !json.contains(kEslfTable)) return std::nullopt;
  const JsonFields fields = JsonFields(json, where, "").inner(kEslfTable);
  const NumberRange side_range{1, kMaxEslfSide};
  EslfSideFile side;
  side.grid = {fields.whole("columns", side_range), fields.whole("rows", side_range)};
  if (fields.has("positions")) side.positions = points_in(fields, "positions", side.grid.count());
  if (fields.has("cameras")) side.cameras = cameras_in(fields.inner("cameras"), side.grid.count());
  const double of_cameras = side.cameras ? side.cameras->pixel_mm.x / side.cameras->pixel_mm.y : 1.0;
  side.pixel_aspect = fields.number_or("pixel_aspect", {1e-3, 1e3}, of_cameras);
  return side;
}

std::string eslf_side_text(const EslfSideFile& side) {
  EslfJson table{{"columns", side.grid.columns}, {"rows", side.grid.rows}};
  if (side.pixel_aspect != 1.0) table["pixel_aspect"] = side.pixel_aspect;
  if (side.positions) table["positions"] = points_json(*side.positions);
  if (side.cameras) table["cameras"] = cameras_json(*side.cameras);
  return json_to_text(EslfJson{{std::string(kEslfTable), table}}, -1) + '\n';
}

fs::path write_eslf_side_file(const fs::path& picture, const EslfSideFile& side) {
  const fs::path path = eslf_side_path(picture);
  const std::string text = eslf_side_text(side);
  write_file_atomically(path, std::as_bytes(std::span(text)));
  return path;
}

}  // namespace lippmann
