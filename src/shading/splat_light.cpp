#include "shading/splat_light.hpp"

#include "scene/splats.hpp"

namespace lippmann {
namespace {

constexpr std::size_t kMostHarmonics = 16, kChannels = 3;

/// The spherical harmonics for a ray's direction, each stored three times, for R, G and B.
class SplatBasis {
 public:
  void aim(const SplatSet& set, Vec3f direction) {
    const Vec3f local = set.local_from_world * direction;
    alignas(64) float basis[kMostHarmonics];
    splat_basis(local / glm::length(local), basis);
    for (std::size_t k = 0; k < kMostHarmonics; ++k)
      for (std::size_t c = 0; c < kChannels; ++c) values_[kChannels * k + c] = basis[k];
  }

  /// Returns the splat's colour: 0.5 + sum of coefficients times basis functions, at least 0. Twelve partial sums allow vector
  /// instructions.
  Vec3f color(const Splats& splats, std::size_t splat) const {
    constexpr std::size_t kStride = 12;
    const std::size_t each = harmonics_of(splats.degree), numbers = kChannels * each;
    const float* h = &splats.harmonics[splat * each].x;
    float sums[kStride] = {};
    std::size_t first = 0;
    for (; first + kStride <= numbers; first += kStride)
      for (std::size_t j = 0; j < kStride; ++j) sums[j] += h[first + j] * values_[first + j];
    for (std::size_t j = 0; first + j < numbers; ++j) sums[j] += h[first + j] * values_[first + j];
    Vec3f color(0.5f);
    for (std::size_t j = 0; j < kStride; ++j) color[static_cast<int>(j % kChannels)] += sums[j];
    return glm::max(color, Vec3f(0.0f));
  }

 private:
  alignas(64) float values_[kChannels * kMostHarmonics];
};

/// Returns the linear value of an sRGB code. The sRGB curve is extended above 1.
float linear_of(float encoded) { return encoded <= 0.04045f ? encoded / 12.92f : fast_pow((encoded + 0.055f) / 1.055f, 2.4f); }
Vec3f linear_of(Vec3f encoded) { return {linear_of(encoded.x), linear_of(encoded.y), linear_of(encoded.z)}; }

class Blend {
 public:
  explicit Blend(const ShadedScene& scene) : table_(scene.splats) {}

  void add(const SplatHit& hit, Vec3f direction) {
    const WorldSplat& splat = table_.splats[hit.splat];
    const SplatSet& set = table_.sets[splat.set];
    if (splat.set != aimed_set_) basis_.aim(set, direction);
    aimed_set_ = splat.set;
    const float share = left_ * hit.alpha;
    const Vec3f color = share * basis_.color(*set.splats, splat.source);
    if (set.splats->is_linear)
      linear_ += color;
    else
      encoded_ += color, encoded_share_ += share;
    left_ = hit.left;
  }

  /// Returns the transmittance. A transmittance below kDark counts as 0.
  float passed() const { return left_ < kDark ? 0.0f : left_; }
  Vec3f radiance() const {
    const Vec3f seen = encoded_share_ > 0.0f ? linear_ + encoded_share_ * linear_of(encoded_ / encoded_share_) : linear_;
    return left_ < kDark && left_ < 1.0f ? seen / (1.0f - left_) : seen;
  }

 private:
  const SplatTable& table_;
  SplatBasis basis_;
  std::uint32_t aimed_set_ = ~0u;
  float left_ = 1.0f, encoded_share_ = 0.0f;
  Vec3f encoded_{0.0f}, linear_{0.0f};
};

}  // namespace

void splat_basis(Vec3f d, float* b) {
  const float x = d.x, y = d.y, z = d.z, xx = x * x, yy = y * y, zz = z * z;
  b[0] = 0.2820947917738781f;
  b[1] = -0.4886025119029199f * y;
  b[2] = 0.4886025119029199f * z;
  b[3] = -0.4886025119029199f * x;
  b[4] = 1.092548430592079f * x * y;
  b[5] = -1.092548430592079f * y * z;
  b[6] = 0.3153915652525200f * (2.0f * zz - xx - yy);
  b[7] = -1.092548430592079f * x * z;
  b[8] = 0.5462742152960395f * (xx - yy);
  b[9] = -0.5900435899266435f * y * (3.0f * xx - yy);
  b[10] = 2.890611442640554f * x * y * z;
  b[11] = -0.4570457994644657f * y * (4.0f * zz - xx - yy);
  b[12] = 0.3731763325901154f * z * (2.0f * zz - 3.0f * xx - 3.0f * yy);
  b[13] = -0.4570457994644657f * x * (4.0f * zz - xx - yy);
  b[14] = 1.445305721320277f * z * (xx - yy);
  b[15] = -0.5900435899266435f * x * (xx - 3.0f * yy);
}

void see_splats(const ShadedScene& scene, const LaneMask& active, const RayPacket& rays, SplatHits& hits, SplatLight& light) {
  scene.meet_splats(active, rays, hits);
  for (int i = 0; i < kLanes; ++i) {
    if (!active.lane[i]) continue;
    const Vec3f direction(rays.dir_x[i], rays.dir_y[i], rays.dir_z[i]);
    Blend blend(scene);
    for (const SplatHit& hit : hits.of(i)) blend.add(hit, direction);
    light.radiance.set(i, blend.radiance());
    light.passed[i] = blend.passed();
  }
}

}  // namespace lippmann
