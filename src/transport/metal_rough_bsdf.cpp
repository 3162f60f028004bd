#include "transport/metal_rough_bsdf.hpp"

#include "transport/microfacet.hpp"

namespace lippmann {
namespace {

constexpr float kCoatF0 = 0.04f;
constexpr float kLeastCosine = 1e-4f;
constexpr Vec3f kUp(0.0f, 0.0f, 1.0f);

bool smooth(float alpha) { return alpha < kSmoothAlpha; }

Vec3f lift(Vec3f local) {  // grazing views have no digits left for masking
  if (local.z >= kLeastCosine) return local;
  local.z = kLeastCosine;
  return glm::normalize(local);
}

/// Draws a mirrored direction: from a rough lobe, whose weight and density are left open, or Dirac's lobe with its weight where
/// it is smooth. view: local to `frame`. False where the direction is below the surface, which absorbs it.
bool sample_mirror(const Frame& frame, Vec3f view, float alpha, Vec3f smooth_weight, Vec2f u, BsdfSample& s) {
  const Vec3f light = mirrored(view, smooth(alpha) ? kUp : Ggx{alpha}.sample_visible(view, u));
  if (!(light.z > 0.0f)) return false;
  s.direction = frame.to_world(light);
  if (smooth(alpha)) s.density = kInfinity, s.weight = smooth_weight;
  return true;
}

Vec3f half_vector(Vec3f a, Vec3f b) { return glm::normalize(a + b); }

}  // namespace

MetalRoughBsdf::MetalRoughBsdf(const MetalRoughSurface& s, const GgxAlbedo& albedo, const Normals& normals, Vec3f view,
                               bool entering)
    : albedo_(albedo),
      frame_(normals.diffuse),
      gloss_frame_(frame_),
      glossy_apart_(normals.gloss != normals.diffuse),
      view_(0.0f),
      alpha_(squared(s.roughness)),
      coat_alpha_(squared(s.clearcoat_roughness)),
      eta_(entering ? s.ior : 1.0f / s.ior) {
  if (glossy_apart_) gloss_frame_ = Frame(normals.gloss);
  view_ = lift(gloss_frame_.to_local(view));
  const float dielectric = (1.0f - s.metallic) * (1.0f - s.transmission);
  glass_share_ = (1.0f - s.metallic) * s.transmission;
  glass_ = s.base_color;
  if (glass_share_ > 0.0f && !smooth(alpha_)) glass_compensation_ = 1.0f / albedo.glass().single(view_.z, alpha_, eta_);
  dielectric_f0_ = glm::min(normal_reflectance(s.ior) * s.specular_color, Vec3f(1.0f)) * s.specular;
  dielectric_f90_ = Vec3f(s.specular);
  gloss_f0_ = dielectric * dielectric_f0_ + s.metallic * s.base_color;
  gloss_f90_ = dielectric * dielectric_f90_ + Vec3f(s.metallic);

  if (s.specular > 0.0f || s.metallic > 0.0f)
    set_gloss(s, dielectric);
  else
    diffuse_color_ = dielectric * s.base_color;
  if (s.clearcoat > 0.0f) {
    coat_frame_ = Frame(normals.coat);
    coat_view_ = lift(coat_frame_.to_local(view));
    set_coat(s);
  }
  set_shares(dielectric * s.base_color);
}

void MetalRoughBsdf::set_gloss(const MetalRoughSurface& s, float dielectric) {
  // Each part's own compensation: of the dielectric and of the metal. Their sum is carried by one lobe; its factor is the
  // mean, weighted by what they send.
  const Vec3f single = single_albedo(view_.z, alpha_);
  if (dielectric > 0.0f) {
    dielectric_albedo_ = GgxAlbedo::directional(single, dielectric_f0_, dielectric_f90_);
    gloss_albedo_ = dielectric * dielectric_albedo_;
  }
  if (s.metallic > 0.0f) gloss_albedo_ += s.metallic * GgxAlbedo::directional(single, s.base_color, Vec3f(1.0f));
  const Vec3f uncompensated = gloss_f0_ * single.x + gloss_f90_ * single.y;
  for (int c = 0; c < 3; ++c) gloss_compensation_[c] = uncompensated[c] > 0.0f ? gloss_albedo_[c] / uncompensated[c] : 1.0f;
  if (!(dielectric > 0.0f)) return;

  const Vec3f mean = smooth(alpha_) ? dielectric_f0_ * (20.0f / 21.0f) + dielectric_f90_ / 21.0f
                                    : albedo_.mean(alpha_, dielectric_f0_, dielectric_f90_);
  diffuse_passes_ = glm::max(Vec3f(1.0f) - mean, Vec3f(1e-3f));
  diffuse_color_ = dielectric * s.base_color * (Vec3f(1.0f) - dielectric_albedo_) / diffuse_passes_;
}

void MetalRoughBsdf::set_coat(const MetalRoughSurface& s) {
  coat_ = s.clearcoat;
  const Vec3f single = single_albedo(coat_view_.z, coat_alpha_);
  below_coat_ = 1.0f - coat_ * GgxAlbedo::directional(single, Vec3f(kCoatF0), Vec3f(1.0f)).x;
}

Vec3f MetalRoughBsdf::single_albedo(float cosine, float alpha) const {
  if (!smooth(alpha)) return albedo_.single(cosine, alpha);
  const float edge = schlick_weight(cosine);
  return {1.0f - edge, edge, 0.0f};
}

/// diffuse: the albedo of the diffuse part without anything above it.
void MetalRoughBsdf::set_shares(Vec3f diffuse) {
  shares_.coat = 1.0f - below_coat_;
  shares_.gloss = below_coat_ * luminance(gloss_albedo_);
  shares_.diffuse = below_coat_ * luminance(diffuse * (Vec3f(1.0f) - dielectric_albedo_));
  shares_.glass = below_coat_ * glass_share_ * std::max(0.1f, luminance(glass_));
  scale_shares();
}

void MetalRoughBsdf::scale_shares() {
  const float sum = shares_.coat + shares_.gloss + shares_.diffuse + shares_.glass;
  if (sum > 0.0f) shares_.coat /= sum, shares_.gloss /= sum, shares_.diffuse /= sum, shares_.glass /= sum;
}

/// Kelemen and Szirmay-Kalos: what the gloss lets in on the way from the light and out on the way to the viewer (the latter,
/// and the normalisation, are in diffuse_color_).
Vec3f MetalRoughBsdf::diffuse_f(Vec3f light) const {
  if (dielectric_f90_ == Vec3f(0.0f)) return diffuse_color_ * (1.0f / kPi);
  const Vec3f single = single_albedo(light.z, alpha_);
  return diffuse_color_ * (Vec3f(1.0f) - GgxAlbedo::directional(single, dielectric_f0_, dielectric_f90_)) * (1.0f / kPi);
}

BsdfValue MetalRoughBsdf::evaluate_diffuse(Vec3f light_world) const {
  const Vec3f light = frame_.to_local(light_world);
  if (!(light.z > 0.0f)) return {Vec3f(0.0f), 0.0f, true};
  const float cosine = light.z * (1.0f / kPi);
  if (dielectric_f90_ == Vec3f(0.0f)) return {Vec3f(cosine), cosine, false};
  const Vec3f reflected = GgxAlbedo::directional(single_albedo(light.z, alpha_), dielectric_f0_, dielectric_f90_);
  return {cosine * (Vec3f(1.0f) - reflected) / diffuse_passes_, cosine, false};
}

bool MetalRoughBsdf::is_sharp() const {
  return (smooth(alpha_) || (shares_.gloss == 0.0f && shares_.glass == 0.0f)) && (smooth(coat_alpha_) || coat_ == 0.0f);
}

bool MetalRoughBsdf::has_coat_apart() const { return coat_ > 0.0f && !smooth(coat_alpha_) && coat_frame_.z != frame_.z; }

void MetalRoughBsdf::remove_diffuse() {
  diffuse_color_ = Vec3f(0.0f);
  shares_.diffuse = 0.0f;
  scale_shares();
}

/// The density is Ggx::visible_density's, of whose parts the value has most.
void MetalRoughBsdf::add_gloss(Vec3f light, BsdfValue& value) const {
  const Ggx ggx{alpha_};
  const Vec3f h = half_vector(view_, light);
  const float cosine = glm::dot(view_, h), facets = ggx.distribution(h), hidden = ggx.lambda(view_);
  const Vec3f fresnel = gloss_f0_ + (gloss_f90_ - gloss_f0_) * schlick_weight(cosine);
  const float seen_from_both = 1.0f / (1.0f + hidden + ggx.lambda(light)), seen = 1.0f / (1.0f + hidden);
  const Vec3f f = fresnel * gloss_compensation_ * (facets * seen_from_both / (4.0f * view_.z * light.z));
  value.cosine_f += below_coat_ * light.z * f;
  value.density += shares_.gloss * (seen * std::max(0.0f, cosine) * facets / view_.z / (4.0f * cosine));
}

void MetalRoughBsdf::add_glass(Vec3f light, BsdfValue& value) const {
  const Ggx ggx{alpha_};
  const bool reflected = light.z > 0.0f;
  // The facet's normal, towards the viewer. Refraction's half vector is along -(view + eta light).
  Vec3f h = glm::normalize(reflected ? view_ + light : view_ + eta_ * light);
  if (h.z < 0.0f) h = -h;
  const float cosine = glm::dot(view_, h), beyond = glm::dot(light, h);
  if (!(cosine > 0.0f)) return;
  const float fresnel = fresnel_dielectric(cosine, eta_);
  const float visible = ggx.visible_density(view_, h);
  float density, masked;
  if (reflected) {
    density = fresnel * visible / (4.0f * cosine);
    masked = ggx.masking(view_, light) / ggx.masking(view_);
  } else {
    if (!(beyond < 0.0f)) return;
    density = (1.0f - fresnel) * visible * squared(eta_) * -beyond / squared(cosine + eta_ * beyond);
    masked = ggx.masking(light);
  }
  value.cosine_f += below_coat_ * glass_share_ * (reflected ? Vec3f(1.0f) : glass_) * (density * masked * glass_compensation_);
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
  const Vec3f local = frame_.to_local(light_world), light = local_to_gloss(light_world, local);
  BsdfValue value;
  value.transmitted = scatters_through() && local.z < 0.0f && light.z < 0.0f;
  if (local.z > 0.0f && shares_.diffuse > 0.0f) {
    value.cosine_f = below_coat_ * local.z * diffuse_f(local);
    value.density = shares_.diffuse * local.z * (1.0f / kPi);
  }
  if (light.z > 0.0f && shares_.gloss > 0.0f && !smooth(alpha_)) add_gloss(light, value);
  if (glass_share_ > 0.0f && !smooth(alpha_) && light.z != 0.0f) add_glass(light, value);
  if (coat_ > 0.0f && !smooth(coat_alpha_)) add_coat(coat_frame_.to_local(light_world), value);
  return value;
}

/// Reflects with Fresnel's probability, else refracts, at the surface or at a facet. decision in [0, 1).
bool MetalRoughBsdf::sample_glass(float decision, Vec2f u, BsdfSample& s) const {
  const Vec3f facet = smooth(alpha_) ? kUp : Ggx{alpha_}.sample_visible(view_, u);
  const float fresnel = fresnel_dielectric(glm::dot(view_, facet), eta_);
  s.transmitted = !(decision < fresnel);
  const Vec3f light = s.transmitted ? refracted_away(view_, facet, eta_) : mirrored(view_, facet);
  if (light.z == 0.0f || (light.z < 0.0f) != s.transmitted) return false;
  s.direction = frame_.to_world(light);
  if (smooth(alpha_)) {
    s.density = kInfinity;
    s.weight = (below_coat_ * glass_share_ / shares_.glass) * (s.transmitted ? glass_ : Vec3f(1.0f));
  }
  return true;
}

/// A direction; weight and density left open but of Dirac's lobes. False where the surface takes all.
bool MetalRoughBsdf::draw(float lobe, Vec2f u, BsdfSample& s) const {
  const float below_gloss = shares_.diffuse, below_glass = below_gloss + shares_.gloss,
              below_coat = below_glass + shares_.glass;
  if (lobe < below_gloss) {
    s.direction = frame_.to_world(sample_cosine(u));
    return true;
  }
  if (lobe < below_glass) return sample_mirror(gloss_frame_, view_, alpha_, below_coat_ * gloss_albedo_ / shares_.gloss, u, s);
  if (lobe < below_coat) return sample_glass((lobe - below_glass) / shares_.glass, u, s);
  return shares_.coat > 0.0f &&
         sample_mirror(coat_frame_, coat_view_, coat_alpha_, Vec3f((1.0f - below_coat_) / shares_.coat), u, s);
}

std::optional<BsdfSample> MetalRoughBsdf::sample(float lobe, Vec2f u) const {
  std::optional<BsdfSample> s(std::in_place);  // made where it goes: copies of what has just been written wait for it
  if (!draw(lobe, u, *s)) {
    s.reset();
  } else if (!s->is_delta()) {
    weigh(*s);
    if (!(s->density > 0.0f)) s.reset();
  }
  return s;
}

void MetalRoughBsdf::weigh(BsdfSample& s) const {
  if (shares_.diffuse == 1.0f && dielectric_f90_ == Vec3f(0.0f)) {  // Lambert's law alone
    s.weight = diffuse_color_;
    s.density = glm::dot(s.direction, frame_.z) * (1.0f / kPi);
    return;
  }
  const BsdfValue value = evaluate(s.direction);
  s.weight = value.cosine_f / value.density;
  s.density = value.density;
}

}  // namespace lippmann
