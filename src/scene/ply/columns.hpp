// Finds the properties of a PLY element that a reader uses, and reports the others.
#pragma once

#include <array>
#include <initializer_list>
#include <optional>
#include <string_view>
#include <vector>

#include "lippmann/core/context.hpp"
#include "scene/ply/header.hpp"

namespace lippmann::ply {

/// Finds columns, which are indices into Element::properties; -1: absent. Marks the properties found as read.
class Columns {
 public:
  /// `element` must outlive this object.
  explicit Columns(const Element& element) : element_(element), read_(element.properties.size(), false) {}

  /// Return the first property called `name` that is a single value, or that is a list.
  int value(std::string_view name) { return mark(find(name, false)); }
  int list(std::string_view name) { return mark(find(name, true)); }

  /// Returns the columns of the first set of names that all exist as single values.
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

  /// Return the columns of red, green and blue, and the column of alpha.
  std::optional<std::array<int, 3>> color();
  int alpha();

  /// Warns about unread properties by name.
  void warn_about_unread(const std::string& file, const Context& context) const;

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
