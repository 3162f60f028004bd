// The lens grid of a raw plenoptic picture as JSON, as in the side file <picture>.json and in the output of `convert`.
//
//   {"plenoptic": {"arrangement": "hexagonal", "pitch_px": 10.135, "row_pitch_px": 8.777, "rotation_deg": 0.1,
//                  "offset_px": [5.2, 6.1]}}
//
// If "row_pitch_px" is missing, the lenses are equally spaced. If "rotation_deg" is missing, the grid is not rotated.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "lippmann/layout/lens_grid.hpp"

namespace lippmann {

/// read_arrangement() returns none for an unknown name.
std::string_view name_of(LensArrangement arrangement);
std::optional<LensArrangement> read_arrangement(std::string_view name);

/// The object under the key "plenoptic" of a side file.
nlohmann::ordered_json lens_grid_json(const LensGrid& grid);

/// Returns none if the document has no key "plenoptic". Throws Error naming `where` and the key.
std::optional<LensGrid> parse_lens_grid(const std::string& text, const std::string& where);

/// Reads the side file of a picture; none if it does not exist or describes something else.
std::optional<LensGrid> read_lens_grid(const std::filesystem::path& picture);

/// Writes the side file of a picture and returns its path.
std::filesystem::path write_lens_grid(const std::filesystem::path& picture, const LensGrid& grid);

}  // namespace lippmann
