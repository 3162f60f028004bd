// The single values of one row of a PLY element, as coordinates, colours and numbers of pictures.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "lippmann/core/context.hpp"
#include "lippmann/core/math.hpp"
#include "scene/ply/body.hpp"

namespace lippmann::ply {

/// Columns are indices into Element::properties, of single values.
class Row {
 public:
  /// `element` must outlive this object.
  explicit Row(const Element& element) : element_(element), values_(element.properties.size(), 0.0) {}

  void set(std::size_t column, double value) { values_[column] = value; }

  /// Takes all single values from the body and passes over lists.
  void read(Body& body);

  /// A value that can be computed with; throws Error that names its property where it is not.
  double position(int column, const Body& body) const;

  double exact(int column) const { return values_[static_cast<std::size_t>(column)]; }
  float at(int column) const { return static_cast<float>(exact(column)); }

  /// A colour's share, 0 to 1, encoded as the file has it. Counts values beyond.
  double share(int column);

  /// Red, green and blue, linear.
  Vec3f color(const std::array<int, 3>& columns);

  /// -1 for what is no number of a picture.
  int picture(int column) const;

  /// Warns of shares that were cut.
  void warn_of_cut_colors(const std::string& file, const Context& context) const;

 private:
  const Element& element_;
  std::vector<double> values_;
  std::size_t cut_ = 0;
  double cut_scale_ = 1.0;  ///< what counts as 1 where a share was cut
};

}  // namespace lippmann::ply
