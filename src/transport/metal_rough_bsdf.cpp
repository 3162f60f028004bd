#include "transport/metal_rough_bsdf.hpp"

#include "transport/microfacet.hpp"

namespace lippmann {
namespace {

constexpr float kCoatF0 = 0.04f;
constexpr Vec3f kUp(0.0f, 0.0f, 1.0f);

bool smooth(float alpha) { return alpha < kSmoothAlpha; }

Vec3f half_vector(Vec3f a, Vec3f b) { return glm::normalize(a + b); }

}  // namespace

MetalRoughBsdf::MetalRoughBsdf(const MetalRoughSurface& s, const GgxAlbedo& albedo, const Normals& normals, Vec3f view,
                               bool entering)
    : albedo_(albedo),
      basis_(normals.diffuse),
      gloss_basis_(basis_),
      glossy_apart_(normals.gloss != normals.diffuse),
      coat_alpha_(squared(s.clearcoat_roughness)),
      glass_{s.base_color, (1.0f - s.metallic) * s.transmission, entering ? s.ior : 1.0f / s.ior} {
  if (glossy_apart_) gloss_basis_ = Basis(normals.gloss);
  base_ = metal_rough_base(s, albedo, lifted_view(gloss_basis_.to_local(view)));
  if (glass_.share > 0.0f && !base_.is_smooth())
    glass_.compensation = 1.0f / albedo.glass().single(base_.view.z, base_.alpha, glass_.eta);
  if (s.clearcoat > 0.0f) {
    coat_basis_ = Basis(normals.coat);
    coat_view_ = lifted_view(coat_basis_.to_local(view));
    set_coat(s);
  }
  set_shares();
}

void MetalRoughBsdf::set_coat(const MetalRoughSurface& s) {
  coat_ = s.clearcoat;
  const Vec3f single = single_albedo(albedo_, coat_view_.z, coat_alpha_);
  below_coat_ = 1.0f - coat_ * GgxAlbedo::directional(single, Vec3f(kCoatF0), Vec3f(1.0f)).x;
}

void MetalRoughBsdf::set_shares() {
  shares_.coat = 1.0f - below_coat_;
  shares_.gloss = below_coat_ * base_.gloss_luminance;
  shares_.diffuse = below_coat_ * base_.diffuse_luminance;
  shares_.glass = below_coat_ * glass_chance(glass_);
  const float sum = shares_.coat + shares_.gloss + shares_.diffuse + shares_.glass;
  if (sum > 0.0f) shares_.coat /= sum, shares_.gloss /= sum, shares_.diffuse /= sum, shares_.glass /= sum;
}

Vec3f MetalRoughBsdf::evaluate_diffuse(Vec3f light_world) const {
  const float cosine = glm::dot(light_world, basis_.z);
  if (!(cosine > 0.0f)) return Vec3f(0.0f);
  return cosine * (1.0f / kPi) * let_in(base_, albedo_, cosine) / base_.diffuse_passes;
}

bool MetalRoughBsdf::has_coat_apart() const { return coat_ > 0.0f && !smooth(coat_alpha_) && coat_basis_.z != basis_.z; }

void MetalRoughBsdf::add_gloss(Vec3f light, BsdfValue& value) const {
  float density;
  const Vec3f f = gloss_cosine_f(base_, light, density);
  value.cosine_f += below_coat_ * f;
  value.density += shares_.gloss * density;
}

void MetalRoughBsdf::add_glass(Vec3f light, BsdfValue& value) const {
  float density;
  const Vec3f f = glass_cosine_f(glass_, base_.alpha, base_.view, light, density);
  value.cosine_f += below_coat_ * f;
  value.density += shares_.glass * density;
}

void MetalRoughBsdf::add_coat(Vec3f light, BsdfValue& value) const {
  if (!(light.z > 0.0f)) return;
  const Ggx ggx{coat_alpha_};
  const Vec3f h = half_vector(coat_view_, light);
  const float cosine = glm::dot(coat_view_, h), edge = schlick_weight(cosine);
  const float fresnel = kCoatF0 + (1.0f - kCoatF0) * edge;
  const Vec3f factor = GgxAlbedo::compensation(albedo_.single(coat_view_.z, coat_alpha_), Vec3f(kCoatF0), Vec3f(1.0f));
  value.cosine_f += factor * (coat_ * fresnel * ggx.distribution(h) * ggx.masking(coat_view_, light) / (4.0f * coat_view_.z));
  value.density += shares_.coat * ggx.visible_density(coat_view_, h) / (4.0f * cosine);
}

BsdfValue MetalRoughBsdf::evaluate(Vec3f light_world) const {
  const Vec3f local = basis_.to_local(light_world), light = local_to_gloss(light_world, local);
  BsdfValue value;
  value.transmitted = scatters_through() && local.z < 0.0f && light.z < 0.0f;
  if (local.z > 0.0f && shares_.diffuse > 0.0f) {
    value.cosine_f = below_coat_ * diffuse_cosine_f(base_, albedo_, local.z);
    value.density = shares_.diffuse * local.z * (1.0f / kPi);
  }
  if (light.z > 0.0f && shares_.gloss > 0.0f && !base_.is_smooth()) add_gloss(light, value);
  if (shares_.glass > 0.0f && !base_.is_smooth()) add_glass(light, value);
  if (coat_ > 0.0f && !smooth(coat_alpha_)) add_coat(coat_basis_.to_local(light_world), value);
  return value;
}

bool MetalRoughBsdf::sample_glass(float decision, Vec2f u, BsdfSample& s) const {
  float outward;
  const Vec3f light = draw_glass(glass_.eta, base_.view, draw_facet(base_, u), decision, s.transmitted, outward);
  s.direction = gloss_basis_.to_world(light);
  if (base_.is_smooth()) {
    s.density = kInfinity;
    s.weight = (below_coat_ * glass_.share / shares_.glass) * (s.transmitted ? glass_.tint : Vec3f(1.0f));
  }
  return outward > 0.0f;
}

/// Samples a direction. Sets weight and density only for Dirac lobes. Returns false if no light arrives from the direction.
bool MetalRoughBsdf::draw(float lobe, Vec2f u, BsdfSample& s) const {
  const float below_gloss = shares_.diffuse, below_glass = below_gloss + shares_.gloss,
              below_coat = below_glass + shares_.glass;
  if (lobe < below_gloss) {
    s.direction = basis_.to_world(sample_cosine(u));
    return true;
  }
  if (lobe < below_glass) {
    const Vec3f light = mirrored(base_.view, draw_facet(base_, u));
    s.direction = gloss_basis_.to_world(light);
    if (base_.is_smooth()) s.density = kInfinity, s.weight = below_coat_ * base_.gloss_albedo / shares_.gloss;
    return light.z > 0.0f;
  }
  if (lobe < below_coat) return sample_glass((lobe - below_glass) / shares_.glass, u, s);
  return shares_.coat > 0.0f && draw_coat(u, s);
}

bool MetalRoughBsdf::draw_coat(Vec2f u, BsdfSample& s) const {
  const bool is_smooth = smooth(coat_alpha_);
  const Vec3f light = mirrored(coat_view_, is_smooth ? kUp : Ggx{coat_alpha_}.sample_visible(coat_view_, u));
  s.direction = coat_basis_.to_world(light);
  if (is_smooth) s.density = kInfinity, s.weight = Vec3f((1.0f - below_coat_) / shares_.coat);
  return light.z > 0.0f;
}

std::optional<BsdfSample> MetalRoughBsdf::sample(float lobe, Vec2f u) const {
  // Construct in place: copying a struct that was just written would stall on store forwarding.
  std::optional<BsdfSample> s(std::in_place);
  if (!draw(lobe, u, *s)) {
    s.reset();
  } else if (!s->is_delta()) {
    weigh(*s);
    if (!(s->density > 0.0f)) s.reset();
  }
  return s;
}

void MetalRoughBsdf::weigh(BsdfSample& s) const {
  const BsdfValue value = evaluate(s.direction);
  s.weight = value.cosine_f / value.density;
  s.density = value.density;
}

}  // namespace lippmann
