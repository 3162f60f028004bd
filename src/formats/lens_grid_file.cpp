#include "formats/lens_grid_file.hpp"

#include <array>
#include <nlohmann/json.hpp>
#include <span>
#include <vector>

#include "core/atomic_file.hpp"
#include "core/json_fields.hpp"
#include "core/json_text.hpp"
#include "core/recorded_file.hpp"
#include "core/regular_file.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

constexpr std::array<std::string_view, 3> kArrangements{"square", "hexagonal", "hexagonal-columns"};
constexpr NumberRange kPitchPx{2.0, 4096.0}, kRowPitchPx{1.0, 4096.0}, kTurnDeg{-180.0, 180.0}, kPlacePx{-1e6, 1e6};

std::filesystem::path lens_grid_side_path(const std::filesystem::path& picture) {
  return std::filesystem::path(picture) += ".json";
}

}  // namespace

std::string_view name_of(LensArrangement arrangement) { return kArrangements[static_cast<std::size_t>(arrangement)]; }

std::optional<LensArrangement> read_arrangement(std::string_view name) {
  for (std::size_t i = 0; i < kArrangements.size(); ++i)
    if (kArrangements[i] == name) return static_cast<LensArrangement>(i);
  return std::nullopt;
}

nlohmann::ordered_json lens_grid_json(const LensGrid& grid) {
  return {{"arrangement", name_of(grid.arrangement)},
          {"pitch_px", grid.pitch_px},
          {"row_pitch_px", grid.row_pitch_px},
          {"rotation_deg", grid.rotation * 180.0 / std::numbers::pi},
          {"offset_px", {grid.offset_px.x, grid.offset_px.y}}};
}

std::optional<LensGrid> parse_lens_grid(const std::string& text, const std::string& where) {
  const nlohmann::ordered_json json = json_from_text(text);
  if (json.is_discarded()) throw Error(where, "is not JSON", "a JSON side file, or no file of that name");
  if (!json.is_object() || !json.contains("plenoptic")) return std::nullopt;
  const JsonFields fields = JsonFields(json, where, "").inner("plenoptic");
  fields.allow_only({"arrangement", "pitch_px", "row_pitch_px", "rotation_deg", "offset_px"});
  const std::size_t arrangement = fields.word("arrangement", {kArrangements.begin(), kArrangements.end()});
  const double turn = fields.number_or("rotation_deg", kTurnDeg, 0.0) * std::numbers::pi / 180.0;
  LensGrid grid = lens_grid(fields.number("pitch_px", kPitchPx), turn, fields.pair("offset_px", kPlacePx),
                            static_cast<LensArrangement>(arrangement));
  grid.row_pitch_px = fields.number_or("row_pitch_px", kRowPitchPx, grid.row_pitch_px);
  return grid;
}

std::filesystem::path write_lens_grid(const std::filesystem::path& picture, const LensGrid& grid) {
  const std::filesystem::path path = lens_grid_side_path(picture);
  const std::string text = json_to_text({{"plenoptic", lens_grid_json(grid)}}, -1) + '\n';
  write_file_atomically(path, std::as_bytes(std::span(text)));
  return path;
}

std::optional<LensGrid> read_lens_grid(const std::filesystem::path& picture) {
  const std::filesystem::path path = lens_grid_side_path(picture);
  if (!is_regular_file_there(path)) return std::nullopt;
  constexpr std::uintmax_t kMaxBytes = 1 << 20;
  return parse_lens_grid(read_recorded_text(path, kMaxBytes, "the side file of a picture"), path.string());
}

}  // namespace lippmann
