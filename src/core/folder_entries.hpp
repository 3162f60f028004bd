// Lists a folder in natural order: frame_9 before frame_10.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

namespace lippmann {

/// Compares runs of digits by value. Different names are never equal, even if they differ only in leading zeros.
bool natural_less(std::string_view a, std::string_view b);

/// Returns the entries of a folder in natural order, without hidden entries (.name). Throws Error that names the folder if it
/// cannot be listed. The message ends with `accepted`.
std::vector<std::filesystem::directory_entry> entries_of(const std::filesystem::path& folder, std::string_view accepted = {});

}  // namespace lippmann
