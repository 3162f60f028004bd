// Based on: T. Blut, L. Kettner, P. Arden, "EXT_lights_ies": points with the intensities of a photometric file, which shine
// along their node's -z.
#include "scene/gltf/ies_light.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "scene/gltf/resource.hpp"
#include "scene/ies.hpp"

namespace lippmann::gltf {
namespace {

constexpr const char* kExtension = "EXT_lights_ies";

/// The light that every node with a profile has, but for its own colour and multiplier.
class ProfileReader {
 public:
  ProfileReader(Document& document, Scene& scene) : document_(document), scene_(scene) {}

  /// None: its file is missing.
  std::optional<Light> light(int profile) {
    const auto [known, is_new] = known_.try_emplace(profile);
    if (is_new) known->second = read(profile);
    return known->second;
  }

 private:
  std::optional<Light> read(int profile) {
    const tinygltf::Value& from = profile_at(profile);
    const std::string where = std::string(kExtension) + "." + element("lights", static_cast<std::size_t>(profile));
    const std::optional<std::string> text = text_of(from, where);
    if (!text) return std::nullopt;
    IesProfile ies = parse_ies(document_.report.where(where), *text);
    ies.left_out.warn(document_.report.context(), "entry", "entries");
    Light light;
    if (from.Has("name")) light.name = ies.web.name = from.Get("name").Get<std::string>();
    light.inverse_square = true;
    light.color = Vec3f(ies.mean_candela);
    light.web = static_cast<int>(scene_.webs.size());
    scene_.webs.push_back(std::move(ies.web));
    return light;
  }

  /// tinygltf leaves out what is empty, lists of it too.
  const tinygltf::Value& profile_at(int profile) const {
    static const tinygltf::Value kNone;
    const tinygltf::Value& extension = document_.model.extensions.at(kExtension);
    const tinygltf::Value& all = extension.Has("lights") ? extension.Get("lights") : kNone;
    return all.IsArray() ? all.Get(profile) : kNone;
  }

  std::optional<std::string> text_of(const tinygltf::Value& from, const std::string& where) {
    const auto text = [](const std::byte* begin, std::size_t size) {
      return std::string(reinterpret_cast<const char*>(begin), size);
    };
    if (from.Has("bufferView")) {
      const auto index = static_cast<std::size_t>(from.Get("bufferView").GetNumberAsInt());
      const tinygltf::BufferView& view = document_.model.bufferViews[index];
      return text(document_.buffers[static_cast<std::size_t>(view.buffer)].data() + view.byteOffset, view.byteLength);
    }
    if (!from.Has("uri")) document_.report.fail(where, "has neither a uri nor a buffer view");
    const std::string& uri = from.Get("uri").Get<std::string>();
    const std::string problem = uri_problem(uri, document_.folders, document_.report.where(where));
    if (!problem.empty()) {
      document_.report.warn_at("lamps whose light profile cannot be read are left out: " + problem, where);
      return std::nullopt;
    }
    const std::vector<std::byte> bytes = fetch(uri, document_.folders, document_.limits.file_bytes, where, document_.report);
    return text(bytes.data(), bytes.size());
  }

  Document& document_;
  Scene& scene_;
  std::map<int, std::optional<Light>> known_;
};

Vec3f tint_of(const tinygltf::Value& from) {
  Vec3f tint(1.0f);
  if (from.Has("color"))
    for (int c = 0; c < 3; ++c) tint[c] = std::min(static_cast<float>(from.Get("color").Get(c).GetNumberAsDouble()), 1.0f);
  return from.Has("multiplier") ? static_cast<float>(from.Get("multiplier").GetNumberAsDouble()) * tint : tint;
}

}  // namespace

void read_ies_lights(Document& document, const NodeMap& nodes, Scene& scene) {
  ProfileReader profiles(document, scene);
  for (std::size_t i = 0; i < nodes.file_node.size(); ++i) {
    const tinygltf::Node& node = document.model.nodes[static_cast<std::size_t>(nodes.file_node[i])];
    const auto extension = node.extensions.find(kExtension);
    if (extension == node.extensions.end() || nodes.hidden[i]) continue;
    std::optional<Light> light = profiles.light(extension->second.Get("light").GetNumberAsInt());
    if (!light) continue;
    light->node = static_cast<int>(i);
    light->color *= tint_of(extension->second);
    if (light->name.empty()) light->name = node.name;
    scene.lights.push_back(std::move(*light));
  }
}

}  // namespace lippmann::gltf
