// Reads the elements of a glTF document that has passed the schema check (schema.hpp).
#pragma once

#include <cstddef>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace lippmann::gltf {

/// A reference to a JSON value, or to an absent property. An absent value has no properties or elements, and its getters return
/// their defaults. The getters do not check types because the schema check has done so. The document must outlive this object.
class Value {
 public:
  Value() = default;
  explicit Value(const nlohmann::json& json) : json_(&json) {}

  explicit operator bool() const { return json_ != nullptr; }

  Value operator[](std::string_view property) const;
  Value extension(std::string_view name) const { return (*this)["extensions"][name]; }
  Value at(std::size_t i) const;
  std::size_t size() const;

  double number(double otherwise) const;
  int integer(int otherwise) const;
  std::size_t count() const;
  int index() const { return integer(-1); }
  /// Returns a boolean value; for a number, returns whether it is not zero. `otherwise` is returned for an absent value.
  bool flag(bool otherwise) const;
  const std::string& text() const;

  /// These functions return the elements of an array or, for index_map(), the properties of an object. The result is empty if
  /// the value is absent.
  std::vector<double> numbers() const;
  std::vector<int> indices() const;
  std::map<std::string, int> index_map() const;
  /// Returns the first elements of an array of numbers as V: Vec2f, Vec3f or Vec4f. The array must be long enough.
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
