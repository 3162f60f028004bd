#include "core/suggest.hpp"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "core/printable.hpp"

namespace lippmann {

int edit_distance(std::string_view a, std::string_view b) {
  std::vector<int> row(b.size() + 1), above(row), two_above;
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    two_above = std::exchange(above, row);
    ++row[0];
    for (std::size_t j = 0; j < b.size(); ++j) {
      row[j + 1] = std::min({above[j] + (a[i] != b[j] ? 1 : 0), row[j] + 1, above[j + 1] + 1});
      const bool exchanged = i > 0 && j > 0 && a[i] == b[j - 1] && a[i - 1] == b[j];
      if (exchanged) row[j + 1] = std::min(row[j + 1], two_above[j - 1] + 1);
    }
  }
  return row.back();
}

namespace {

std::string without_dashes(std::string_view name) {
  std::string letters(name);
  std::erase(letters, '-');
  return letters;
}

std::string first_containing(std::string_view name, std::span<const std::string_view> candidates) {
  const std::string part = without_dashes(name);
  if (part.size() < 3) return {};
  for (const std::string_view candidate : candidates)
    if (without_dashes(candidate).find(part) != std::string::npos) return std::string(candidate);
  return {};
}

}  // namespace

std::string nearest_name(std::string_view name, std::span<const std::string_view> candidates) {
  int best_distance = static_cast<int>(name.size()) / 2;
  std::string best;
  for (const std::string_view candidate : candidates) {
    const int distance = edit_distance(name, candidate);
    if (distance > best_distance || (distance == best_distance && !best.empty())) continue;
    best_distance = distance;
    best = candidate;
  }
  return best.empty() ? first_containing(name, candidates) : best;
}

std::string did_you_mean(std::string_view name, std::span<const std::string_view> candidates) {
  const std::string nearest = nearest_name(name, candidates);
  return nearest.empty() ? nearest : ", did you mean '" + printable(nearest) + "'?";
}

}  // namespace lippmann
