#include "scene/left_out.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/printable.hpp"

namespace lippmann {

void LeftOut::add(std::string_view name, const std::string& where) {
  if (count_++ == 0) first_ = where;
  constexpr std::size_t kMost = 100;
  if (names_.size() < kMost && std::find(names_.begin(), names_.end(), name) == names_.end()) names_.emplace_back(name);
}

void LeftOut::warn(const Context& context, std::string_view singular, std::string_view plural) const {
  if (names_.empty()) return;
  const bool one = names_.size() == 1;
  const std::string count = count_ > names_.size() ? fmt::format(" ({} in all)", count_) : std::string();
  context.warning(
      fmt::format("{}: the {} {}{} {} left out.", first_, one ? singular : plural, listed(names_), count, one ? "is" : "are"));
}

std::string listed(std::span<const std::string> names) {
  constexpr std::size_t kMost = 10;
  const std::size_t shown_names = std::min(names.size(), kMost);
  std::string text;
  for (std::size_t i = 0; i < shown_names; ++i) {
    const bool last = i + 1 == names.size();
    text += fmt::format("{}{}", i == 0 ? "" : last ? " and " : ", ", shown(names[i]));
  }
  if (names.size() > kMost) text += fmt::format(" and {} more", names.size() - kMost);
  return text;
}

}  // namespace lippmann
