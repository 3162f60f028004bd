// Serialises plain structs of the library for pickling and deep copies.
//
// The number of initialisers that a struct accepts gives the number of its members, so new members need no change here.
//
// The bytes depend on the machine and the build. Reading throws Error if the library's version or the struct's size differs.
#pragma once

#include <array>
#include <cstring>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "bindings.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/core/math.hpp"
#include "lippmann/core/version.hpp"
#include "lippmann/image/image.hpp"
#include "lippmann/trace/integrator.hpp"

namespace lippmann::python {

/// Converts to any type, to test how many initialisers an aggregate accepts.
struct AnyValue {
  template <class T>
  requires(!std::is_lvalue_reference_v<T>) operator T() const;  // NOLINT(google-explicit-constructor)
};

template <class T, std::size_t... I>
constexpr bool takes(std::index_sequence<I...>) {
  return requires { T{(static_cast<void>(I), AnyValue{})...}; };
}

template <class T, std::size_t N = 33>
constexpr std::size_t field_count() {
  if constexpr (takes<T>(std::make_index_sequence<N>()))
    return N;
  else
    return field_count<T, N - 1>();
}

/// Calls fn for every field of a struct with up to 32 fields, in order.
template <class T, class Fn>
void for_each_field(T& value, const Fn& fn) {
  constexpr std::size_t kFields = field_count<std::remove_const_t<T>>();
  static_assert(kFields <= 32);
  const auto each = [&](auto&... fields) { (fn(fields), ...); };
  if constexpr (kFields == 0) static_cast<void>(value);
#define LIPPMANN_FIELDS(n, ...)   \
  if constexpr (kFields == (n)) { \
    auto& [__VA_ARGS__] = value;  \
    each(__VA_ARGS__);            \
  }
  // clang-format off
  LIPPMANN_FIELDS(1, a)
  LIPPMANN_FIELDS(2, a, b)
  LIPPMANN_FIELDS(3, a, b, c)
  LIPPMANN_FIELDS(4, a, b, c, d)
  LIPPMANN_FIELDS(5, a, b, c, d, e)
  LIPPMANN_FIELDS(6, a, b, c, d, e, f)
  LIPPMANN_FIELDS(7, a, b, c, d, e, f, g)
  LIPPMANN_FIELDS(8, a, b, c, d, e, f, g, h)
  LIPPMANN_FIELDS(9, a, b, c, d, e, f, g, h, i)
  LIPPMANN_FIELDS(10, a, b, c, d, e, f, g, h, i, j)
  LIPPMANN_FIELDS(11, a, b, c, d, e, f, g, h, i, j, k)
  LIPPMANN_FIELDS(12, a, b, c, d, e, f, g, h, i, j, k, l)
  LIPPMANN_FIELDS(13, a, b, c, d, e, f, g, h, i, j, k, l, m)
  LIPPMANN_FIELDS(14, a, b, c, d, e, f, g, h, i, j, k, l, m, n)
  LIPPMANN_FIELDS(15, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o)
  LIPPMANN_FIELDS(16, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p)
  LIPPMANN_FIELDS(17, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q)
  LIPPMANN_FIELDS(18, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r)
  LIPPMANN_FIELDS(19, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s)
  LIPPMANN_FIELDS(20, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t)
  LIPPMANN_FIELDS(21, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u)
  LIPPMANN_FIELDS(22, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v)
  LIPPMANN_FIELDS(23, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v, w)
  LIPPMANN_FIELDS(24, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v, w, x)
  LIPPMANN_FIELDS(25, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v, w, x, y)
  LIPPMANN_FIELDS(26, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v, w, x, y, z)
  LIPPMANN_FIELDS(27, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v, w, x, y, z, A)
  LIPPMANN_FIELDS(28, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v, w, x, y, z, A, B)
  LIPPMANN_FIELDS(29, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v, w, x, y, z, A, B, C)
  LIPPMANN_FIELDS(30, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v, w, x, y, z, A, B, C, D)
  LIPPMANN_FIELDS(31, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v, w, x, y, z, A, B, C, D, E)
  LIPPMANN_FIELDS(32, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v, w, x, y, z, A, B, C, D, E, F)
  // clang-format on
#undef LIPPMANN_FIELDS
}

template <class T>
inline constexpr bool kIsNumber = std::is_arithmetic_v<T> || std::is_enum_v<T>;
template <int N, class T>
inline constexpr bool kIsNumber<glm::vec<N, T>> = true;
template <int C, int R, class T>
inline constexpr bool kIsNumber<glm::mat<C, R, T>> = true;
template <class T>
inline constexpr bool kIsNumber<glm::qua<T>> = true;
template <class T, std::size_t N>
inline constexpr bool kIsNumber<std::array<T, N>> = kIsNumber<T>;

/// Passes a value and its members, recursively, to an ArchiveWriter or ArchiveReader.
template <class Archive>
class Walk {
 public:
  explicit Walk(Archive& archive) : archive_(archive) {}

  template <class T>
  void operator()(T& value) const {
    using Plain = std::remove_const_t<T>;
    if constexpr (kIsNumber<Plain>)
      archive_.raw(&value, sizeof value);
    else
      part(value);
  }

