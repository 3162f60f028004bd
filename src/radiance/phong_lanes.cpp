#include "radiance/phong_lanes.hpp"

#include "device/fast_math.hpp"
#include "transport/bsdf.hpp"

namespace lippmann {
namespace {

LIPPMANN_INLINE float dot(const Lanes3& a, const Lanes3& b, int i) {
  return a.x[i] * b.x[i] + a.y[i] * b.y[i] + a.z[i] * b.z[i];
}

LIPPMANN_INLINE float luminance(const Lanes3& c, int i) { return 0.2126f * c.x[i] + 0.7152f * c.y[i] + 0.0722f * c.z[i]; }

/// Adds the highlight's share to `f`: of light from where `aimed` goes, towards `view`.
LIPPMANN_INLINE void add_highlight(const SurfacePacket& s, const PhongLanes& phong, const RayPacket& view,
                                   const ShadowPacket& aimed, Lanes3& f) {
  LIPPMANN_FOR_LANES(i) {
    const float hx = aimed.rays.dir_x[i] - view.dir_x[i], hy = aimed.rays.dir_y[i] - view.dir_y[i],
                hz = aimed.rays.dir_z[i] - view.dir_z[i];
    const float length = std::sqrt(hx * hx + hy * hy + hz * hz) + 1e-20f;
    const float along = (s.normal.x[i] * hx + s.normal.y[i] * hy + s.normal.z[i] * hz) / length;
    const float base = std::min(std::max(along, 1e-6f), 1.0f);
    const float lobe = along > 0.0f ? fast_pow(base, s.highlight_size[i]) * (1.0f / kPi) : 0.0f;
    f.x[i] += phong.highlight.x[i] * lobe;
    f.y[i] += phong.highlight.y[i] * lobe;
    f.z[i] += phong.highlight.z[i] * lobe;
  }
}

}  // namespace

LIPPMANN_MULTIVERSION void evaluate_phong(const SurfacePacket& s, bool tachyon, const LaneMask& lanes, PhongLanes& phong) {
  int highlight = 0, emission = 0, gloss = 0;
  LIPPMANN_FOR_LANES(i) {
    const float itself = tachyon ? 1.0f : s.opacity[i];  // Tachyon's are not weighted by opacity
    const float diffuse = itself * s.diffuse[i], shine = itself * s.highlight[i];
    // Ambient light stands for what paths bring, but where no other light is answered it is the shape's own: a backdrop's.
    const float own = s.diffuse[i] == 0.0f ? 1.0f : 0.0f;
    const auto set = [&](float color, float ambient, float emitted, float& d, float& h, float& m, float& e)
                         LIPPMANN_INLINE_LAMBDA {
                           d = diffuse * color;
                           h = shine * (1.0f + s.highlight_tint[i] * (color - 1.0f));
                           m = s.mirror[i] * (1.0f + s.mirror_tint[i] * (color - 1.0f));
                           e = itself * (emitted + own * ambient * color);
                         };
    set(s.color.x[i], s.ambient.x[i], s.emission.x[i], phong.diffuse.x[i], phong.highlight.x[i], phong.mirror.x[i],
        phong.emission.x[i]);
    set(s.color.y[i], s.ambient.y[i], s.emission.y[i], phong.diffuse.y[i], phong.highlight.y[i], phong.mirror.y[i],
        phong.emission.y[i]);
    set(s.color.z[i], s.ambient.z[i], s.emission.z[i], phong.diffuse.z[i], phong.highlight.z[i], phong.mirror.z[i],
        phong.emission.z[i]);
    phong.through[i] = 1.0f - s.opacity[i];
    const bool asked = lanes.lane[i] != 0;
    highlight |= asked & (shine != 0.0f) ? -1 : 0;
    emission |= asked & (luminance(phong.emission, i) != 0.0f) ? -1 : 0;
    gloss |= asked & ((phong.through[i] > 0.0f) | (luminance(phong.mirror, i) > 0.0f)) ? -1 : 0;
  }
  phong.any_highlight = highlight != 0, phong.any_emission = emission != 0, phong.any_gloss = gloss != 0;
}

LIPPMANN_MULTIVERSION int reflect_light(const PhongVertices& at, Vec3f irradiance, ShadowPacket& aimed, Lanes3& radiance) {
  const auto& [s, phong, paths, view, lanes] = at;
  Lanes3 f;
  LIPPMANN_FOR_LANES(i) {
    const float cosine =
        (s.normal.x[i] * aimed.rays.dir_x[i] + s.normal.y[i] * aimed.rays.dir_y[i] + s.normal.z[i] * aimed.rays.dir_z[i]) *
        (1.0f / kPi);
    f.x[i] = phong.diffuse.x[i] * cosine;
    f.y[i] = phong.diffuse.y[i] * cosine;
    f.z[i] = phong.diffuse.z[i] * cosine;
  }
  if (phong.any_highlight) add_highlight(s, phong, view, aimed, f);
  const bool any_lifted = aimed.any_lifted;
  int count = 0;
  LIPPMANN_FOR_LANES(i) {
    radiance.x[i] = paths.throughput.x[i] * f.x[i] * (irradiance.x * aimed.strength[i]);
    radiance.y[i] = paths.throughput.y[i] * f.y[i] * (irradiance.y * aimed.strength[i]);
    radiance.z[i] = paths.throughput.z[i] * f.z[i] * (irradiance.z * aimed.strength[i]);
    const float sum = radiance.x[i] + radiance.y[i] + radiance.z[i];
    const float before =
        s.facet.x[i] * aimed.rays.dir_x[i] + s.facet.y[i] * aimed.rays.dir_y[i] + s.facet.z[i] * aimed.rays.dir_z[i];
    const bool rises = any_lifted & (aimed.lifted.lane[i] != 0);
    // Behind the facet only where the smooth surface rises above it; and neither nothing nor what is no number.
    const bool arrives =
        (lanes.lane[i] != 0) & (aimed.active.lane[i] != 0) & (!(before < 0.0f) | rises) & (sum > 0.0f) & (sum < kInfinity);
    aimed.active.lane[i] = arrives ? -1 : 0;
    count += arrives ? 1 : 0;
  }
  return count;
}

LIPPMANN_MULTIVERSION void reflect_gloss(const PhongVertices& at, const Lanes& lobe, const Lanes& survival, float faint,
                                         GlossyRays& rays) {
  const auto& [s, phong, paths, view, lanes] = at;
  LIPPMANN_FOR_LANES(i) {
    const float nx = s.normal.x[i], ny = s.normal.y[i], nz = s.normal.z[i];
    const float vx = -view.dir_x[i], vy = -view.dir_y[i], vz = -view.dir_z[i];
    const float mirror = luminance(phong.mirror, i), sum = mirror + phong.through[i];
    const float mirror_share = sum > 0.0f ? mirror / sum : 0.0f, through_share = sum > 0.0f ? phong.through[i] / sum : 0.0f;
    const bool mirrors = lobe[i] < mirror_share;
    const bool straight = !mirrors & (s.ior[i] == 1.0f);
    // Snell's law, as refracted_away(); where it has no answer all is mirrored.
    const float cosine = nx * vx + ny * vy + nz * vz;
    const float eta = s.entering.lane[i] != 0 ? s.ior[i] : 1.0f / s.ior[i];
    const float k = 1.0f - (1.0f - cosine * cosine) / (eta * eta);
    const bool refracts = !mirrors & !straight & (k > 0.0f);
    const float bent = cosine / eta - std::sqrt(std::max(k, 0.0f));
    const float rx = bent * nx - vx / eta, ry = bent * ny - vy / eta, rz = bent * nz - vz / eta;
    const float length = std::sqrt(rx * rx + ry * ry + rz * rz) + 1e-20f;
    const float along_n = refracts ? bent / length : straight ? 0.0f : 2.0f * cosine;
    const float along_v = refracts ? -1.0f / (eta * length) : -1.0f;
    rays.direction.x[i] = along_n * nx + along_v * vx;
    rays.direction.y[i] = along_n * ny + along_v * vy;
    rays.direction.z[i] = along_n * nz + along_v * vz;
    const bool transmitted = straight | refracts;
    const bool behind = dot(s.facet, rays.direction, i) < 0.0f;
    const float share = mirrors ? mirror_share : through_share, inverse = 1.0f / std::max(share, 1e-20f);
    const float through = phong.through[i];
    const float tx = paths.throughput.x[i] * ((mirrors ? phong.mirror.x[i] : through) * inverse);
    const float ty = paths.throughput.y[i] * ((mirrors ? phong.mirror.y[i] : through) * inverse);
    const float tz = paths.throughput.z[i] * ((mirrors ? phong.mirror.z[i] : through) * inverse);
    const float chance = std::min(1.0f, faint * std::max(tx, std::max(ty, tz)));
    const float kept = 1.0f / std::max(chance, 1e-20f);
    rays.throughput.x[i] = tx * kept, rays.throughput.y[i] = ty * kept, rays.throughput.z[i] = tz * kept;
    const float left = rays.throughput.x[i] + rays.throughput.y[i] + rays.throughput.z[i];
    const bool goes_on = (lanes.lane[i] != 0) & (share > 0.0f) & (behind == transmitted) & (survival[i] < chance) &
                         (left > 0.0f) & (left < kInfinity);
    rays.active.lane[i] = goes_on ? -1 : 0;
    rays.straight.lane[i] = straight ? -1 : 0;
  }
}

}  // namespace lippmann
