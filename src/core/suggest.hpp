// Finds the known name most similar to a misspelt one, for messages.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace lippmann {

/// Returns the restricted Damerau-Levenshtein distance: the number of letters to insert, remove or replace, or of neighbours to
/// exchange, to turn `a` into `b`; no letter is changed twice.
int edit_distance(std::string_view a, std::string_view b);

/// Returns the candidate with the smallest edit distance to `name` (the first of equals), at most half of the letters of
/// `name`; otherwise the first candidate that contains the name (of 3 letters or more), ignoring dashes; otherwise an empty
/// string.
std::string nearest_name(std::string_view name, std::span<const std::string_view> candidates);

/// Returns a suffix for messages, such as ", did you mean 'lenses'?", or an empty string. Safe to print.
std::string did_you_mean(std::string_view name, std::span<const std::string_view> candidates);

}  // namespace lippmann
