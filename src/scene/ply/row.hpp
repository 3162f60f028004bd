// One row of a PLY element. Converts its values to coordinates, colours and texture numbers.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "lippmann/core/context.hpp"
#include "lippmann/core/math.hpp"
#include "scene/ply/body.hpp"

namespace lippmann::ply {

/// Columns are indices of single values in Element::properties.
class Row {
 public:
  /// `element` must outlive this object.
  explicit Row(const Element& element) : element_(element), values_(element.properties.size(), 0.0) {}

  void set(std::size_t column, double value) { values_[column] = value; }

  /// Reads all single values from the body and skips lists.
  void read(Body& body);

  /// Returns a value that is safe for computation. Throws Error naming its property otherwise.
  double position(int column, const Body& body) const;

  double exact(int column) const { return values_[static_cast<std::size_t>(column)]; }
  float at(int column) const { return static_cast<float>(exact(column)); }

  /// Returns a colour component clamped to 0 ... 1, in the file's encoding. Counts clamped values.
  double share(int column);

  /// Returns red, green and blue in linear light.
  Vec3f color(const std::array<int, 3>& columns);

  /// Returns a texture number, or -1 if the value is not a valid texture number.
  int picture(int column) const;

  /// Warns about clamped components.
  void warn_about_clamped_colors(const std::string& file, const Context& context) const;

 private:
  const Element& element_;
  std::vector<double> values_;
  std::size_t cut_ = 0;
  double cut_scale_ = 1.0;  ///< full scale of a clamped component
};

}  // namespace lippmann::ply
