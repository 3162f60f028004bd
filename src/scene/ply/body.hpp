// Takes the values behind a PLY file's header one after the other, in any of the three formats.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "lippmann/core/error.hpp"
#include "scene/ply/header.hpp"

namespace lippmann::ply {

/// Every function throws Error, naming the element and its row, where the file ends or a value is not what it must be.
class Body {
 public:
  /// `name` and `bytes` must outlive this object.
  Body(const std::string& name, std::string_view bytes, Format format) : name_(name), bytes_(bytes), format_(format) {}

  /// What errors call the values to come. `element` must outlive this object.
  void set_place(const std::string& element, std::int64_t row) { element_ = &element, row_ = row; }

  std::size_t bytes_left() const { return bytes_.size(); }

  double value(Type type);

  /// A finite value of a size that can be computed with.
  double bounded(Type type);

  /// A whole number from 0 to `highest`.
  std::uint32_t index(Type type, double highest, std::string_view what) { return checked_index(value(type), highest, what); }
  std::uint32_t checked_index(double value, double highest, std::string_view what) const;

  /// As many floats of this machine's byte order as `row` has.
  void floats(std::span<float> row);

  /// The length of a list, at most `most`.
  std::uint32_t length(const Property& list, double most = 4294967295.0);

  /// Reads a property, a whole list too, and forgets it.
  void pass_over(const Property& property);

  /// Reads all rows of an element, and forgets them.
  void pass_over(const Element& element);

  Error error(std::string problem, std::string accepted = {}) const;

 private:
  double text_value();

  const std::string& name_;
  std::string_view bytes_;
  Format format_;
  const std::string* element_ = nullptr;
  std::int64_t row_ = 0;
};

/// Whether it is finite and of a size that can be computed with.
bool is_usable(double value);

/// The value of an integer type that counts as 1 where colours are meant; 1 for floats.
double full_scale(Type type);

}  // namespace lippmann::ply
