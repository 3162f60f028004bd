#include <algorithm>
#include <array>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>

#include "core/regular_file.hpp"
#include "lippmann/core/error.hpp"
#include "scene/gltf.hpp"
#include "scene/gltf/json.hpp"
#include "scene/gltf/splats.hpp"

namespace lippmann {
namespace {

using Json = nlohmann::json;

constexpr std::string_view kSplatExtension = "KHR_gaussian_splatting";

/// Returns the JSON of a file: the first chunk of a .glb, or the whole file. If the file is truncated, returns the existing
/// part.
std::string leading_json(const std::filesystem::path& path, std::uint64_t limit) {
  RegularFile file(path);
  std::array<char, 20> start{};
  const std::size_t begun = file.read(start.data(), start.size());
  const bool binary = begun == start.size() && std::string_view(start.data(), 4) == "glTF";
  std::uint32_t chunk = 0;
  std::memcpy(&chunk, start.data() + 12, sizeof chunk);
  const std::uint64_t wanted = binary ? std::min<std::uint64_t>(chunk, file.size() - start.size()) : file.size();
  if (wanted > limit) return {};
  std::string text(start.data(), binary ? 0 : begun);
  const std::size_t kept = text.size();
  text.resize(static_cast<std::size_t>(wanted));
  text.resize(kept + file.read(text.data() + kept, text.size() - kept));
  return text;
}

const Json& array_of(const Json& object, const char* name) {
  static const Json kNone = Json::array();
  const auto found = object.is_object() ? object.find(name) : object.end();
  return found != object.end() && found->is_array() ? *found : kNone;
}

bool is_splat_primitive(const Json& primitive) {
  return primitive.is_object() && primitive.contains("extensions") && primitive["extensions"].is_object() &&
         primitive["extensions"].contains(kSplatExtension);
}

}  // namespace

bool gltf::is_of_splats_alone(const Json& document) {
  bool any = false;
  for (const Json& mesh : array_of(document, "meshes"))
    for (const Json& primitive : array_of(mesh, "primitives")) {
      if (!is_splat_primitive(primitive)) return false;
      any = true;
    }
  return any;
}

bool is_gltf_splat_file(const std::filesystem::path& path) {
  const GltfLimits limits;
  const std::string text = leading_json(path, limits.file_bytes);
  if (text.find(kSplatExtension) == std::string::npos) return false;
  try {
    const Context quiet;
    return gltf::is_of_splats_alone(gltf::parse_json(text, limits, gltf::Report(path.string(), quiet)));
  } catch (const Error&) {
    return false;
  }
}

}  // namespace lippmann
