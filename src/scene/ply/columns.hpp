// Finds the properties of a PLY element that a reader uses, and warns about the properties that it does not use.
#pragma once

#include <array>
#include <initializer_list>
#include <optional>
#include <string_view>
#include <vector>

#include "lippmann/core/context.hpp"
#include "scene/ply/header.hpp"

namespace lippmann::ply {

/// Looks up columns by property name. A column is an index into Element::properties, or -1 for a property that does not exist.
/// Properties that were found count as used.
class Columns {
 public:
  /// `element` must outlive this object.
  explicit Columns(const Element& element) : element_(element), read_(element.properties.size(), false) {}

  /// Both functions return the column of the first property called `name`. value() looks for properties with a single value,
  /// list() for lists.
  int value(std::string_view name) { return mark(find(name, false)); }
  int list(std::string_view name) { return mark(find(name, true)); }

  /// Returns the columns of the first element of `sets` in which every name is a property with a single value.
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

  /// color() returns the columns of red, green and blue. alpha() returns the column of alpha.
  std::optional<std::array<int, 3>> color();
  int alpha();

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
