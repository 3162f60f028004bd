// How the glTF reader says what is wrong: Errors and warnings that name the file and the element.
#pragma once

#include <set>
#include <string>
#include <string_view>

#include "core/printable.hpp"
#include "lippmann/core/context.hpp"

namespace lippmann::gltf {

/// "meshes[3]", "meshes[3].primitives[0]".
std::string element(std::string_view array, std::size_t index);
std::string element(std::string_view array, std::size_t index, std::string_view sub_array, std::size_t sub_index);

/// Speaks for one file. Not thread-safe.
class Report {
 public:
  Report(std::string file, const Context& context) : file_(std::move(file)), context_(context) {}

  const Context& context() const { return context_; }

  /// "file: element", or the file alone.
  std::string where(std::string_view element) const;

  /// Throws Error there.
  [[noreturn]] void fail(std::string_view element, const std::string& problem, const std::string& accepted = {}) const;

  /// Warns about the file as a whole. Each text is reported once; after 50 texts, only that there are more.
  void warn(const std::string& text);

  /// Warns about something that may occur in many elements, once, naming the first of them.
  void warn_at(const std::string& text, std::string_view first_element);

  /// Warns in that way that `feature` ("skins are") is left out and what happens instead.
  void not_supported(const std::string& feature, const std::string& instead, std::string_view first_element);

 private:
  /// `text`, unless the topic has been spoken of.
  void say(const std::string& topic, const std::string& text);

  std::string file_;
  const Context& context_;
  std::set<std::string> said_;
};

}  // namespace lippmann::gltf
