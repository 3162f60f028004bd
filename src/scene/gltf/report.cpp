#include "scene/gltf/report.hpp"

#include <fmt/format.h>

#include "lippmann/core/error.hpp"

namespace lippmann::gltf {

std::string element(std::string_view array, std::size_t index) { return fmt::format("{}[{}]", array, index); }

std::string element(std::string_view array, std::size_t index, std::string_view sub_array, std::size_t sub_index) {
  return fmt::format("{}[{}].{}[{}]", array, index, sub_array, sub_index);
}

std::string Report::where(std::string_view element) const {
  return element.empty() ? file_ : fmt::format("{}: {}", file_, element);
}

void Report::fail(std::string_view element, const std::string& problem, const std::string& accepted) const {
  throw Error(where(element), problem, accepted);
}

void Report::report_once(const std::string& topic, const std::string& text) {
  constexpr std::size_t kMost = 50;
  if (reported_.size() > kMost || !reported_.insert(topic).second) return;
  context_.warning(fmt::format("{}: {}", file_, reported_.size() > kMost ? "further warnings are left out" : text));
}

void Report::warn(const std::string& text) { report_once(text, text); }

void Report::warn_at(const std::string& text, std::string_view first_element) {
  report_once(text, fmt::format("{} (first at {})", text, first_element));
}

void Report::not_supported(const std::string& feature, const std::string& instead, std::string_view first_element) {
  warn_at(fmt::format("{} not supported: {}", feature, instead), first_element);
}

}  // namespace lippmann::gltf
