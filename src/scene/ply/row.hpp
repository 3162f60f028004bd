// One row of a PLY element, with conversions to coordinates, colours and texture numbers.
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
  /// `element` must outlive this object.
  explicit Row(const Element& element) : element_(element), values_(element.properties.size(), 0.0) {}

  void set(std::size_t column, double value) { values_[column] = value; }

  /// Reads all single values of the row from the body, and skips its lists.
  void read(Body& body);

  /// Returns a coordinate. Throws Error naming the property if is_usable(value) is false.
  double position(int column, const Body& body) const;

  double exact(int column) const { return values_[static_cast<std::size_t>(column)]; }
  float at(int column) const { return static_cast<float>(exact(column)); }

  /// Returns a colour component in the file's encoding, clamped to 0 ... 1. Counts clamped values for the warning.
  double share(int column);

  /// Returns the linear colour of the columns red, green and blue.
  Vec3f color(const std::array<int, 3>& columns);

  /// Returns a texture number, or -1 if the value is invalid.
  int picture(int column) const;

  void warn_about_clamped_colors(const std::string& file, const Context& context) const;

 private:
  const Element& element_;
  std::vector<double> values_;
  std::size_t cut_ = 0;
  double cut_scale_ = 1.0;  ///< the largest value of the last clamped component, from full_scale()
};

}  // namespace lippmann::ply
