// Based on: Khronos Group, "glTF 2.0 Specification", 2021, sections 3.6.2 "Accessors" and 3.11 "Animations" (the formulas
// for normalised integers: f = c / max for unsigned, f = max(c / max, -1) for signed ones).
#include "scene/gltf/accessor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

namespace lippmann::gltf {
namespace {

// ---- Layout ---------------------------------------------------------------------------------------------------------

/// 0 for a type that glTF does not have.
std::size_t component_bytes(int type) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return 1;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return 2;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return 4;
    default:
      return 0;
  }
}

bool is_unsigned(int type) {
  return type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE || type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
         type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
}

std::size_t components_of(int type) {
  return static_cast<std::size_t>(tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(type)));
}

/// Columns of matrices begin at multiples of four bytes.
std::size_t element_bytes(const tinygltf::Accessor& a) {
  const std::size_t component = component_bytes(a.componentType);
  const std::size_t rows = a.type == TINYGLTF_TYPE_MAT2   ? 2
                           : a.type == TINYGLTF_TYPE_MAT3 ? 3
                           : a.type == TINYGLTF_TYPE_MAT4 ? 4
                                                          : 0;
  return rows ? rows * ((rows * component + 3) / 4 * 4) : components_of(a.type) * component;
}

/// Where the elements of an accessor lie in its buffer view.
struct Elements {
  Bytes bytes;  ///< from the first element on
  std::size_t stride = 0;
  std::size_t count = 0;
  const std::byte* operator[](std::size_t i) const { return bytes.data() + i * stride; }
};

Bytes view_bytes(const Document& document, int index) {
  const tinygltf::BufferView& view = document.model.bufferViews[static_cast<std::size_t>(index)];
  return document.buffers[static_cast<std::size_t>(view.buffer)].subspan(view.byteOffset, view.byteLength);
}

/// Checks, without overflow, that `count` elements fit: offset + (count - 1) stride + size <= bytes.
Elements locate(const Document& document, int view_index, std::size_t offset, std::size_t size, std::size_t count,
                const std::string& where) {
  const tinygltf::BufferView& view = document.model.bufferViews[static_cast<std::size_t>(view_index)];
  const std::size_t stride = view.byteStride ? view.byteStride : size;
  const bool fits =
      offset <= view.byteLength && size <= view.byteLength - offset && count - 1 <= (view.byteLength - offset - size) / stride;
  if (stride < size) document.report.fail(where, fmt::format("elements of {} bytes stand {} bytes apart", size, stride));
  if (!fits)
    document.report.fail(
        where, fmt::format("{} elements of {} bytes from byte {} on lie outside bufferViews[{}], which has {} bytes", count,
                           size, offset, view_index, view.byteLength));
  return {view_bytes(document, view_index).subspan(offset), stride, count};
}

Elements dense_elements(const Document& document, const tinygltf::Accessor& a, const std::string& where) {
  return locate(document, a.bufferView, a.byteOffset, element_bytes(a), a.count, where);
}

struct SparseElements {
  Elements indices, values;
};

SparseElements sparse_elements(const Document& document, const tinygltf::Accessor& a, const std::string& where) {
  const auto& s = a.sparse;
  const int type = s.indices.componentType;
  if (!is_unsigned(type)) document.report.fail(where + ".sparse.indices", "the component type is not an unsigned integer");
  const std::size_t count = static_cast<std::size_t>(s.count);
  if (count > a.count) document.report.fail(where + ".sparse", fmt::format("replaces {} of {} elements", count, a.count));
  return {locate(document, s.indices.bufferView, static_cast<std::size_t>(s.indices.byteOffset), component_bytes(type), count,
                 where + ".sparse.indices"),
          locate(document, s.values.bufferView, static_cast<std::size_t>(s.values.byteOffset), element_bytes(a), count,
                 where + ".sparse.values")};
}

// ---- Conversion -----------------------------------------------------------------------------------------------------

template <class C>
C load(const std::byte* at) {
  C value;
  std::memcpy(&value, at, sizeof value);
  return value;
}

/// Calls use(C{}) with the C++ type of an unsigned component type.
template <class F>
void with_unsigned(int type, const F& use) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return use(std::uint8_t{});
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return use(std::uint16_t{});
    default:
      return use(std::uint32_t{});
  }
}

