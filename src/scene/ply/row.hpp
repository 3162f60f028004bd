#pragma once

#include <array>
#include <string>
#include <vector>

#include "lippmann/core/context.hpp"
#include "lippmann/core/math.hpp"
#include "scene/ply/body.hpp"

namespace lippmann::ply {

/// The values of a row. A column is the index in Element::properties of a property with a single value.
class Row {
 public:
  explicit Row(const Element& element) : element_(element), values_(element.properties.size(), 0.0) {}

  void set(std::size_t column, double value) { values_[column] = value; }

  void read(Body& body);

  double position(int column, const Body& body) const;

  double exact(int column) const { return values_[static_cast<std::size_t>(column)]; }
  float at(int column) const { return static_cast<float>(exact(column)); }

  /// Returns a colour component in the file's encoding, clamped to 0 ... 1. Counts clamped values for the warning.
  double share(int column);

  Vec3f color(const std::array<int, 3>& columns);

  int picture(int column) const;

  void warn_about_clamped_colors(const std::string& file, const Context& context) const;

 private:
  const Element& element_;
  std::vector<double> values_;
  std::size_t cut_ = 0;
  double cut_scale_ = 1.0;
};

}  // namespace lippmann::ply
