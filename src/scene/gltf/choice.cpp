#include "scene/gltf/choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string_view>

#include "core/printable.hpp"
#include "core/suggest.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann::gltf {
namespace {

std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 20;
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), kMost); ++i)
    text += fmt::format("{}{} ({})", i > 0 ? ", " : "", printable(names[i]), i);
  return names.size() > kMost ? text + fmt::format(", ... ({})", names.size() - 1) : text;
}

}  // namespace

std::vector<std::string> names_in(Value array) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < array.size(); ++i) names.push_back(array.at(i)["name"].text());
  return names;
}

std::size_t choose(const char* parameter, const std::vector<std::string>& names, const std::string& wanted) {
  const auto named = std::find(names.begin(), names.end(), wanted);
  if (named != names.end()) return static_cast<std::size_t>(named - names.begin());
  std::size_t index = 0;
  const auto [end, problem] = std::from_chars(wanted.data(), wanted.data() + wanted.size(), index);
  if (problem == std::errc{} && end == wanted.data() + wanted.size() && index < names.size()) return index;
  const std::string hint = did_you_mean(wanted, std::vector<std::string_view>(names.begin(), names.end()));
  throw usage_error(parameter, shown(wanted) + " is not in the file" + hint, listed(names));
}

}  // namespace lippmann::gltf
