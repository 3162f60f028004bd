#pragma once

#include <array>
#include <initializer_list>
#include <optional>
#include <string_view>
#include <vector>

#include "lippmann/core/context.hpp"
#include "scene/ply/header.hpp"

namespace lippmann::ply {

/// Looks up columns by property name. A column is an index into Element::properties, or -1. Properties that were found count as
/// used.
class Columns {
 public:
  explicit Columns(const Element& element) : element_(element), read_(element.properties.size(), false) {}

  /// value() and list() return the column of the first property called `name`. value() only finds properties with a single
  /// value, list() only lists.
  int value(std::string_view name) { return mark(find(name, false)); }
  int list(std::string_view name) { return mark(find(name, true)); }

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
