// Finds the known name most similar to a misspelt one, for messages.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace lippmann {

/// Returns the restricted Damerau-Levenshtein distance: the number of edits that turn `a` into `b`. An edit inserts, removes or
/// replaces a letter, or exchanges two neighbours; no letter is edited twice.
int edit_distance(std::string_view a, std::string_view b);

/// Returns the candidate with the smallest edit distance to `name` (the first of equals), if that is at most half of the length
/// of `name`. Otherwise returns the first candidate that contains `name`, ignoring dashes, if `name` has 3 letters or more.
/// Otherwise returns an empty string.
std::string nearest_name(std::string_view name, std::span<const std::string_view> candidates);

/// Returns a suffix for messages, such as ", did you mean 'lenses'?", or an empty string. Safe to print.
std::string did_you_mean(std::string_view name, std::span<const std::string_view> candidates);

}  // namespace lippmann
