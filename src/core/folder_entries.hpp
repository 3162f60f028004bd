// What lies in a folder, in the order in which people count: frame_9 before frame_10.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

namespace lippmann {

/// Letter by letter, runs of digits by their value. A strict order: names that differ in leading zeros alone differ.
bool natural_less(std::string_view a, std::string_view b);

/// The entries of a folder but the hidden ones (.name), in the natural order of their names. Throws Error naming the folder if
/// it cannot be listed; `accepted` says what it should be.
std::vector<std::filesystem::directory_entry> entries_of(const std::filesystem::path& folder, std::string_view accepted = {});

}  // namespace lippmann
