// Based on: Khronos Group, "glTF 2.0 Specification", 2021, sections 3.6.2 "Accessors" and 3.11 "Animations", which defines the
// value of a normalised integer c: c / max if unsigned, max(c / max, -1) if signed, where max is the largest value of the type.
#include "scene/gltf/accessor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

namespace lippmann::gltf {
namespace {

std::size_t component_bytes(ComponentType type) {
  switch (type) {
    case ComponentType::kByte:
    case ComponentType::kUnsignedByte:
      return 1;
    case ComponentType::kShort:
    case ComponentType::kUnsignedShort:
      return 2;
    case ComponentType::kUnsignedInt:
    case ComponentType::kFloat:
      return 4;
    default:
      return 0;
  }
}

bool is_unsigned(ComponentType type) {
  return type == ComponentType::kUnsignedByte || type == ComponentType::kUnsignedShort || type == ComponentType::kUnsignedInt;
}

/// Each column of a matrix begins at a multiple of four bytes.
std::size_t element_bytes(const Accessor& a) {
  const std::size_t component = component_bytes(a.component_type), side = static_cast<std::size_t>(a.matrix_side);
  return side ? side * ((side * component + 3) / 4 * 4) : static_cast<std::size_t>(a.components) * component;
}

struct Elements {
  Bytes bytes;
  std::size_t stride = 0;
  std::size_t count = 0;
  const std::byte* operator[](std::size_t i) const { return bytes.data() + i * stride; }
};

/// Throws Error unless offset + (count - 1) * stride + size <= view.byte_length. The check cannot overflow.
Elements locate(const Document& document, int view_index, std::size_t offset, std::size_t size, std::size_t count,
                const std::string& where) {
  const BufferView& view = document.buffer_views[static_cast<std::size_t>(view_index)];
  const std::size_t stride = view.byte_stride ? view.byte_stride : size;
  const bool fits = offset <= view.byte_length && size <= view.byte_length - offset &&
                    count - 1 <= (view.byte_length - offset - size) / stride;
  if (stride < size)
    document.report.fail(where, fmt::format("has elements of {} bytes with a stride of {} bytes", size, stride));
  if (!fits)
    document.report.fail(
        where, fmt::format("{} elements of {} bytes from byte {} on lie outside bufferViews[{}], which has {} bytes", count,
                           size, offset, view_index, view.byte_length));
  return {document.view(view_index).subspan(offset), stride, count};
}

Elements dense_elements(const Document& document, const Accessor& a, const std::string& where) {
  return locate(document, a.buffer_view, a.byte_offset, element_bytes(a), a.count, where);
}

struct SparseElements {
  Elements indices, values;
};

SparseElements sparse_elements(const Document& document, const Accessor& a, const std::string& where) {
  const Sparse& s = *a.sparse;
  if (!is_unsigned(s.index_type))
    document.report.fail(where + ".sparse.indices", "the component type is not an unsigned integer");
  if (s.count > a.count)
    document.report.fail(where + ".sparse",
                         fmt::format("replaces {} elements, but the accessor has only {}", s.count, a.count));
  return {locate(document, s.index_view, s.index_offset, component_bytes(s.index_type), s.count, where + ".sparse.indices"),
          locate(document, s.value_view, s.value_offset, element_bytes(a), s.count, where + ".sparse.values")};
}

template <class C>
C load(const std::byte* at) {
  C value;
  std::memcpy(&value, at, sizeof value);
  return value;
}

template <class F>
void with_unsigned(ComponentType type, const F& use) {
  switch (type) {
    case ComponentType::kUnsignedByte:
      return use(std::uint8_t{});
    case ComponentType::kUnsignedShort:
      return use(std::uint16_t{});
    default:
      return use(std::uint32_t{});
  }
}

template <class F>
void with_component(ComponentType type, const F& use) {
  switch (type) {
    case ComponentType::kByte:
      return use(std::int8_t{});
    case ComponentType::kShort:
      return use(std::int16_t{});
    case ComponentType::kFloat:
      return use(float{});
    default:
      return with_unsigned(type, use);
  }
}

template <class T>
constexpr std::size_t kComponents = sizeof(T) / 4;

template <class C>
float to_float(C c, bool normalized) {
  const float x = static_cast<float>(c);
  if constexpr (std::is_integral_v<C>)
    if (normalized) return std::max(x / static_cast<float>(std::numeric_limits<C>::max()), -1.0f);
  return x;
}

struct Target {
  float* values;
  std::size_t components;
  float* operator[](std::size_t i) const { return values + i * components; }
};

std::uint32_t sparse_index(const Accessor& a, const SparseElements& sparse, std::size_t i) {
  std::uint32_t index = 0;
  with_unsigned(a.sparse->index_type, [&](auto c) { index = load<decltype(c)>(sparse.indices[i]); });
  return index;
}

void fill(const Document& document, const Accessor& a, const std::string& where, Target target) {
  const auto convert = [&](const std::byte* from, float* to) {
    with_component(a.component_type, [&](auto c) {
      using C = decltype(c);
      for (std::size_t k = 0; k < target.components; ++k) to[k] = to_float(load<C>(from + k * sizeof(C)), a.normalized);
    });
  };
  if (a.buffer_view >= 0) {
    const Elements elements = dense_elements(document, a, where);
    for (std::size_t i = 0; i < a.count; ++i) convert(elements[i], target[i]);
  }
  if (!a.sparse) return;
  const SparseElements sparse = sparse_elements(document, a, where);
  for (std::size_t i = 0; i < sparse.indices.count; ++i) {
    const std::uint32_t index = sparse_index(a, sparse, i);
    if (index >= a.count)
      document.report.fail(where + ".sparse.indices",
                           fmt::format("replaces element {}, but the number of elements is {}", index, a.count));
    convert(sparse.values[i], target[index]);
  }
}

std::string_view type_name(std::size_t components) {
  switch (components) {
    case 1:
      return "SCALAR";
    case 2:
      return "VEC2";
    case 3:
      return "VEC3";
    case 4:
      return "VEC4";
    default:
      return "MAT4";
  }
}

const Accessor& accessor_of_type(const Document& document, int index, std::size_t components) {
  const Accessor& a = document.accessor(index);
  const bool square = a.matrix_side == 2;  // a MAT2 also has four components, but it is not a VEC4
  if (static_cast<std::size_t>(a.components) != components || square)
    document.report.fail(element("accessors", static_cast<std::size_t>(index)), "has the wrong type for its use",
                         std::string(type_name(components)));
  return a;
}

}  // namespace

void check_views(const Document& document) {
  for (std::size_t i = 0; i < document.buffer_views.size(); ++i) {
    const BufferView& view = document.buffer_views[i];
    const std::size_t available = document.buffers[static_cast<std::size_t>(view.buffer)].size();
    if (view.byte_offset > available || view.byte_length > available - view.byte_offset)
      document.report.fail(element("bufferViews", i),
                           fmt::format("{} bytes from byte {} on lie outside buffers[{}], which has {} bytes", view.byte_length,
                                       view.byte_offset, view.buffer, available));
  }
}

void check_accessors(const Document& document) {
  for (std::size_t i = 0; i < document.accessors.size(); ++i) {
    const Accessor& a = document.accessors[i];
    const std::string where = element("accessors", i);
    if (!component_bytes(a.component_type))
      document.report.fail(where, fmt::format("has the component type {}", static_cast<int>(a.component_type)),
                           "5120, 5121, 5122, 5123, 5125, 5126");
    if (a.buffer_view >= 0) dense_elements(document, a, where);
    if (a.sparse) sparse_elements(document, a, where);
  }
}

template <class T>
std::vector<T> unpack(Document& document, int index) {
  constexpr std::size_t components = kComponents<T>;
  const std::string where = element("accessors", static_cast<std::size_t>(index));
  const Accessor& a = accessor_of_type(document, index, components);
  document.unpacked.spend(a.count, sizeof(T), where, document.report);
  std::vector<T> values(a.count, T(0.0f));
  const Target target{reinterpret_cast<float*>(values.data()), components};
  fill(document, a, where, target);
  for (std::size_t i = 0; i < a.count * components; ++i)
    if (!std::isfinite(target.values[i])) document.report.fail(where, fmt::format("element {} is not finite", i / components));
  return values;
}

template <class T>
std::vector<T> unpack_unsigned(Document& document, int index) {
  constexpr std::size_t components = kComponents<T>;
  const std::string where = element("accessors", static_cast<std::size_t>(index));
  const Accessor& a = accessor_of_type(document, index, components);
  if (!is_unsigned(a.component_type) || a.buffer_view < 0 || a.sparse)
    document.report.fail(where, "does not hold plain unsigned integers", "component type 5121, 5123 or 5125, not sparse");
  document.unpacked.spend(a.count, sizeof(T), where, document.report);
  std::vector<T> values(a.count);
  std::uint32_t* out = reinterpret_cast<std::uint32_t*>(values.data());
  const Elements elements = dense_elements(document, a, where);
  with_unsigned(a.component_type, [&](auto c) {
    using C = decltype(c);
    for (std::size_t i = 0; i < a.count; ++i)
      for (std::size_t k = 0; k < components; ++k) out[i * components + k] = load<C>(elements[i] + k * sizeof(C));
  });
  return values;
}

template std::vector<float> unpack(Document&, int);
template std::vector<Vec2f> unpack(Document&, int);
template std::vector<Vec3f> unpack(Document&, int);
template std::vector<Vec4f> unpack(Document&, int);
template std::vector<glm::mat4> unpack(Document&, int);
template std::vector<std::uint32_t> unpack_unsigned(Document&, int);
template std::vector<Joints> unpack_unsigned(Document&, int);

}  // namespace lippmann::gltf
