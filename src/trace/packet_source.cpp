#include "trace/packet_source.hpp"

#include <algorithm>

#include "core/random.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

std::uint32_t reversed_bits(std::uint32_t x) {
  x = (x << 16) | (x >> 16);
  x = ((x & 0x00ff00ffu) << 8) | ((x & 0xff00ff00u) >> 8);
  x = ((x & 0x0f0f0f0fu) << 4) | ((x & 0xf0f0f0f0u) >> 4);
  x = ((x & 0x33333333u) << 2) | ((x & 0xccccccccu) >> 2);
  return ((x & 0x55555555u) << 1) | ((x & 0xaaaaaaaau) >> 1);
}

LIPPMANN_MULTIVERSION void center_lanes(const StripPixel* pixels, int top, int width, float* px, float* py,
                                        std::uint32_t* index) {
  LIPPMANN_FOR_LANES(i) {
    const int x = pixels[i].x, y = top + pixels[i].y;
    px[i] = static_cast<float>(x) + 0.5f;
    py[i] = static_cast<float>(y) + 0.5f;
    index[i] = static_cast<std::uint32_t>(y * width + x);
  }
}

LIPPMANN_MULTIVERSION void set_range(float depth, Vec3f forward, RayPacket& rays) {
  LIPPMANN_FOR_LANES(i) {
    rays.tnear[i] = 0.0f;
    rays.tfar[i] = depth / (rays.dir_x[i] * forward.x + rays.dir_y[i] * forward.y + rays.dir_z[i] * forward.z);
  }
}

}  // namespace

Vec2f SubPixel::position(std::uint32_t pixel, int sample) const {
  if (samples == 1) return Vec2f(0.5f);
  const auto s = static_cast<std::uint32_t>(sample);
  const std::uint32_t shift_x = hash(seed, pixel, 0u), shift_y = hash(seed, pixel, 1u);
  // Positions are 32-bit fractions of a pixel. Their sum wraps around at 1.
  const auto x = static_cast<std::uint32_t>((static_cast<std::uint64_t>(s) << 32) / static_cast<std::uint32_t>(samples));
  // The last 1/256 of the pixel is excluded, because adding a pixel coordinate of up to 65,535 would round such positions up to
  // the next pixel.
  return glm::min(Vec2f(unit_float(x + shift_x), unit_float(reversed_bits(s) + shift_y)), Vec2f(1.0f - 1.0f / 256.0f));
}

SampleRays::SampleRays(const Optics& optics, const Affine3f& world_from_display, const SubPixel& sub_pixel)
    : lens_(optics, world_from_display, sub_pixel.lens, sub_pixel.seed) {
  for (const Vec2f shift : eye_shifts(optics, sub_pixel.angular_filter, sub_pixel.samples))
    eyes_.emplace_back(with_eyes_shifted(optics, shift), world_from_display);
}

void SampleRays::fill(int sample, const float* px, const float* py, const std::uint32_t* pixel, RayPacket& rays) const {
  const RayGenerator& eye = eyes_[eyes_.size() > 1 ? static_cast<std::size_t>(sample) : 0];
  eye.rays(px, py, kLanes, {rays.org_x, rays.org_y, rays.org_z, rays.dir_x, rays.dir_y, rays.dir_z});
  set_range(eye.depth(), eye.forward(), rays);
  eye.mark_blocked(px, py, kLanes, kBlocked, rays.tfar);
  if (!lens_.is_open()) return;
  std::uint32_t samples[kLanes];
  std::fill_n(samples, kLanes, static_cast<std::uint32_t>(sample));
  lens_.spread({pixel, samples}, rays);
}

PacketSource::PacketSource(const Optics& optics, const Affine3f& world_from_display, RayOrder order, const SubPixel& sub_pixel,
                           FilmRows rows)
    : rays_(optics, world_from_display, sub_pixel),
      order_(make_strip_order(optics, order)),
      sub_pixel_(sub_pixel),
      width_(film_size(optics).x),
      rows_{rows.first, std::min(rows.end, film_size(optics).y)},
      strips_((rows_.end - rows_.first + order_.strip_height - 1) / order_.strip_height),
      packets_(static_cast<int>((order_.pixels.size() + kLanes - 1) / kLanes)) {
  order_.pixels.resize(static_cast<std::size_t>(packets_) * kLanes, order_.pixels.back());
}

int PacketSource::rows_in_strip(int strip) const {
  return std::min(order_.strip_height, rows_.end - rows_.first - strip * order_.strip_height);
}

bool PacketSource::is_inside(int rows, int packet, int lane) const {
  const int at = packet * kLanes + lane;
  return at < width_ * order_.strip_height && order_.pixels[static_cast<std::size_t>(at)].y < rows;
}

int PacketSource::fill(int strip, int packet, int sample, RayPacket& rays, LaneMask& active, std::uint32_t* pixel) const {
  const StripPixel* pixels = order_.pixels.data() + static_cast<std::size_t>(packet) * kLanes;
  const int top = rows_.first + strip * order_.strip_height, rows = rows_in_strip(strip);
  alignas(64) float px[kLanes], py[kLanes];
  center_lanes(pixels, top, width_, px, py, pixel);
  const bool padded = (packet + 1) * kLanes > width_ * order_.strip_height;
  int count = kLanes;
  for (int& lane : active.lane) lane = -1;
  if (padded || rows < order_.strip_height) {
    count = 0;
    for (int i = 0; i < kLanes; ++i) {
      const bool inside = is_inside(rows, packet, i);
      active.lane[i] = inside ? -1 : 0;
      count += inside;
    }
    if (count == 0) return 0;
  }
  if (sub_pixel_.samples > 1)
    for (int i = 0; i < kLanes; ++i) {
      const Vec2f offset = sub_pixel_.position(pixel[i], sample) - Vec2f(0.5f);
      px[i] += offset.x, py[i] += offset.y;
    }
  rays_.fill(sample, px, py, pixel, rays);
  return count;
}

}  // namespace lippmann
