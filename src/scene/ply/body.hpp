// Reads the values of a PLY file's body sequentially, in any of the three formats.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "lippmann/core/error.hpp"
#include "scene/ply/header.hpp"

namespace lippmann::ply {

/// The values of a PLY file's body. At the end of the file and for invalid values, all functions throw Error naming the element
/// and the row.
class Body {
 public:
  /// `name` and `bytes` must outlive this object.
  Body(const std::string& name, std::string_view bytes, Format format) : name_(name), bytes_(bytes), format_(format) {}

  /// Sets the element and row for messages. `element` must outlive this object.
  void set_place(const std::string& element, std::int64_t row) { element_ = &element, row_ = row; }

  std::size_t bytes_left() const { return bytes_.size(); }

  double value(Type type);

  /// Reads a finite value within a range that is safe for computation.
  double bounded(Type type);

  /// Reads a whole number from 0 to `highest`.
  std::uint32_t index(Type type, double highest, std::string_view what) { return checked_index(value(type), highest, what); }
  std::uint32_t checked_index(double value, double highest, std::string_view what) const;

  /// Reads floats in this machine's byte order to fill `row`.
  void floats(std::span<float> row);

  /// Reads the length of a list, at most `most`.
  std::uint32_t length(const Property& list, double most = 4294967295.0);

  /// Skips a property: a value or a whole list.
  void skip(const Property& property);

  /// Skips all rows of an element.
  void skip(const Element& element);

  Error error(std::string problem, std::string accepted = {}) const;

 private:
  double text_value();

  const std::string& name_;
  std::string_view bytes_;
  Format format_;
  const std::string* element_ = nullptr;
  std::int64_t row_ = 0;
};

/// Returns whether a value is finite and within a range that is safe for computation.
bool is_usable(double value);

/// Returns the value that stands for a colour component of 1: the largest integer of the type, or 1 for floats.
double full_scale(Type type);

}  // namespace lippmann::ply
