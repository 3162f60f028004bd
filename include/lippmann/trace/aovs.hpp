// Further layers of a frame: what the first hit behind every pixel's centre is, parts of its light, and where that came from.
//
// Surfaces that are not there do not count as hit: what alpha masks cut away, and what blended surfaces cover to less than a
// half. Everything else is as solid for these layers as stone, glass too.
#pragma once

#include <array>
#include <cstdint>
#include <iterator>
#include <limits>
#include <string_view>

#include "lippmann/image/image.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

enum class Aov : std::uint8_t {
  kDepth,       ///< z in display mm (> 0 in front of the array)
  kNormal,      ///< unit, world space, towards the ray
  kId,          ///< index in Scene::instances
  kPosition,    ///< world space
  kRayDepth,    ///< mm along the ray from where it starts (resolved_z_front_mm): from the eye
  kAlbedo,      ///< base colour, textures and vertex colours included
  kMotion,      ///< see place_in_view; pixels to the right and down since the frame before
  kProvenance,  ///< where the pixel came from: a number of Provenance
  kDirect,      ///< path tracing only: what shines by itself and light that one surface has scattered
  kIndirect,    ///< path tracing only: all other light; with kDirect it adds up to the film before denoising, but for rounding
  kAlpha,       ///< share of the pixel's samples that hit something, what alpha covers by its share; the film is then free of
                ///< the surroundings that the others would see
};

/// Where a pixel came from: the values of Aov::kProvenance. A pixel is missed if no point of another frame lands on it.
enum class Provenance : std::uint8_t {
  kTraced,        ///< in this frame
  kCopied,        ///< from a key frame, as it provably stays as it is
  kInterpolated,  ///< from points of other frames
  kFilled,        ///< missed, and filled from its neighbours
  kRetraced,      ///< missed, and traced
  kBlack,         ///< missed, and left black
};
struct ProvenanceInfo {
  std::string_view name;  ///< for people
  bool missed;
};
/// By Provenance.
inline constexpr ProvenanceInfo kProvenanceInfos[] = {
    {"traced", false},        {"copied from a key frame", false}, {"interpolated", false},
    {"missed, filled", true}, {"missed, traced", true},           {"missed, left black", true},
};
static_assert(std::size(kProvenanceInfos) == static_cast<std::size_t>(Provenance::kBlack) + 1);

/// What makes a layer.
enum class AovOrigin : std::uint8_t {
  kFirstHit,  ///< one ray through the pixel's centre
  kLight,     ///< a mean over all samples, made with the light: no property of what is behind the pixel's centre
  kFrame,     ///< told by whatever makes the frame, which it is made no differently for
};

/// All that is known of a layer anywhere: a new one is a value of Aov, a row below and what computes it.
struct AovInfo {
  std::string_view name;  ///< as flags, files and other programs call it
  int channels;
  float nothing;  ///< where nothing was hit
  AovOrigin origin;
  /// In OpenEXR: layer.channel, or just channel where the layer has no name, as compositing programs expect them. Floats where
  /// half has not enough digits.
  struct InExr {
    std::string_view layer;
    std::array<std::string_view, 3> channels;
    bool is_float;
    double bytes_per_pixel;  ///< about, as compressed files of the built-in scenes have it
  } exr;
};
/// By Aov.
inline constexpr AovInfo kAovInfos[] = {
    {"depth", 1, -std::numeric_limits<float>::infinity(), AovOrigin::kFirstHit, {"", {"Z"}, true, 3.0}},
    {"normal", 3, 0.0f, AovOrigin::kFirstHit, {"N", {"X", "Y", "Z"}, false, 1.5}},
    {"id", 1, -1.0f, AovOrigin::kFirstHit, {"", {"id"}, true, 0.15}},
    {"position", 3, 0.0f, AovOrigin::kFirstHit, {"P", {"X", "Y", "Z"}, true, 7.0}},
    {"ray-depth", 1, std::numeric_limits<float>::infinity(), AovOrigin::kFirstHit, {"ray", {"Z"}, true, 3.0}},
    {"albedo", 3, 0.0f, AovOrigin::kFirstHit, {"albedo", {"R", "G", "B"}, false, 2.8}},
    {"motion", 2, 0.0f, AovOrigin::kFirstHit, {"motion", {"X", "Y"}, true, 3.0}},
    {"provenance", 1, 0.0f, AovOrigin::kFrame, {"", {"provenance"}, false, 0.05}},
    {"direct", 3, 0.0f, AovOrigin::kLight, {"direct", {"R", "G", "B"}, false, 9.0}},
    {"indirect", 3, 0.0f, AovOrigin::kLight, {"indirect", {"R", "G", "B"}, false, 9.0}},
    {"alpha", 1, 0.0f, AovOrigin::kLight, {"", {"A"}, false, 0.2}},
};
inline constexpr std::size_t kAovs = std::size(kAovInfos);
static_assert(kAovs == static_cast<std::size_t>(Aov::kAlpha) + 1);

constexpr const AovInfo& info_of(Aov aov) { return kAovInfos[static_cast<std::size_t>(aov)]; }
constexpr int channels_of(Aov aov) { return info_of(aov).channels; }
constexpr bool is_light(Aov aov) { return info_of(aov).origin == AovOrigin::kLight; }

/// By Aov.
inline constexpr std::array<std::string_view, kAovs> kAovNames = [] {
  std::array<std::string_view, kAovs> names;
  for (std::size_t i = 0; i < kAovs; ++i) names[i] = kAovInfos[i].name;
  return names;
}();

struct FrameAovs {
  std::array<bool, kAovs> wanted{};
  std::array<Image, kAovs> images;  ///< one for each Aov: as large as the film where wanted, else empty

  bool wants(Aov aov) const { return wanted[static_cast<std::size_t>(aov)]; }
  bool wants_any(AovOrigin origin) const;
  void want(Aov aov) { wanted[static_cast<std::size_t>(aov)] = true; }
  Image& operator[](Aov aov) { return images[static_cast<std::size_t>(aov)]; }
  const Image& operator[](Aov aov) const { return images[static_cast<std::size_t>(aov)]; }

  /// Gives the image of a wanted layer the film's size, with nothing hit.
  void allocate(Aov aov, Vec2i film_size);
};

}  // namespace lippmann
