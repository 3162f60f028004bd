// Based on: T. Blut, L. Kettner, P. Arden, "EXT_lights_ies". The zero direction of the photometric file is the node's -z.
#include "scene/gltf/ies_light.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "scene/gltf/resource.hpp"
#include "scene/ies.hpp"

namespace lippmann::gltf {
namespace {

constexpr const char* kExtension = "EXT_lights_ies";

class ProfileReader {
 public:
  ProfileReader(Document& document, Scene& scene) : document_(document), scene_(scene) {}

  std::optional<Light> light(int profile) {
    const auto [known, is_new] = known_.try_emplace(profile);
    if (is_new) known->second = read(profile);
    return known->second;
  }

 private:
  std::optional<Light> read(int profile) {
    const Value from = document_.root.extension(kExtension)["lights"].at(static_cast<std::size_t>(profile));
    const std::string where = std::string(kExtension) + "." + element("lights", static_cast<std::size_t>(profile));
    const std::optional<std::string> text = text_of(from, where);
    if (!text) return std::nullopt;
    IesProfile ies = parse_ies(document_.report.where(where), *text);
    ies.left_out.warn(document_.report.context(), "entry", "entries");
    Light light;
    if (const Value name = from["name"]) light.name = ies.web.name = name.text();
    light.inverse_square = true;
    light.color = Vec3f(ies.mean_candela);
    light.web = static_cast<int>(scene_.webs.size());
    scene_.webs.push_back(std::move(ies.web));
    return light;
  }

  std::optional<std::string> text_of(Value from, const std::string& where) {
    const auto text = [](Bytes bytes) { return std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()); };
    if (const Value view = from["bufferView"]) return text(document_.view(view.index()));
    if (!from["uri"]) document_.report.fail(where, "has neither a uri nor a buffer view");
    const std::string& uri = from["uri"].text();
    const std::string problem = uri_problem(uri, document_.folders, document_.report.where(where));
    if (!problem.empty()) {
      document_.report.warn_at("lamps whose light profile cannot be read are left out: " + problem, where);
      return std::nullopt;
    }
    return text(fetch(uri, document_.folders, document_.limits.file_bytes, where, document_.report));
  }

  Document& document_;
  Scene& scene_;
  std::map<int, std::optional<Light>> known_;
};

Vec3f tint_of(Value from) {
  const Vec3f color = glm::min(from["color"].vector(Vec3f(1.0f)), Vec3f(1.0f));
  return static_cast<float>(from["multiplier"].number(1.0)) * color;
}

}  // namespace

void read_ies_lights(Document& document, const NodeMap& nodes, Scene& scene) {
  ProfileReader profiles(document, scene);
  for (std::size_t i = 0; i < nodes.file_node.size(); ++i) {
    const Value node = document.at("nodes", nodes.file_node[i]), extension = node.extension(kExtension);
    if (!extension || nodes.hidden[i]) continue;
    std::optional<Light> light = profiles.light(extension["light"].index());
    if (!light) continue;
    light->node = static_cast<int>(i);
    light->color *= tint_of(extension);
    if (light->name.empty()) light->name = node["name"].text();
    scene.lights.push_back(std::move(*light));
  }
}

}  // namespace lippmann::gltf
