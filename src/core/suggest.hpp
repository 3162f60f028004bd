// The known name nearest to a misspelt one, for messages.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace lippmann {

/// The Levenshtein distance: how many single letters to insert, remove or replace to turn `a` into `b`.
int edit_distance(std::string_view a, std::string_view b);

/// The candidate with the smallest edit distance to `name` (the first of equals), within half of the letters of `name`; else
/// the first one that contains it, whatever its dashes (of 3 letters or more); else empty.
std::string nearest_name(std::string_view name, std::span<const std::string_view> candidates);

}  // namespace lippmann
