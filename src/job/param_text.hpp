// Converts parameter values to and from text. The functions read_* throw a usage Error at `where` that names the
// accepted values. Floats are written with the fewest digits that read back to the same value.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/extent.hpp"
#include "core/number_text.hpp"
#include "lippmann/formats/depth_coding.hpp"
#include "optics/optics_params.hpp"

namespace lippmann {

bool read_flag(std::string_view text, const std::string& where);

/// Reads "64" (y stays 0) or "64x32".
Extent<int> read_extent(std::string_view text, int lowest, int highest, const std::string& where);
Extent<float> read_extent(std::string_view text, float lowest, float highest, const std::string& where);
std::string write_extent(const Extent<int>& extent);
std::string write_extent(const Extent<float>& extent);

/// Reads a number of millimetres above 0, "inf", or "auto" (nullopt).
std::optional<float> read_distance(std::string_view text, const std::string& where);
std::string write_distance(std::optional<float> distance_mm);

/// Reads millimetres (150) or degrees (30deg).
EyeHeight read_eye_height(std::string_view text, const std::string& where);
std::string write_eye_height(const EyeHeight& height);

/// Reads NEAR:FAR in mm. FAR must be less than NEAR.
DepthRange read_depth_range(std::string_view text, const std::string& where);

/// Returns the index of `text` in `names`. The Error lists the names.
std::size_t read_choice(std::string_view text, std::span<const std::string_view> names, const std::string& where);

}  // namespace lippmann
