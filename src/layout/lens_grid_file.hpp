// The lens grid of a raw plenoptic picture as JSON: in the side file <picture>.json, and as `convert` prints it.
//
//   {"plenoptic": {"arrangement": "hexagonal", "pitch_px": 10.135, "row_pitch_px": 8.777, "rotation_deg": 0.1,
//                  "offset_px": [5.2, 6.1]}}
//
// Without "row_pitch_px" rows are as far apart as those of equal lenses, and without "rotation_deg" the grid is upright.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "lippmann/layout/lens_grid.hpp"

namespace lippmann {

/// The name of an arrangement, and back; none for another word.
std::string_view name_of(LensArrangement arrangement);
std::optional<LensArrangement> read_arrangement(std::string_view name);

/// The value of "plenoptic".
nlohmann::ordered_json lens_grid_json(const LensGrid& grid);

/// Returns nothing for a document without "plenoptic". Throws Error naming `where` and the key.
std::optional<LensGrid> parse_lens_grid(const std::string& text, const std::string& where);

/// The grid in the side file of a picture; none if there is no such file, or it is about something else.
std::optional<LensGrid> read_lens_grid(const std::filesystem::path& picture);

}  // namespace lippmann
