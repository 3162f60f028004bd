#include "shading/metal_rough_lanes.hpp"

namespace lippmann {

void MetalRoughLanes::set(int i, const MetalRoughSurface& s, const MetalRoughBsdf::Normals& normals, Vec3f view,
                          bool entering) {
  base_color_.set(i, s.base_color), specular_color_.set(i, s.specular_color);
  normal_.set(i, normals.diffuse), gloss_normal_.set(i, normals.gloss);
  view_.set(i, view);
  metallic_[i] = s.metallic, roughness_[i] = s.roughness, ior_[i] = s.ior, specular_[i] = s.specular;
  transmission_[i] = s.transmission, eta_[i] = entering ? s.ior : 1.0f / s.ior;
  const bool is_glossy = s.metallic > 0.0f || s.specular > 0.0f;
  most_ = std::max(most_, s.transmission > 0.0f ? Kind::kGlass : is_glossy ? Kind::kGloss : Kind::kLambert);
}

LIPPMANN_INLINE MetalRoughBase MetalRoughLanes::base(int i) const {
  MetalRoughBase b;
  b.view = local_view_.get(i);
  b.alpha = alpha_[i];
  b.diffuse_color = diffuse_color_.get(i), b.diffuse_passes = diffuse_passes_.get(i);
  b.dielectric_f0 = dielectric_f0_.get(i), b.gloss_f0 = gloss_f0_.get(i);
  b.dielectric_f90 = dielectric_f90_[i], b.gloss_f90 = gloss_f90_[i];
  b.gloss_compensation = gloss_compensation_.get(i), b.gloss_albedo = gloss_albedo_.get(i);
  return b;
}

LIPPMANN_INLINE Glass MetalRoughLanes::glass(int i) const {
  return {base_color_.get(i), glass_[i], eta_[i], glass_compensation_[i]};
}

LIPPMANN_MULTIVERSION void MetalRoughLanes::prepare_gloss(const GgxAlbedo& albedo) {
  LIPPMANN_FOR_LANES(i) {
    MetalRoughSurface s;
    s.base_color = base_color_.get(i), s.specular_color = specular_color_.get(i);
    s.metallic = metallic_[i], s.roughness = roughness_[i], s.ior = ior_[i], s.specular = specular_[i];
    s.transmission = transmission_[i];
    const MetalRoughBase b = metal_rough_base(s, albedo, lifted_view(Basis(gloss_normal_.get(i)).to_local(view_.get(i))));
    local_view_.set(i, b.view);
    alpha_[i] = b.alpha;
    diffuse_color_.set(i, b.diffuse_color), diffuse_passes_.set(i, b.diffuse_passes);
    dielectric_f0_.set(i, b.dielectric_f0), gloss_f0_.set(i, b.gloss_f0);
    dielectric_f90_[i] = b.dielectric_f90, gloss_f90_[i] = b.gloss_f90;
    gloss_compensation_.set(i, b.gloss_compensation), gloss_albedo_.set(i, b.gloss_albedo);
    glass_[i] = (1.0f - s.metallic) * s.transmission, glass_compensation_[i] = 1.0f;
    const float to_glass = glass_chance(glass(i));
    const float sum = b.gloss_luminance + b.diffuse_luminance + to_glass, all = sum > 0.0f ? sum : 1.0f;
    diffuse_share_[i] = b.diffuse_luminance / all, gloss_share_[i] = b.gloss_luminance / all, glass_share_[i] = to_glass / all;
  }
}

LIPPMANN_MULTIVERSION void MetalRoughLanes::prepare_lambert() {
  LIPPMANN_FOR_LANES(i) {
    const Vec3f color = base_color_.get(i);
    diffuse_color_.set(i, color), diffuse_passes_.set(i, Vec3f(1.0f));
    diffuse_share_[i] = luminance(color) > 0.0f ? 1.0f : 0.0f, gloss_share_[i] = glass_share_[i] = glass_[i] = 0.0f;
    dielectric_f0_.set(i, Vec3f(0.0f)), dielectric_f90_[i] = 0.0f;
    alpha_[i] = 1.0f;
  }
}

template <bool with_glass>
LIPPMANN_INLINE BsdfValue MetalRoughLanes::evaluate(int i, const GgxAlbedo& albedo, Vec3f light) const {
  const MetalRoughBase b = base(i);
  const float diffuse_share = diffuse_share_[i], gloss_share = gloss_share_[i];
  const float cosine = glm::dot(light, normal_.get(i));
  const Vec3f local = Basis(gloss_normal_.get(i)).to_local(light);
  float of_gloss;
  const Vec3f diffuse = diffuse_cosine_f(b, albedo, cosine), gloss = gloss_cosine_f(b, local, of_gloss);
  const bool is_diffuse = (cosine > 0.0f) & (diffuse_share > 0.0f);
  const bool is_glossy = (local.z > 0.0f) & (gloss_share > 0.0f) & !b.is_smooth();
  Vec3f cosine_f((is_diffuse ? diffuse.x : 0.0f) + (is_glossy ? gloss.x : 0.0f),
                 (is_diffuse ? diffuse.y : 0.0f) + (is_glossy ? gloss.y : 0.0f),
                 (is_diffuse ? diffuse.z : 0.0f) + (is_glossy ? gloss.z : 0.0f));
  float density = (is_diffuse ? diffuse_share * cosine * (1.0f / kPi) : 0.0f) + (is_glossy ? gloss_share * of_gloss : 0.0f);
  bool is_behind = false;
  if constexpr (with_glass) {
    const Glass part = glass(i);
    const float glass_share = glass_share_[i];
    float of_glass;
    const Vec3f glassy = glass_cosine_f(part, b.alpha, b.view, local, of_glass);
    const bool is_glass = (glass_share > 0.0f) & !b.is_smooth();
    cosine_f += Vec3f(is_glass ? glassy.x : 0.0f, is_glass ? glassy.y : 0.0f, is_glass ? glassy.z : 0.0f);
    density += is_glass ? glass_share * of_glass : 0.0f;
    is_behind = (part.share > 0.0f) & (cosine < 0.0f) & (local.z < 0.0f);
  }
  return {cosine_f, density, is_behind};
}

LIPPMANN_MULTIVERSION void MetalRoughLanes::evaluate_lambert(const Lanes3& lights, BsdfValueLanes& values) const {
  LIPPMANN_FOR_LANES(i) {
    const float cosine = glm::dot(lights.get(i), normal_.get(i));
    const bool is_lit = (cosine > 0.0f) & (diffuse_share_[i] > 0.0f);
    const float density = is_lit ? cosine * (1.0f / kPi) : 0.0f;
    values.set(i, {diffuse_color_.get(i) * density, density, false});
  }
}

LIPPMANN_MULTIVERSION void MetalRoughLanes::evaluate_gloss(const GgxAlbedo& albedo, const Lanes3& lights,
                                                           BsdfValueLanes& values) const {
  LIPPMANN_FOR_LANES(i) values.set(i, evaluate<false>(i, albedo, lights.get(i)));
}

LIPPMANN_MULTIVERSION void MetalRoughLanes::evaluate_glass(const GgxAlbedo& albedo, const Lanes3& lights,
                                                           BsdfValueLanes& values) const {
  LIPPMANN_FOR_LANES(i) values.set(i, evaluate<true>(i, albedo, lights.get(i)));
}

LIPPMANN_MULTIVERSION void MetalRoughLanes::sample_lambert(const Lanes& lobe, const Lanes& u, const Lanes& v,
                                                           BsdfSampleLanes& samples) const {
  LIPPMANN_FOR_LANES(i) {
    const Vec3f normal = normal_.get(i), direction = Basis(normal).to_world(sample_cosine({u[i], v[i]}));
    const float cosine = glm::dot(direction, normal);
    const bool is_any = (cosine > 0.0f) & (lobe[i] < diffuse_share_[i]);
    const float density = is_any ? cosine * (1.0f / kPi) : 0.0f;
    const Vec3f weight = diffuse_color_.get(i) * density / (density > 0.0f ? density : 1.0f);
    samples.set(i, {direction, weight, density});
  }
}

LIPPMANN_INLINE void MetalRoughLanes::draw_glass(int i, float lobe, Vec2f u, GlassLanes& drawn) const {
  const MetalRoughBase b = base(i);
  const float decision = (lobe - (diffuse_share_[i] + gloss_share_[i])) / glass_share_[i];
  bool transmitted;
  float outward;
  drawn.light.set(i, lippmann::draw_glass(eta_[i], b.view, draw_facet(b, u), decision, transmitted, outward));
  drawn.outward[i] = outward;
  drawn.transmitted.lane[i] = transmitted ? -1 : 0;
}

template <bool with_glass>
LIPPMANN_INLINE BsdfSample MetalRoughLanes::draw(int i, float lobe, Vec2f u, const GlassLanes* by_glass) const {
  const MetalRoughBase b = base(i);
  const float gloss_share = gloss_share_[i], below_gloss = diffuse_share_[i], below_glass = below_gloss + gloss_share;
  const bool is_diffuse = lobe < below_gloss, is_glossy = !is_diffuse & (lobe < below_glass);
  const Vec3f scattered = Basis(normal_.get(i)).to_world(sample_cosine(u));
  Vec3f light = mirrored(b.view, draw_facet(b, u));
  bool is_any = is_diffuse | (is_glossy & (light.z > 0.0f)), is_transmitted = false;
  Vec3f of_mirror = b.gloss_albedo / (gloss_share > 0.0f ? gloss_share : 1.0f);
  if constexpr (with_glass) {
    const Glass part = glass(i);
    const float glass_share = glass_share_[i];
    const bool is_glass = !is_diffuse & !is_glossy & (lobe < below_glass + glass_share);
    is_transmitted = is_glass & (by_glass->transmitted.lane[i] != 0);
    is_any |= is_glass & (by_glass->outward[i] > 0.0f);
    const Vec3f drawn = by_glass->light.get(i);
    const float of_glass = part.share / glass_share;
    light = {is_glass ? drawn.x : light.x, is_glass ? drawn.y : light.y, is_glass ? drawn.z : light.z};
    of_mirror = {is_glass ? of_glass * (is_transmitted ? part.tint.x : 1.0f) : of_mirror.x,
                 is_glass ? of_glass * (is_transmitted ? part.tint.y : 1.0f) : of_mirror.y,
                 is_glass ? of_glass * (is_transmitted ? part.tint.z : 1.0f) : of_mirror.z};
  }
  const Vec3f by_facet = Basis(gloss_normal_.get(i)).to_world(light);
  const Vec3f direction(is_diffuse ? scattered.x : by_facet.x, is_diffuse ? scattered.y : by_facet.y,
                        is_diffuse ? scattered.z : by_facet.z);
  const bool is_delta = !is_diffuse & b.is_smooth();
  return {direction, of_mirror, is_any ? is_delta ? kInfinity : 1.0f : 0.0f, is_transmitted};
}

template <bool with_glass>
LIPPMANN_INLINE void MetalRoughLanes::weigh(int i, const GgxAlbedo& albedo, BsdfSampleLanes& samples) const {
  const BsdfValue value = evaluate<with_glass>(i, albedo, samples.direction.get(i));
  const bool is_rough = samples.density[i] == 1.0f;
  const float per_density = value.density > 0.0f ? value.density : 1.0f;
  const Vec3f of_mirror = samples.weight.get(i), of_rough = value.cosine_f / per_density;
  samples.density[i] = is_rough ? value.density : samples.density[i];
  samples.weight.set(
      i, {is_rough ? of_rough.x : of_mirror.x, is_rough ? of_rough.y : of_mirror.y, is_rough ? of_rough.z : of_mirror.z});
}

LIPPMANN_MULTIVERSION void MetalRoughLanes::sample_gloss(const GgxAlbedo& albedo, const Lanes& lobe, const Lanes& u,
                                                         const Lanes& v, BsdfSampleLanes& samples) const {
  LIPPMANN_FOR_LANES(i) samples.set(i, draw<false>(i, lobe[i], {u[i], v[i]}, nullptr));
  LIPPMANN_FOR_LANES(i) weigh<false>(i, albedo, samples);
}

LIPPMANN_MULTIVERSION void MetalRoughLanes::sample_glass(const GgxAlbedo& albedo, const Lanes& lobe, const Lanes& u,
                                                         const Lanes& v, BsdfSampleLanes& samples) const {
  GlassLanes drawn;
  LIPPMANN_FOR_LANES(i) draw_glass(i, lobe[i], {u[i], v[i]}, drawn);
  LIPPMANN_FOR_LANES(i) samples.set(i, draw<true>(i, lobe[i], {u[i], v[i]}, &drawn));
  LIPPMANN_FOR_LANES(i) weigh<true>(i, albedo, samples);
}

// This function follows the kernels, because GCC cannot multiversion a function that has already been called.

void MetalRoughLanes::prepare(const GgxAlbedo& albedo) {
  if (most_ == Kind::kLambert) return prepare_lambert();
  prepare_gloss(albedo);
  if (most_ == Kind::kGlass) compensate_glass(albedo);
}

void MetalRoughLanes::compensate_glass(const GgxAlbedo& albedo) {
  for (int i = 0; i < kLanes; ++i)
    if (glass_[i] > 0.0f && alpha_[i] >= kSmoothAlpha)
      glass_compensation_[i] = 1.0f / albedo.glass().single(local_view_.z[i], alpha_[i], eta_[i]);
}

void MetalRoughLanes::evaluate(const GgxAlbedo& albedo, const Lanes3& lights, BsdfValueLanes& values) const {
  switch (most_) {
    case Kind::kLambert:
      return evaluate_lambert(lights, values);
    case Kind::kGloss:
      return evaluate_gloss(albedo, lights, values);
    case Kind::kGlass:
      return evaluate_glass(albedo, lights, values);
  }
}

void MetalRoughLanes::sample(const GgxAlbedo& albedo, const Lanes& lobe, const Lanes& u, const Lanes& v,
                             BsdfSampleLanes& samples) const {
  switch (most_) {
    case Kind::kLambert:
      return sample_lambert(lobe, u, v, samples);
    case Kind::kGloss:
      return sample_gloss(albedo, lobe, u, v, samples);
    case Kind::kGlass:
      return sample_glass(albedo, lobe, u, v, samples);
  }
}

Vec3f MetalRoughLanes::evaluate_diffuse(int i, const GgxAlbedo& albedo, Vec3f light) const {
  const float cosine = glm::dot(light, normal_.get(i));
  if (!(cosine > 0.0f)) return Vec3f(0.0f);
  return cosine * (1.0f / kPi) * let_in(base(i), albedo, cosine) / diffuse_passes_.get(i);
}

}  // namespace lippmann
