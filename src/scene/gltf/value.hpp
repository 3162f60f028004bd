// Reads the elements of a parsed glTF document that has passed the schema check (schema.hpp).
#pragma once

#include <cstddef>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace lippmann::gltf {

/// A reference to a JSON value, or to an absent property. All properties of an absent value are absent, and its getters return
/// their defaults. The getters do not check types because the schema check has done so. The document must outlive this object.
class Value {
 public:
  Value() = default;
  explicit Value(const nlohmann::json& json) : json_(&json) {}

  /// Returns whether the value is present.
  explicit operator bool() const { return json_ != nullptr; }

  /// Returns a property of an object.
  Value operator[](std::string_view property) const;
  /// Returns an extension of an object.
  Value extension(std::string_view name) const { return (*this)["extensions"][name]; }
  /// Returns an element of an array; i < size().
  Value at(std::size_t i) const;
  /// Returns the number of elements; 0 if absent.
  std::size_t size() const;

  double number(double otherwise) const;
  int integer(int otherwise) const;
  /// Returns a number of bytes or elements; 0 if absent.
  std::size_t count() const;
  /// Returns an index into one of the document's arrays; -1 if absent.
  int index() const { return integer(-1); }
  /// Returns a boolean. For a number, returns whether it is not zero.
  bool flag(bool otherwise) const;
  /// Returns a string; empty if absent.
  const std::string& text() const;

  /// Return a whole array, or the values of a whole object by name; empty if absent.
  std::vector<double> numbers() const;
  std::vector<int> indices() const;
  std::map<std::string, int> index_map() const;
  /// Returns the first elements of an array of numbers. The array must have at least as many as V: Vec2f, Vec3f, Vec4f.
  template <class V>
  V vector(V otherwise) const {
    for (int i = 0; json_ && i < V::length(); ++i)
      otherwise[i] = static_cast<float>(at(static_cast<std::size_t>(i)).number(0.0));
    return otherwise;
  }

 private:
  const nlohmann::json* json_ = nullptr;
};

}  // namespace lippmann::gltf