 private:
  template <class T>
  void part(T& value) const {
    for_each_field(value, *this);
  }
  void part(const Image& image) const { image_parts(image); }
  void part(Image& image) const { image_parts(image); }
  template <class T>
  void part(const std::vector<T>& values) const {
    elements(values);
  }
  template <class T>
  void part(std::vector<T>& values) const {
    elements(values);
  }
  void part(const std::string& text) const { elements(text); }
  void part(std::string& text) const { elements(text); }
  template <class T, std::size_t N>
  void part(const std::array<T, N>& values) const {
    each(values);
  }
  template <class T, std::size_t N>
  void part(std::array<T, N>& values) const {
    each(values);
  }
  void part(const std::optional<Integrator>& value) const {
    const std::string name(value ? value->facts().name : std::string_view());
    part(name);
  }
  void part(std::optional<Integrator>& value) const {
    std::string name;
    part(name);
    value.reset();
    for (const Integrator known : integrators())
      if (known.facts().name == name) value = known;
  }
  template <class T>
  void part(const std::optional<T>& value) const {
    archive_.optional(value, *this);
  }
  template <class T>
  void part(std::optional<T>& value) const {
    archive_.optional(value, *this);
  }
  template <class... T>
  void part(const std::variant<T...>& value) const {
    archive_.variant(value, *this);
  }
  template <class... T>
  void part(std::variant<T...>& value) const {
    archive_.variant(value, *this);
  }
  template <class T>
  void part(const std::shared_ptr<const T>& value) const {
    archive_.shared(value, *this);
  }
  template <class T>
  void part(std::shared_ptr<const T>& value) const {
    archive_.shared(value, *this);
  }

  void image_parts(auto& image) const {
    (*this)(image.width), (*this)(image.height), (*this)(image.channels);
    (*this)(image.data);
  }
  void each(auto& values) const {
    for (auto& value : values) (*this)(value);
  }
  void bits(auto& values) const {
    for (std::size_t i = 0; i < values.size(); ++i) {
      bool value = values[i];
      (*this)(value);
      if constexpr (!std::is_const_v<std::remove_reference_t<decltype(values)>>) values[i] = value;
    }
  }
  void elements(auto& values) const {
    archive_.length(values);
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(values)>, std::vector<bool>>)
      bits(values);
    else if constexpr (kIsNumber<typename std::remove_cvref_t<decltype(values)>::value_type>)
      archive_.raw(values.data(), values.size() * sizeof(*values.data()));
    else
      each(values);
  }

  Archive& archive_;
};

class ArchiveWriter {
 public:
  std::string bytes;

  void raw(const void* data, std::size_t size) { bytes.append(static_cast<const char*>(data), size); }
  void length(const auto& values) {
    const std::size_t size = values.size();
    raw(&size, sizeof size);
  }
  void optional(const auto& value, const auto& walk) {
    const bool is_there = value.has_value();
    walk(is_there);
    if (value) walk(*value);
  }
  void variant(const auto& value, const auto& walk) {
    const std::size_t index = value.index();
    raw(&index, sizeof index);
    std::visit([&](const auto& held) { walk(held); }, value);
  }
  void shared(const auto& value, const auto& walk) {
    const bool is_there = value != nullptr;
    walk(is_there);
    if (value) walk(*value);
  }
};

/// Throws Error if the bytes end early.
class ArchiveReader {
 public:
  explicit ArchiveReader(std::string_view bytes) : left_(bytes) {}

  void raw(void* data, std::size_t size) {
    require(size);
    if (size > 0) std::memcpy(data, left_.data(), size);
    left_.remove_prefix(size);
  }
  void length(auto& values) {
    std::size_t size = 0;
    raw(&size, sizeof size);
    require(size);  // throws if fewer than `size` bytes are left, because each element takes at least one byte
    values.resize(size);
  }
  template <class T>
  void optional(std::optional<T>& value, const auto& walk) {
    if (is_there())
      walk(value.emplace());
    else
      value.reset();
  }
  template <class... T>
  void variant(std::variant<T...>& value, const auto& walk) {
    std::size_t index = 0, i = 0;
    raw(&index, sizeof index);
    if (index >= sizeof...(T)) refuse();
    ((i++ == index ? walk(value.template emplace<T>()) : void()), ...);
  }
  template <class T>
  void shared(std::shared_ptr<const T>& value, const auto& walk) {
    value.reset();
    if (!is_there()) return;
    auto made = std::make_shared<T>();
    walk(*made);
    value = std::move(made);
  }
  void require_end() const {
    if (!left_.empty()) refuse();
  }

  [[noreturn]] static void refuse() {
    throw Error("pickle", "is damaged or was written by another version", std::string("a pickle of lippmann ") + version());
  }

 private:
  bool is_there() {
    unsigned char flag = 0;
    raw(&flag, 1);
    return flag != 0;
  }
  void require(std::size_t size) const {
    if (size > left_.size()) refuse();
  }

  std::string_view left_;
};

template <class T>
std::string archived(const T& value) {
  ArchiveWriter writer;
  const Walk walk(writer);
  const std::string made_by = version();
  const std::size_t size = sizeof(T);
  walk(made_by), walk(size);
  walk(value);
  return std::move(writer.bytes);
}

/// Throws Error unless archived() made the bytes from the same type in the same version.
template <class T>
T unarchived(std::string_view bytes) {
  ArchiveReader reader(bytes);
  const Walk walk(reader);
  std::string made_by;
  std::size_t size = 0;
  walk(made_by), walk(size);
  if (made_by != version() || size != sizeof(T)) ArchiveReader::refuse();
  T value{};
  walk(value);
  reader.require_end();
  return value;
}

/// Adds support for pickling and deep copies to a class: class_.def(pickled<T>()).
template <class T>
auto pickled() {
  return py::pickle([](const T& value) { return py::bytes(archived(value)); },
                    [](const py::bytes& bytes) { return unarchived<T>(static_cast<std::string_view>(bytes)); });
}

}  // namespace lippmann::python
