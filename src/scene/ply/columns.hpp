// Finds the properties of a PLY element that a reader uses, and names the others.
#pragma once

#include <array>
#include <initializer_list>
#include <optional>
#include <string_view>
#include <vector>

#include "lippmann/core/context.hpp"
#include "scene/ply/header.hpp"

namespace lippmann::ply {

/// Columns are indices into Element::properties; -1: there is none. What is found counts as read.
class Columns {
 public:
  /// `element` must outlive this object.
  explicit Columns(const Element& element) : element_(element), read_(element.properties.size(), false) {}

  /// The first property of this name that is a single value; of a list that is one.
  int value(std::string_view name) { return mark(find(name, false)); }
  int list(std::string_view name) { return mark(find(name, true)); }

  /// The first of these sets of single values of which all are there.
  template <std::size_t N>
  std::optional<std::array<int, N>> values(std::initializer_list<std::array<std::string_view, N>> sets) {
    for (const std::array<std::string_view, N>& names : sets) {
      std::array<int, N> columns;
      bool complete = true;
      for (std::size_t i = 0; i < N; ++i) complete &= (columns[i] = find(names[i], false)) >= 0;
      if (!complete) continue;
      for (const int column : columns) mark(column);
      return columns;
    }
    return std::nullopt;
  }

  /// Red, green and blue; the names of alpha that go with them are those of alpha().
  std::optional<std::array<int, 3>> color();
  int alpha();

  /// Warns of the properties that are not read, by name.
  void warn_of_unread(const std::string& file, const Context& context) const;

 private:
  int find(std::string_view name, bool is_list) const;
  int mark(int column) {
    if (column >= 0) read_[static_cast<std::size_t>(column)] = true;
    return column;
  }

  const Element& element_;
  std::vector<bool> read_;
};

}  // namespace lippmann::ply
