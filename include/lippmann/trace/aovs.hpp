// Additional layers of a frame (AOVs): properties of the first surface that a ray through each pixel's centre hits, and parts
// of the light.
//
// Surfaces with an alpha below one half are skipped. Glass counts as opaque.
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
  kDepth,   ///< z in mm of the display frame, > 0 in front of the array
  kNormal,  ///< surface normal in world space, unit length, on the side of the ray's origin
  kId,      ///< index of the object in Scene::instances
  kPosition,
  kRayDepth,    ///< distance from the ray's start in mm; in views, rays start at the eye
  kAlbedo,      ///< base colour with textures and vertex colours
  kMotion,      ///< movement of the surface point since the previous frame, in pixels to the right and down
  kProvenance,  ///< how the pixel was made: a value of Provenance
  kDirect,      ///< path tracing only: emission, and light that exactly one surface has scattered
  /// Path tracing only: all other light. kDirect + kIndirect is the film before denoising, up to rounding.
  kIndirect,
  /// Coverage of the pixel by surfaces. If this layer is requested, the film omits the background.
  kAlpha,
};

/// How a pixel was made.
enum class Provenance : std::uint8_t {
  kTraced,
  kCopied,        ///< copied from a key frame, because the pixel provably has not changed
  kInterpolated,  ///< interpolated from points of other frames
  kFilled,        ///< no point was projected onto the pixel; filled from neighbouring pixels
  kRetraced,      ///< no point was projected onto the pixel; traced
  kBlack,         ///< no point was projected onto the pixel; left black
};
struct ProvenanceInfo {
  std::string_view name{};
  bool missed{};
};
inline constexpr ProvenanceInfo kProvenanceInfos[] = {
    {"traced", false},        {"copied from a key frame", false}, {"interpolated", false},
    {"missed, filled", true}, {"missed, traced", true},           {"missed, left black", true},
};
static_assert(std::size(kProvenanceInfos) == static_cast<std::size_t>(Provenance::kBlack) + 1);

enum class AovOrigin : std::uint8_t {
  kFirstHit,
  kLight,  ///< averaged over all samples of the pixel
  kFrame,  ///< written while the frame is made, at no extra cost
};

/// Properties of a layer.
struct AovInfo {
  std::string_view name{};  ///< name in flags, files and other programs
  int channels{};
  float nothing{};  ///< value of pixels without a hit
  AovOrigin origin{};
  /// Layer and channel names in OpenEXR files. A channel is called "layer.channel", or "channel" if the layer has no name.
  /// is_float: stored as float instead of half.
  struct InExr {
    std::string_view layer;
    std::array<std::string_view, 3> channels{};
    bool is_float;
    double bytes_per_pixel;  ///< approximate compressed size, measured on the built-in scenes
  } exr{};
};
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

inline constexpr std::array<std::string_view, kAovs> kAovNames = [] {
  std::array<std::string_view, kAovs> names;
  for (std::size_t i = 0; i < kAovs; ++i) names[i] = kAovInfos[i].name;
  return names;
}();

struct FrameAovs {
  std::array<bool, kAovs> wanted{};
  std::array<Image, kAovs> images{};  ///< one image per Aov: as large as the film if wanted, otherwise empty

  bool wants(Aov aov) const { return wanted[static_cast<std::size_t>(aov)]; }
  bool wants_any(AovOrigin origin) const;
  void want(Aov aov) { wanted[static_cast<std::size_t>(aov)] = true; }
  Image& operator[](Aov aov) { return images[static_cast<std::size_t>(aov)]; }
  const Image& operator[](Aov aov) const { return images[static_cast<std::size_t>(aov)]; }

  /// Makes the layer as large as the film, filled with the value of pixels without a hit.
  void allocate(Aov aov, Vec2i film_size);
};

}  // namespace lippmann
