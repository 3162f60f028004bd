// Based on: Khronos Group, "EXT_lights_image_based", 2019. The extension stores the radiance around a scene as a cube map with
// a rotation and an intensity. Each level of the cube map has six images in the order +x, -x, +y, -y, +z, -z. Images with four
// channels are RGBD: colours are divided by alpha.
//
// We use only the first level, which is not blurred. The other levels are not needed, because path tracing computes the blur.
//
// The specification leaves two questions open:
// - Colour encoding: we assume sRGB, as in the extension's JPEG images and in the RGBD of Babylon.js, whose authors wrote the
//   extension.
// - "Flipped about its vertical axis": we assume that each image shows its face as seen from inside the cube.
#include "scene/gltf/image_light.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "lippmann/core/parallel.hpp"
#include "lippmann/image/encode.hpp"
#include "scene/gltf/nodes.hpp"
#include "scene/texture_image.hpp"

namespace lippmann::gltf {
namespace {

constexpr const char* kImageBased = "EXT_lights_image_based";

/// `ahead` points from the cube's centre to the middle of a face. `up` points from there to the upper edge of the face's image.
struct FaceAxes {
  Vec3f ahead, up;
};
constexpr std::size_t kFaces = 6;
const std::array<FaceAxes, kFaces> kAxes{{{{1, 0, 0}, {0, 1, 0}},
                                          {{-1, 0, 0}, {0, 1, 0}},
                                          {{0, 1, 0}, {0, 0, -1}},
                                          {{0, -1, 0}, {0, 0, 1}},
                                          {{0, 0, 1}, {0, 1, 0}},
                                          {{0, 0, -1}, {0, 1, 0}}}};

using CubeMap = std::array<Image, kFaces>;

std::array<float, 256> linear_codes() {
  std::array<float, 256> values{};
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = static_cast<float>(linear_from_srgb(static_cast<double>(i) / 255.0));
  return values;
}

/// Returns a face as linear light. RGBD cannot represent an alpha of 0, so 0 is replaced by 1/255.
Image linear_light(const Texture& picture) {
  const std::array<float, 256> linear = linear_codes();
  Image light(picture.width, picture.height, 3);
  for (std::size_t i = 0; i < light.data.size(); ++i) {
    const std::uint8_t* rgba = picture.rgba.data() + i / 3 * 4;
    const float divisor = static_cast<float>(std::max<std::uint8_t>(rgba[3], 1)) / 255.0f;
    light.data[i] = linear[rgba[i % 3]] / divisor;
  }
  return light;
}

/// Returns the bilinearly interpolated value of a face. x and y are in [0, 1] and start at the upper left corner.
Vec3f look_up(const Image& face, float x, float y) {
  const float last = static_cast<float>(face.width - 1);
  const float px = std::clamp(x * static_cast<float>(face.width) - 0.5f, 0.0f, last);
  const float py = std::clamp(y * static_cast<float>(face.height) - 0.5f, 0.0f, last);
  const int x0 = static_cast<int>(px), y0 = static_cast<int>(py);
  const int x1 = std::min(x0 + 1, face.width - 1), y1 = std::min(y0 + 1, face.height - 1);
  const auto texel = [&](int column, int row) {
    const float* c = face.pixel(column, row);
    return Vec3f(c[0], c[1], c[2]);
  };
  const float right = px - static_cast<float>(x0), below = py - static_cast<float>(y0);
  return glm::mix(glm::mix(texel(x0, y0), texel(x1, y0), right), glm::mix(texel(x0, y1), texel(x1, y1), right), below);
}

Vec3f look_up(const CubeMap& cube, Vec3f d) {
  const Vec3f size = glm::abs(d);
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const std::size_t face = static_cast<std::size_t>(2 * axis + (d[axis] < 0.0f ? 1 : 0));
  const FaceAxes& axes = kAxes[face];
  const float across = glm::dot(d, glm::cross(axes.ahead, axes.up)) / size[axis], upwards = glm::dot(d, axes.up) / size[axis];
  return look_up(cube[face], 0.5f + 0.5f * across, 0.5f - 0.5f * upwards);
}

Vec3f direction_at(float x, float y) {
  const float azimuth = (x - 0.5f) * 2.0f * kPi, polar = y * kPi;
  return {std::sin(polar) * std::cos(azimuth), std::cos(polar), std::sin(polar) * std::sin(azimuth)};
}

/// Returns the width of a panorama with about the resolution of cube faces of width `face`.
int width_of_panorama(int face) {
  constexpr int kNarrowest = 64, kWidest = 4096;
  return std::clamp(4 * face, kNarrowest, kWidest);
}

void fill_row(const CubeMap& cube, const Quatf& cube_from_world, int y, Image& panorama) {
  const int steps = std::max(2, (4 * cube[0].width + panorama.width - 1) / panorama.width);
  const auto place = [steps](int texel, int step, int count) {
    return (static_cast<float>(texel) + (static_cast<float>(step) + 0.5f) / static_cast<float>(steps)) /
           static_cast<float>(count);
  };
  for (int x = 0; x < panorama.width; ++x) {
    Vec3f sum(0.0f);
    for (int i = 0; i < steps * steps; ++i) {
      const Vec3f d = direction_at(place(x, i % steps, panorama.width), place(y, i / steps, panorama.height));
      sum += look_up(cube, cube_from_world * d);
    }
    for (int c = 0; c < 3; ++c) panorama.pixel(x, y)[c] = sum[c] / static_cast<float>(steps * steps);
  }
}

Image panorama_of(const CubeMap& cube, const Quatf& cube_from_world, const Context& context) {
  const int width = width_of_panorama(cube[0].width);
  Image panorama(width, width / 2, 3);
  const ThreadPool pool(resolved_threads(context));
  pool.for_each(static_cast<std::size_t>(panorama.height),
                [&](std::size_t y) { fill_row(cube, cube_from_world, static_cast<int>(y), panorama); });
  return panorama;
}

class ImageLightReader {
 public:
  ImageLightReader(Document& document, std::size_t light)
      : document_(document),
        where_(fmt::format("{}.{}", kImageBased, element("lights", light))),
        light_(document.root.extension(kImageBased)["lights"].at(light)) {}

