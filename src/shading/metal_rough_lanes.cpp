#include "shading/metal_rough_lanes.hpp"

namespace lippmann {

void MetalRoughLanes::set(int i, const MetalRoughSurface& s, const MetalRoughBsdf::Normals& normals, Vec3f view) {
  base_color_.set(i, s.base_color), specular_color_.set(i, s.specular_color);
  normal_.set(i, normals.diffuse), gloss_normal_.set(i, normals.gloss);
  view_.set(i, view);
  any_gloss_ |= s.metallic > 0.0f || s.specular > 0.0f;
  metallic_[i] = s.metallic, roughness_[i] = s.roughness, ior_[i] = s.ior, specular_[i] = s.specular;
}

LIPPMANN_MULTIVERSION void MetalRoughLanes::prepare_gloss(const GgxAlbedo& albedo) {
  LIPPMANN_FOR_LANES(i) {
    MetalRoughSurface s;
    s.base_color = base_color_.get(i), s.specular_color = specular_color_.get(i);
    s.metallic = metallic_[i], s.roughness = roughness_[i], s.ior = ior_[i], s.specular = specular_[i];
    const MetalRoughBase b = metal_rough_base(s, albedo, lifted_view(Frame(gloss_normal_.get(i)).to_local(view_.get(i))));
    local_view_.set(i, b.view);
    alpha_[i] = b.alpha;
    diffuse_color_.set(i, b.diffuse_color), diffuse_passes_.set(i, b.diffuse_passes);
    dielectric_f0_.set(i, b.dielectric_f0), gloss_f0_.set(i, b.gloss_f0);
    dielectric_f90_[i] = b.dielectric_f90, gloss_f90_[i] = b.gloss_f90;
    gloss_compensation_.set(i, b.gloss_compensation), gloss_albedo_.set(i, b.gloss_albedo);
    const float sum = b.gloss_luminance + b.diffuse_luminance, all = sum > 0.0f ? sum : 1.0f;
    diffuse_share_[i] = b.diffuse_luminance / all, gloss_share_[i] = b.gloss_luminance / all;
  }
}

LIPPMANN_MULTIVERSION void MetalRoughLanes::prepare_lambert() {
  LIPPMANN_FOR_LANES(i) {
    const Vec3f color = base_color_.get(i);
    diffuse_color_.set(i, color), diffuse_passes_.set(i, Vec3f(1.0f));
    diffuse_share_[i] = luminance(color) > 0.0f ? 1.0f : 0.0f, gloss_share_[i] = 0.0f;
    dielectric_f0_.set(i, Vec3f(0.0f)), dielectric_f90_[i] = 0.0f;
    alpha_[i] = 1.0f;
  }
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

LIPPMANN_INLINE void MetalRoughLanes::evaluate(int i, const GgxAlbedo& albedo, Vec3f light, Vec3f& cosine_f,
                                               float& density) const {
  const MetalRoughBase b = base(i);
  const float diffuse_share = diffuse_share_[i], gloss_share = gloss_share_[i];
  const float cosine = glm::dot(light, normal_.get(i));
  const Vec3f local = Frame(gloss_normal_.get(i)).to_local(light);
  float of_gloss;
  const Vec3f diffuse = diffuse_cosine_f(b, albedo, cosine), gloss = gloss_cosine_f(b, local, of_gloss);
  const bool is_diffuse = (cosine > 0.0f) & (diffuse_share > 0.0f);
  const bool is_glossy = (local.z > 0.0f) & (gloss_share > 0.0f) & !b.is_smooth();
  cosine_f = {(is_diffuse ? diffuse.x : 0.0f) + (is_glossy ? gloss.x : 0.0f),
              (is_diffuse ? diffuse.y : 0.0f) + (is_glossy ? gloss.y : 0.0f),
              (is_diffuse ? diffuse.z : 0.0f) + (is_glossy ? gloss.z : 0.0f)};
  density = (is_diffuse ? diffuse_share * cosine * (1.0f / kPi) : 0.0f) + (is_glossy ? gloss_share * of_gloss : 0.0f);
}

LIPPMANN_MULTIVERSION void MetalRoughLanes::evaluate_lambert(const Lanes3& lights, BsdfValueLanes& values) const {
  LIPPMANN_FOR_LANES(i) {
    const float cosine = glm::dot(lights.get(i), normal_.get(i));
    const bool is_lit = (cosine > 0.0f) & (diffuse_share_[i] > 0.0f);
    const float density = is_lit ? cosine * (1.0f / kPi) : 0.0f;
    values.cosine_f.set(i, diffuse_color_.get(i) * density);
    values.density[i] = density;
  }
}

LIPPMANN_MULTIVERSION void MetalRoughLanes::evaluate_gloss(const GgxAlbedo& albedo, const Lanes3& lights,
                                                           BsdfValueLanes& values) const {
  LIPPMANN_FOR_LANES(i) {
    Vec3f cosine_f;
    float density;
    evaluate(i, albedo, lights.get(i), cosine_f, density);
    values.cosine_f.set(i, cosine_f);
    values.density[i] = density;
  }
}

LIPPMANN_MULTIVERSION void MetalRoughLanes::sample_lambert(const Lanes& lobe, const Lanes& u, const Lanes& v,
                                                           BsdfSampleLanes& samples) const {
  LIPPMANN_FOR_LANES(i) {
    const Vec3f normal = normal_.get(i), direction = Frame(normal).to_world(sample_cosine({u[i], v[i]}));
    const float cosine = glm::dot(direction, normal);
    const bool is_any = (cosine > 0.0f) & (lobe[i] < diffuse_share_[i]);
    const float density = is_any ? cosine * (1.0f / kPi) : 0.0f;
    samples.direction.set(i, direction);
    samples.density[i] = density;
    samples.weight.set(i, diffuse_color_.get(i) * density / (density > 0.0f ? density : 1.0f));
  }
}

LIPPMANN_MULTIVERSION void MetalRoughLanes::sample_gloss(const GgxAlbedo& albedo, const Lanes& lobe, const Lanes& u,
                                                         const Lanes& v, BsdfSampleLanes& samples) const {
  LIPPMANN_FOR_LANES(i) {
    const MetalRoughBase b = base(i);
    const float diffuse_share = diffuse_share_[i], gloss_share = gloss_share_[i];
    const Vec3f scattered = Frame(normal_.get(i)).to_world(sample_cosine({u[i], v[i]}));
    const Vec3f mirrored = draw_gloss(b, {u[i], v[i]}), gloss = Frame(gloss_normal_.get(i)).to_world(mirrored);
    const bool is_diffuse = lobe[i] < diffuse_share, is_glossy = !is_diffuse & (lobe[i] < diffuse_share + gloss_share);
    const Vec3f direction(is_diffuse ? scattered.x : gloss.x, is_diffuse ? scattered.y : gloss.y,
                          is_diffuse ? scattered.z : gloss.z);
    const bool is_any = is_diffuse | (is_glossy & (mirrored.z > 0.0f)), is_delta = is_glossy & b.is_smooth();
    Vec3f cosine_f;
    float density;
    evaluate(i, albedo, direction, cosine_f, density);
    samples.direction.set(i, direction);
    samples.density[i] = is_any ? is_delta ? kInfinity : density : 0.0f;
    const float per_density = density > 0.0f ? density : 1.0f, per_share = gloss_share > 0.0f ? gloss_share : 1.0f;
    samples.weight.set(i, {is_delta ? b.gloss_albedo.x / per_share : cosine_f.x / per_density,
                           is_delta ? b.gloss_albedo.y / per_share : cosine_f.y / per_density,
                           is_delta ? b.gloss_albedo.z / per_share : cosine_f.z / per_density});
  }
}

// After the kernels: a function that was called cannot become several by instruction set.

void MetalRoughLanes::prepare(const GgxAlbedo& albedo) {
  if (any_gloss_)
    prepare_gloss(albedo);
  else
    prepare_lambert();
}

void MetalRoughLanes::evaluate(const GgxAlbedo& albedo, const Lanes3& lights, BsdfValueLanes& values) const {
  if (any_gloss_)
    evaluate_gloss(albedo, lights, values);
  else
    evaluate_lambert(lights, values);
}

void MetalRoughLanes::sample(const GgxAlbedo& albedo, const Lanes& lobe, const Lanes& u, const Lanes& v,
                             BsdfSampleLanes& samples) const {
  if (any_gloss_)
    sample_gloss(albedo, lobe, u, v, samples);
  else
    sample_lambert(lobe, u, v, samples);
}

void MetalRoughLanes::remove_diffuse() {
  LIPPMANN_FOR_LANES(i) {
    diffuse_share_[i] = 0.0f;
    gloss_share_[i] = gloss_share_[i] > 0.0f ? 1.0f : 0.0f;
  }
  diffuse_color_ = {};
}

BsdfValue MetalRoughLanes::evaluate_diffuse(int i, const GgxAlbedo& albedo, Vec3f light) const {
  const float cosine = glm::dot(light, normal_.get(i));
  if (!(cosine > 0.0f)) return {Vec3f(0.0f), 0.0f, true};
  const float density = cosine * (1.0f / kPi);
  return {density * let_in(base(i), albedo, cosine) / diffuse_passes_.get(i), density, false};
}

}  // namespace lippmann
