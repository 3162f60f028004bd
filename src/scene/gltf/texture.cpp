#include "scene/gltf/texture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/texture_image.hpp"

namespace lippmann::gltf {
namespace {

constexpr int kNearest = 9728;

Wrap wrap_mode(Value mode, const std::string& where, const Report& report) {
  switch (const int code = mode.integer(10497)) {
    case 10497:
      return Wrap::kRepeat;
    case 33648:
      return Wrap::kMirror;
    case 33071:
      return Wrap::kClamp;
    default:
      report.fail(where, fmt::format("has the wrap mode {}", code), "10497 (repeat), 33071 (clamp), 33648 (mirror)");
  }
}

/// Returns the image index of a texture; -1: none. A WebP image takes precedence, because the other image is then only a
/// replacement for readers without WebP.
int image_of(Value texture) {
  const Value webp = texture.extension("EXT_texture_webp");
  return (webp ? webp : texture)["source"].index();
}

void make_roughness(float glossiness, Texture& texture) {
  for (std::size_t i = 0; i < texture.rgba.size(); i += 4) {
    const float rough = 255.0f - glossiness * static_cast<float>(texture.rgba[i + 3]);
    texture.rgba[i + 1] = static_cast<std::uint8_t>(std::lround(rough));
    texture.rgba[i + 3] = 255;
  }
}

}  // namespace

int TextureReader::read(int index, bool srgb) {
  const Value texture = document_.at("textures", index);
  const std::string where = element("textures", static_cast<std::size_t>(index));
  const int source = image_of(texture);
  if (source < 0) {
    document_.report.warn_at("textures without a PNG, JPEG or WebP image are white", where);
    return -1;
  }
  if (const std::string& problem = problem_of(source); !problem.empty()) {
    document_.report.warn_at(problem + "; the surface is shown without it",
                             element("images", static_cast<std::size_t>(source)));
    return -1;
  }
  const Value sampler = texture["sampler"] ? document_.at("samplers", texture["sampler"].index()) : Value();
  const std::string sampler_where = element("samplers", texture["sampler"].count());
  if (sampler["magFilter"].integer(0) == kNearest)
    document_.report.not_supported("nearest-neighbour filtering is", "textures are filtered linearly", sampler_where);
  const Wrap wrap_u = wrap_mode(sampler["wrapS"], sampler_where, document_.report);
  const Wrap wrap_v = wrap_mode(sampler["wrapT"], sampler_where, document_.report);

  const auto [known, is_new] = known_.try_emplace({source, wrap_u, wrap_v, srgb}, static_cast<int>(scene_.textures.size()));
  if (!is_new) return known->second;
  Texture result;
  const std::size_t image = static_cast<std::size_t>(source);
  const std::string& name = document_.at("images", source)["name"].text();
  result.name = !name.empty() ? name : texture["name"].text();
  result.wrap_u = wrap_u, result.wrap_v = wrap_v;
  result.srgb = srgb;
  const auto picture = [this, image](std::vector<std::byte>& storage) { return image_bytes(document_, image, storage); };
  return pending_.add(std::move(result), document_.report.where(element("images", image)), picture, scene_.textures);
}

int TextureReader::read_roughness(int index, float glossiness) {
  const int from = read(index, false);
  if (from < 0) return -1;
  const auto [known, is_new] = roughness_.try_emplace({from, glossiness}, static_cast<int>(scene_.textures.size()));
  if (!is_new) return known->second;
  return pending_.add_changed(
      from, [glossiness](Texture& t) { make_roughness(glossiness, t); }, scene_.textures);
}

void TextureReader::decode() {
  pending_.decode(scene_.textures, document_.report.context(),
                  [this](const std::string& text) { document_.report.warn(text); });
}

const std::string& TextureReader::problem_of(int image) {
  const auto [known, is_new] = problems_.try_emplace(image);
  if (!is_new) return known->second;
  const auto index = static_cast<std::size_t>(image);
  known->second = image_problem(document_, index);
  if (!known->second.empty()) return known->second;
  std::vector<std::byte> storage;
  const std::string problem = texture_image_problem(image_bytes(document_, index, storage));
  if (!problem.empty()) known->second = "an image " + problem;
  return known->second;
}

}  // namespace lippmann::gltf
