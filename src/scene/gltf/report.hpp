#pragma once

#include <set>
#include <string>
#include <string_view>

#include "core/printable.hpp"
#include "lippmann/core/context.hpp"

namespace lippmann::gltf {

std::string element(std::string_view array, std::size_t index);
std::string element(std::string_view array, std::size_t index, std::string_view sub_array, std::size_t sub_index);

/// Reports the problems of one file. Not thread-safe.
class Report {
 public:
  Report(std::string file, const Context& context) : file_(std::move(file)), context_(context) {}

  const Context& context() const { return context_; }

  std::string where(std::string_view element) const;

  [[noreturn]] void fail(std::string_view element, const std::string& problem, const std::string& accepted = {}) const;

  /// Warns about the whole file. Each text is reported once. After 50 different texts, one last warning says that further
  /// warnings are left out.
  void warn(const std::string& text);

  /// Warns about a problem that may occur in many elements. Only the first call with a given `text` has an effect; it names the
  /// element.
  void warn_at(const std::string& text, std::string_view first_element);

  /// Warns once that `feature`, such as "skins are", is not supported. `instead` states what the reader does instead.
  void not_supported(const std::string& feature, const std::string& instead, std::string_view first_element);

 private:
  void report_once(const std::string& topic, const std::string& text);

  std::string file_;
  const Context& context_;
  std::set<std::string> reported_;
};

}  // namespace lippmann::gltf
