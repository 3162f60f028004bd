// Builds small glTF documents. Tests may edit the JSON freely; the builder keeps the binary data.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "lippmann/core/math.hpp"
#include "scene/gltf.hpp"

namespace lippmann::test {

using Json = nlohmann::json;
using Contents = std::vector<std::byte>;

constexpr int kUnsignedByte = 5121, kUnsignedShort = 5123, kUnsignedInt = 5125, kFloat = 5126;

class GltfBuilder {
 public:
  Json root = {{"asset", {{"version", "2.0"}}}};
  Contents binary;

  int add(const char* array, Json value) {
    root[array].push_back(std::move(value));
    return static_cast<int>(root[array].size()) - 1;
  }

  template <class T>
  int add_view(const std::vector<T>& values) {
    binary.resize((binary.size() + 3) / 4 * 4);
    const std::size_t offset = binary.size(), bytes = values.size() * sizeof(T);
    binary.resize(offset + bytes);
    std::memcpy(binary.data() + offset, values.data(), bytes);
    return add("bufferViews", {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", bytes}});
  }

  template <class T>
  int add_accessor(const std::vector<T>& values, int component_type, const char* type, std::size_t count) {
    const int view = add_view(values);
    return add("accessors", {{"bufferView", view}, {"componentType", component_type}, {"type", type}, {"count", count}});
  }
  int add_accessor(const std::vector<float>& v) { return add_accessor(v, kFloat, "SCALAR", v.size()); }
  int add_accessor(const std::vector<Vec2f>& v) { return add_accessor(v, kFloat, "VEC2", v.size()); }
  int add_accessor(const std::vector<Vec3f>& v) { return add_accessor(v, kFloat, "VEC3", v.size()); }
  int add_accessor(const std::vector<Vec4f>& v) { return add_accessor(v, kFloat, "VEC4", v.size()); }
  int add_accessor(const std::vector<std::uint16_t>& v) { return add_accessor(v, kUnsignedShort, "SCALAR", v.size()); }

  Json& accessor(int index) { return root["accessors"][static_cast<std::size_t>(index)]; }

  int add_mesh(Json primitive) { return add("meshes", {{"primitives", {std::move(primitive)}}}); }

  /// Adds a mesh of the triangle (0, 0, 0), (1, 0, 0), (0, 1, 0) and returns its index. `more` is merged into the
  /// primitive.
  int add_triangle(const Json& more = Json::object()) {
    Json primitive = {{"attributes", {{"POSITION", add_accessor(std::vector<Vec3f>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}})}}}};
    primitive.update(more, true);
    return add_mesh(std::move(primitive));
  }

  int add_node(Json node) { return add("nodes", std::move(node)); }

  Json document() const {
    Json result = root;
    if (!binary.empty()) result["buffers"] = {{{"byteLength", binary.size()}}};
    return result;
  }

  Contents glb() const { return glb(document().dump(), binary); }

  static Contents glb(std::string json, Contents payload) {
    json.resize((json.size() + 3) / 4 * 4, ' ');
    payload.resize((payload.size() + 3) / 4 * 4);
    const std::size_t total = 20 + json.size() + (payload.empty() ? 0 : 8 + payload.size());
    Contents result;
    append_words(result, {0x46546c67, 2, static_cast<std::uint32_t>(total)});
    append_words(result, {static_cast<std::uint32_t>(json.size()), 0x4e4f534a});
    for (const char c : json) result.push_back(static_cast<std::byte>(c));
    if (payload.empty()) return result;
    append_words(result, {static_cast<std::uint32_t>(payload.size()), 0x004e4942});
    result.insert(result.end(), payload.begin(), payload.end());
    return result;
  }

 private:
  static void append_words(Contents& to, std::initializer_list<std::uint32_t> words) {
    for (const std::uint32_t word : words)
      for (int shift = 0; shift < 32; shift += 8) to.push_back(static_cast<std::byte>(word >> shift));
  }
};

inline std::vector<std::uint8_t> white_png() {
  return {0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48, 0x44, 0x52, 0x00,
          0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x01, 0x08, 0x00, 0x00, 0x00, 0x00, 0x3a, 0x7e, 0x9b, 0x55, 0x00,
          0x00, 0x00, 0x0a, 0x49, 0x44, 0x41, 0x54, 0x78, 0xda, 0x63, 0xf8, 0x0f, 0x00, 0x01, 0x01, 0x01, 0x00,
          0x1c, 0xb0, 0x8c, 0x99, 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};
}

inline Contents contents_of(const std::string& text) {
  Contents contents(text.size());
  std::memcpy(contents.data(), text.data(), text.size());
  return contents;
}

inline LoadOptions at_25_frames_a_second() { return {.frames_per_second = 25.0}; }

inline Scene parse(const Contents& contents, std::vector<std::string>* warnings = nullptr, const GltfLimits& limits = {},
                   const LoadOptions& options = at_25_frames_a_second()) {
  Context context;
  if (warnings) context.warn = [warnings](std::string_view text) { warnings->emplace_back(text); };
  return parse_gltf(contents, "a.glb", options, context, limits);
}
inline Scene parse(const GltfBuilder& builder, std::vector<std::string>* warnings = nullptr, const GltfLimits& limits = {},
                   const LoadOptions& options = at_25_frames_a_second()) {
  return parse(builder.glb(), warnings, limits, options);
}

inline Mesh parse_mesh(const GltfBuilder& builder, std::vector<std::string>* warnings = nullptr) {
  GltfBuilder with_node = builder;
  with_node.add_node({{"mesh", 0}});
  return std::get<Mesh>(parse(with_node, warnings).shapes.at(0));
}

}  // namespace lippmann::test
