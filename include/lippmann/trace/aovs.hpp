// Further layers of a frame: what the first hit behind every pixel's centre is, and parts of its light.
//
// Surfaces that are not there do not count as hit: what alpha masks cut away, and what blended surfaces cover to less than a
// half. Everything else is as solid for these layers as stone, glass too.
#pragma once

#include <array>
#include <cstdint>
#include <iterator>
#include <limits>

#include "lippmann/image/image.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

enum class Aov : std::uint8_t {
  kDepth,     ///< z in display mm (> 0 in front of the array)
  kNormal,    ///< unit, world space, towards the ray
  kId,        ///< index in Scene::instances
  kPosition,  ///< world space
  kRayDepth,  ///< mm along the ray from where it starts (resolved_z_front_mm): from the eye
  kAlbedo,    ///< base colour, textures and vertex colours included
  kMotion,    ///< see place_in_view; pixels to the right and down since the frame before
  kDirect,    ///< of paths: what shines by itself and light that one surface has scattered
  kIndirect,  ///< of paths: all other light; with kDirect the film, but for rounding
  kAlpha,     ///< share of the pixel's samples that hit something, what alpha covers by its share; of the surroundings, that
              ///< the others would see, the film is then free
};

struct AovInfo {
  int channels;
  float nothing;          ///< where nothing was hit
  bool is_light = false;  ///< a mean over all samples, made with the light: no property of what is behind the pixel's centre
};
/// By Aov.
inline constexpr AovInfo kAovInfos[] = {
    {1, -std::numeric_limits<float>::infinity()},  // kDepth
    {3, 0.0f},                                     // kNormal
    {1, -1.0f},                                    // kId
    {3, 0.0f},                                     // kPosition
    {1, std::numeric_limits<float>::infinity()},   // kRayDepth
    {3, 0.0f},                                     // kAlbedo
    {2, 0.0f},                                     // kMotion
    {3, 0.0f, true},                               // kDirect
    {3, 0.0f, true},                               // kIndirect
    {1, 0.0f, true},                               // kAlpha
};
inline constexpr std::size_t kAovs = std::size(kAovInfos);
static_assert(kAovs == static_cast<std::size_t>(Aov::kAlpha) + 1);

constexpr const AovInfo& info_of(Aov aov) { return kAovInfos[static_cast<std::size_t>(aov)]; }
constexpr int channels_of(Aov aov) { return info_of(aov).channels; }
constexpr bool is_light(Aov aov) { return info_of(aov).is_light; }

struct FrameAovs {
  std::array<bool, kAovs> wanted{};
  std::array<Image, kAovs> images;  ///< of the film's size where wanted, else empty

  bool wants(Aov aov) const { return wanted[static_cast<std::size_t>(aov)]; }
  bool wants_any(bool light) const;  ///< for which is_light is so
  void want(Aov aov) { wanted[static_cast<std::size_t>(aov)] = true; }
  Image& operator[](Aov aov) { return images[static_cast<std::size_t>(aov)]; }
  const Image& operator[](Aov aov) const { return images[static_cast<std::size_t>(aov)]; }

  /// Gives the image of a wanted layer the film's size, with nothing hit.
  void allocate(Aov aov, Vec2i film_size);
};

}  // namespace lippmann
