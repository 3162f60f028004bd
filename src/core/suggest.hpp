#pragma once

#include <span>
#include <string>
#include <string_view>

namespace lippmann {

/// Returns the restricted Damerau-Levenshtein distance: the number of letters that are inserted, removed, replaced or exchanged
/// with a neighbour to turn `a` into `b`. No letter is edited twice.
int edit_distance(std::string_view a, std::string_view b);

/// Returns a name similar to `name`, by these rules:
/// 1. the first candidate with the smallest edit distance, if the distance is at most half of the length of `name`;
/// 2. otherwise, if `name` has at least 3 letters, the first candidate that contains it (dashes are ignored);
/// 3. otherwise an empty string.
std::string nearest_name(std::string_view name, std::span<const std::string_view> candidates);

std::string did_you_mean(std::string_view name, std::span<const std::string_view> candidates);

}  // namespace lippmann
