// Pictures of what a benchmark of path-traced light has compared: the frames and where they differ.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bench/light_figures.hpp"

namespace lippmann::bench {

/// What error pictures multiply differences by; no difference is mid-grey.
inline constexpr int kErrorGain = 8;
inline constexpr int kMidGrey = 128;

/// Code by code test - reference, amplified around mid-grey. Pictures of one size.
Image8 error_picture(const Image8& reference, const Image8& test);

/// The same of block means, every block filled with its own; what belongs to no block is mid-grey.
Image8 block_error_picture(const Image8& reference, const Image8& test, const std::vector<Block>& blocks);

/// Writes FOLDER/NAME_reference.png, _full, _reuse, and of the reuse _error and _block_error. Makes the folder; throws Error
/// where a file cannot be written.
void write_light_pictures(const std::filesystem::path& folder, const std::string& name, const Image8& reference,
                          const Image8& full, const Image8& reuse, const std::vector<Block>& blocks);

}  // namespace lippmann::bench
