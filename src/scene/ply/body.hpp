#pragma once

#include <span>
#include <string>
#include <string_view>

#include "lippmann/core/error.hpp"
#include "scene/ply/header.hpp"

namespace lippmann::ply {

/// The values of a PLY file's body, in order, in any of its three encodings. All functions throw Error for invalid values and
/// at the end of the file. The message names the element and the row.
class Body {
 public:
  Body(const std::string& name, std::string_view bytes, Format format) : name_(name), bytes_(bytes), format_(format) {}

  /// Sets the element and the row that messages name. `element` must outlive this object.
  void set_place(const std::string& element, std::int64_t row) { element_ = &element, row_ = row; }

  std::size_t bytes_left() const { return bytes_.size(); }

  double value(Type type);

  /// Reads a value. Throws Error if is_usable(value) is false.
  double bounded(Type type);

  std::uint32_t index(Type type, double highest, std::string_view what) { return checked_index(value(type), highest, what); }
  std::uint32_t checked_index(double value, double highest, std::string_view what) const;

  void floats(std::span<float> row);

  std::uint32_t length(const Property& list, double most = 4294967295.0);

  void skip(const Property& property);

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

/// Returns whether a value is finite and small enough that its square does not overflow a float.
bool is_usable(double value);

/// Returns the integer or float that represents a colour component of 1: the largest integer of the type, or 1 for floats.
double full_scale(Type type);

}  // namespace lippmann::ply
