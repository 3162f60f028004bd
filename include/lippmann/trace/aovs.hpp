// Further layers of a frame: what the first hit behind every pixel's centre is, and parts of its light.
//
// Surfaces that are not there do not count as hit: what alpha masks cut away, and what blended surfaces cover to less than a
// half. Everything else is as solid for these layers as stone, glass too.
#pragma once

#include <array>
#include <cstdint>

#include "lippmann/image/image.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

enum class Aov : std::uint8_t {
  kDepth,     ///< 1 channel: z in display mm (> 0 in front of the array); -inf where nothing was hit
  kNormal,    ///< 3 channels: unit, world space, towards the ray; 0 where nothing was hit
  kId,        ///< 1 channel: index in Scene::instances; -1 where nothing was hit
  kPosition,  ///< 3 channels: world space; 0 where nothing was hit
  kRayDepth,  ///< 1 channel: mm along the ray from where it starts (resolved_z_front_mm): from the eye; inf: nothing was hit
  kAlbedo,    ///< 3 channels: base colour, textures and vertex colours included; 0 where nothing was hit
  kMotion,    ///< 2 channels: see place_in_view; pixels to the right and down since the frame before; 0 where nothing was hit
  kDirect,    ///< 3 channels, of paths: what shines by itself and light that one surface has scattered
  kIndirect,  ///< 3 channels, of paths: all other light; with kDirect the film, but for rounding
  kAlpha,     ///< 1 channel: share of the pixel's samples that hit something, what alpha covers by its share; of the
              ///< surroundings, that the others would see, the film is then free
};
inline constexpr std::size_t kAovs = 10;

int channels_of(Aov aov);

/// Whether it comes with the light, as a mean over all samples, and is no property of what is behind the pixel's centre.
inline bool is_light(Aov aov) { return aov == Aov::kDirect || aov == Aov::kIndirect || aov == Aov::kAlpha; }

struct FrameAovs {
  std::array<bool, kAovs> wanted{};
  std::array<Image, kAovs> images;  ///< of the panel's size where wanted, else empty

  bool wants(Aov aov) const { return wanted[static_cast<std::size_t>(aov)]; }
  bool wants_any(bool light) const;  ///< for which is_light is so
  void want(Aov aov) { wanted[static_cast<std::size_t>(aov)] = true; }
  Image& operator[](Aov aov) { return images[static_cast<std::size_t>(aov)]; }
  const Image& operator[](Aov aov) const { return images[static_cast<std::size_t>(aov)]; }

  /// Gives the image of a wanted layer the panel's size and this value.
  void allocate(Aov aov, const Panel& panel, float value);
};

}  // namespace lippmann