/// The same for any component type that has passed check_accessors().
template <class F>
void with_component(int type, const F& use) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return use(std::int8_t{});
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return use(std::int16_t{});
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return use(float{});
    default:
      return with_unsigned(type, use);
  }
}

/// All numbers that are unpacked have four bytes.
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

std::uint32_t sparse_index(const tinygltf::Accessor& a, const SparseElements& sparse, std::size_t i) {
  std::uint32_t index = 0;
  with_unsigned(a.sparse.indices.componentType, [&](auto c) { index = load<decltype(c)>(sparse.indices[i]); });
  return index;
}

void fill(const Document& document, const tinygltf::Accessor& a, const std::string& where, Target target) {
  const auto convert = [&](const std::byte* from, float* to) {
    with_component(a.componentType, [&](auto c) {
      using C = decltype(c);
      for (std::size_t k = 0; k < target.components; ++k) to[k] = to_float(load<C>(from + k * sizeof(C)), a.normalized);
    });
  };
  if (a.bufferView >= 0) {
    const Elements elements = dense_elements(document, a, where);
    for (std::size_t i = 0; i < a.count; ++i) convert(elements[i], target[i]);
  }
  if (!a.sparse.isSparse) return;
  const SparseElements sparse = sparse_elements(document, a, where);
  for (std::size_t i = 0; i < sparse.indices.count; ++i) {
    const std::uint32_t index = sparse_index(a, sparse, i);
    if (index >= a.count)
      document.report.fail(where + ".sparse.indices", fmt::format("replaces element {} of {}", index, a.count));
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

const tinygltf::Accessor& accessor_of_type(const Document& document, int index, std::size_t components) {
  const tinygltf::Accessor& a = document.model.accessors[static_cast<std::size_t>(index)];
  const bool square = a.type == TINYGLTF_TYPE_MAT2;  // four components, but not a VEC4
  if (components_of(a.type) != components || square)
    document.report.fail(element("accessors", static_cast<std::size_t>(index)), "has the wrong type for its use",
                         std::string(type_name(components)));
  return a;
}

}  // namespace

void check_views(const Document& document) {
  const tinygltf::Model& model = document.model;
  for (std::size_t i = 0; i < model.bufferViews.size(); ++i) {
    const tinygltf::BufferView& view = model.bufferViews[i];
    const std::size_t available = document.buffers[static_cast<std::size_t>(view.buffer)].size();
    if (view.byteOffset > available || view.byteLength > available - view.byteOffset)
      document.report.fail(element("bufferViews", i),
                           fmt::format("{} bytes from byte {} on lie outside buffers[{}], which has {} bytes", view.byteLength,
                                       view.byteOffset, view.buffer, available));
  }
}

void check_accessors(const Document& document) {
  const tinygltf::Model& model = document.model;
  for (std::size_t i = 0; i < model.accessors.size(); ++i) {
    const tinygltf::Accessor& a = model.accessors[i];
    const std::string where = element("accessors", i);
    if (!component_bytes(a.componentType))
      document.report.fail(where, fmt::format("has the component type {}", a.componentType),
                           "5120, 5121, 5122, 5123, 5125, 5126");
    if (a.bufferView >= 0) dense_elements(document, a, where);
    if (a.sparse.isSparse) sparse_elements(document, a, where);
  }
}

template <class T>
std::vector<T> unpack(Document& document, int index) {
  constexpr std::size_t components = kComponents<T>;
  const std::string where = element("accessors", static_cast<std::size_t>(index));
  const tinygltf::Accessor& a = accessor_of_type(document, index, components);
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
  const tinygltf::Accessor& a = accessor_of_type(document, index, components);
  if (!is_unsigned(a.componentType) || a.bufferView < 0 || a.sparse.isSparse)
    document.report.fail(where, "does not hold plain unsigned integers", "component type 5121, 5123 or 5125, not sparse");
  document.unpacked.spend(a.count, sizeof(T), where, document.report);
  std::vector<T> values(a.count);
  std::uint32_t* out = reinterpret_cast<std::uint32_t*>(values.data());
  const Elements elements = dense_elements(document, a, where);
  with_unsigned(a.componentType, [&](auto c) {
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
