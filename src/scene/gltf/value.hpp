// Reads the elements of a parsed glTF document that has passed the schema (schema.hpp).
#pragma once

#include <cstddef>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace lippmann::gltf {

/// A reference to a JSON value, or to nothing where the file leaves a property out: then every property of it is absent too,
/// and the getters return their default. The schema has checked that each value is of the kind that its getter reads, which
/// none of them checks again. The document must outlive it.
class Value {
 public:
  Value() = default;
  explicit Value(const nlohmann::json& json) : json_(&json) {}

  /// Whether the file has it.
  explicit operator bool() const { return json_ != nullptr; }

  /// A property of an object.
  Value operator[](std::string_view property) const;
  /// The same of its extensions.
  Value extension(std::string_view name) const { return (*this)["extensions"][name]; }
  /// An element of an array; i < size().
  Value at(std::size_t i) const;
  /// The number of elements; 0 where it is absent.
  std::size_t size() const;

  double number(double otherwise) const;
  int integer(int otherwise) const;
  /// A number of bytes or elements; 0 where it is absent.
  std::size_t count() const;
  /// An index into one of the document's arrays; -1 where it is absent.
  int index() const { return integer(-1); }
  /// true, false, or a number that is 0 or not.
  bool flag(bool otherwise) const;
  /// Empty where it is absent.
  const std::string& text() const;

  /// A whole array, or the values of a whole object by name. Empty where it is absent.
  std::vector<double> numbers() const;
  std::vector<int> indices() const;
  std::map<std::string, int> index_map() const;
  /// An array of at least as many numbers as V has: Vec2f, Vec3f, Vec4f.
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
