#include "core/suggest.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

namespace lippmann {

int edit_distance(std::string_view a, std::string_view b) {
  std::vector<int> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    int diagonal = row[0]++;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const int replaced = diagonal + (a[i] != b[j] ? 1 : 0);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
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

}  // namespace lippmann