  std::optional<EnvironmentMap> read() {
    const std::optional<CubeMap> cube = read_cube();
    if (!cube) return std::nullopt;
    EnvironmentMap map;
    map.radiance = panorama_of(*cube, glm::conjugate(rotation()), document_.report.context());
    map.strength = static_cast<float>(light_["intensity"].number(1.0));
    return map;
  }

 private:
  Quatf rotation() const {
    if (!light_["rotation"]) return {1.0f, 0.0f, 0.0f, 0.0f};
    const Vec4f q = light_["rotation"].vector(Vec4f(0.0f));
    const Quatf rotation(q.w, q.x, q.y, q.z);
    const float length = glm::length(rotation);
    if (!(length > 1e-6f)) document_.report.fail(where_ + ".rotation", "is not a unit quaternion");
    return rotation / length;
  }

  std::optional<CubeMap> read_cube() {
    const Value levels = light_["specularImages"];
    if (levels.size() == 0) document_.report.fail(where_ + ".specularImages", "is empty", "the six faces of a cube");
    std::array<std::size_t, kFaces> images{};
    for (std::size_t i = 0; i < kFaces; ++i) {
      images[i] = levels.at(0).at(i).count();
      if (!has_room(images[i])) return std::nullopt;
    }
    CubeMap cube;
    for (std::size_t i = 0; i < kFaces; ++i) {
      const std::size_t image = images[i];
      cube[i] = decode(image);
      if (cube[i].width != cube[0].width)
        document_.report.fail(element("images", image),
                              fmt::format("is {} pixels wide in a cube map of {} pixels", cube[i].width, cube[0].width));
    }
    return cube;
  }

  /// Subtracts the decoded size of an image from the memory budget. Returns whether the image can be read.
  bool has_room(std::size_t image) {
    std::vector<std::byte> storage;
    std::string problem = image_problem(document_, image);
    const Bytes bytes = problem.empty() ? image_bytes(document_, image, storage) : Bytes{};
    if (problem.empty() && !(problem = texture_image_problem(bytes)).empty()) problem = "an image " + problem;
    if (!problem.empty()) {
      document_.report.warn_at("environment lights whose images cannot be read are left out: " + problem,
                               element("images", image));
      return false;
    }
    const std::string where = element("images", image);
    const Vec2i size = texture_size(bytes, document_.report.where(where));
    if (size.x != size.y || size.x > document_.limits.texture_side)
      document_.report.fail(where, fmt::format("has {} x {} pixels", size.x, size.y),
                            fmt::format("square faces of 1 to {} pixels", document_.limits.texture_side));
    const auto pixels = static_cast<std::uint64_t>(size.x) * static_cast<std::uint64_t>(size.y);
    document_.unpacked.spend(pixels, 4 + 3 * sizeof(float), where, document_.report);
    return true;
  }

  Image decode(std::size_t image) {
    std::vector<std::byte> storage;
    Texture picture;
    decode_texture(image_bytes(document_, image, storage), document_.report.where(element("images", image)), picture);
    return linear_light(picture);
  }

  Document& document_;
  std::string where_;
  Value light_;
};

}  // namespace

void read_image_light(Document& document, Scene& scene) {
  if (document.root["scenes"].size() == 0) return;
  if (const Value extension = document.root["scenes"].at(chosen_scene(document)).extension(kImageBased))
    scene.background.map = ImageLightReader(document, extension["light"].count()).read();
}

}  // namespace lippmann::gltf
