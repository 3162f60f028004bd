// How the glTF reader says what is wrong: Errors and warnings that name the file and the element.
#pragma once

#include <set>
#include <string>
#include <string_view>

#include "core/context.hpp"
#include "core/printable.hpp"

namespace lippmann::gltf {

/// "meshes[3]", "meshes[3].primitives[0]".
std::string element(std::string_view array, std::size_t index);
std::string element(std::string_view array, std::size_t index, std::string_view sub_array, std::size_t sub_index);

/// Speaks for one file. Not thread-safe.
class Report {
 public:
  Report(std::string file, const Context& context) : file_(std::move(file)), context_(context) {}

  /// "file: element", or the file alone.
  std::string where(std::string_view element) const;

  /// Throws Error there.
  [[noreturn]] void fail(std::string_view element, const std::string& problem, const std::string& accepted = {}) const;

  /// Warns about the file as a whole; the same text is said once.
  void warn(const std::string& text);

  /// Warns that `feature` is left out and what happens instead, once per feature, naming the first element that has it.
  void not_supported(const std::string& feature, const std::string& instead, std::string_view first_element);

 private:
  std::string file_;
  const Context& context_;
  std::set<std::string> said_;
};

}  // namespace lippmann::gltf
