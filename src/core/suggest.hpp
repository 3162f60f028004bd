// The known name nearest to a misspelt one, for messages.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace lippmann {

/// The distance of Damerau and Levenshtein (restricted): how many single letters to insert, remove or replace, or neighbours to
/// exchange, to turn `a` into `b`; no letter is changed twice.
int edit_distance(std::string_view a, std::string_view b);

/// The candidate with the smallest edit distance to `name` (the first of equals), within half of the letters of `name`; else
/// the first one that contains it, whatever its dashes (of 3 letters or more); else empty.
std::string nearest_name(std::string_view name, std::span<const std::string_view> candidates);

/// That name as ", did you mean 'lenses'?", to stand behind what is wrong; empty if there is none. Safe to print.
std::string did_you_mean(std::string_view name, std::span<const std::string_view> candidates);

}  // namespace lippmann
