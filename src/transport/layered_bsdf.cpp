#include "transport/layered_bsdf.hpp"

namespace lippmann {
namespace {

constexpr float kCoatReflectance = 0.04f;
constexpr float kLeastCosineOfView = 1e-4f;
constexpr Vec3f kAbove(0.0f, 0.0f, 1.0f);

bool is_mirror(float alpha) { return alpha < kSmoothAlpha; }

Vec3f lifted(Vec3f local) {
  if (local.z >= kLeastCosineOfView) return local;
  local.z = kLeastCosineOfView;
  return glm::normalize(local);
}

/// Returns a basis with z along `normal`, and with x along the tangent, unless the tangent is parallel to the normal.
Basis basis_along(Vec3f normal, Vec3f tangent) {
  Basis basis(normal);
  const Vec3f across = tangent - normal * glm::dot(normal, tangent);
  const float length = glm::length(across);
  if (!(length > 1e-6f * glm::length(tangent))) return basis;
  basis.x = across / length;
  basis.y = glm::cross(normal, basis.x);
  return basis;
}

AnisotropicGgx facets_of(const LayeredSurface& s) {
  const float across = squared(s.base.roughness), along = glm::mix(across, 1.0f, squared(s.anisotropy));
  return {glm::max(Vec2f(along, across), Vec2f(kSmoothAlpha))};
}

Vec3f flipped(Vec3f v) { return {v.x, v.y, -v.z}; }
Vec3f above(Vec3f v) { return {v.x, v.y, std::abs(v.z)}; }
float most(Vec3f v) { return std::max({v.x, v.y, v.z}); }

}  // namespace

LayeredBsdf::LayeredBsdf(const LayeredSurface& s, const GgxAlbedo& albedo, const MetalRoughBsdf::Normals& normals,
                         Vec3f tangent, Vec3f view, bool entering)
    : surface_(s),
      albedo_(albedo),
      ahead_(-view),
      basis_(s.anisotropy > 0.0f ? basis_along(normals.diffuse, tangent) : Basis(normals.diffuse)),
      gloss_basis_(basis_),
      glossy_apart_(normals.gloss != normals.diffuse),
      is_smooth_(s.anisotropy == 0.0f && is_mirror(squared(s.base.roughness))),
      ggx_(facets_of(s)),
      coat_alpha_(squared(s.base.clearcoat_roughness)),
      eta_(entering || s.is_thin ? s.base.ior : 1.0f / s.base.ior),
      matt_((1.0f - s.base.metallic) * (1.0f - s.base.transmission)),
      glass_share_((1.0f - s.base.metallic) * s.base.transmission),
      dielectric_f0_(glm::min(normal_reflectance(s.base.ior) * s.base.specular_color, Vec3f(1.0f)) * s.base.specular),
      dielectric_f90_(s.base.specular),
      diffuse_color_(matt_ * (1.0f - s.diffuse_transmission) * s.base.base_color),
      through_color_(matt_ * s.diffuse_transmission * s.diffuse_transmission_color),
      most_sheen_(most(s.sheen_color)) {
  if (glossy_apart_) gloss_basis_ = s.anisotropy > 0.0f ? basis_along(normals.gloss, tangent) : Basis(normals.gloss);
  view_ = lifted(gloss_basis_.to_local(view));
  set_gloss();
  if (glass_share_ > 0.0f && !is_smooth_) {
    const Vec3f single = single_albedo(view_);
    glass_compensation_ =
        1.0f / (s.is_thin ? single.x + single.y : albedo_.glass().single(view_.z, ggx_.alpha_towards(view_), eta_));
  }
  if (most_sheen_ > 0.0f) sheen_passes_ = passes_sheen(view_.z);
  if (s.base.clearcoat > 0.0f) {
    coat_basis_ = Basis(normals.coat);
    coat_view_ = lifted(coat_basis_.to_local(view));
    set_coat();
  }
  set_shares();
}

Vec3f LayeredBsdf::single_albedo(Vec3f direction) const {
  if (surface_.anisotropy > 0.0f)
    return {albedo_.brushed().single(direction, squared(surface_.base.roughness), surface_.anisotropy),
            GgxAlbedo::edge_of_later_facets(direction.z, ggx_.alpha_towards(direction))};
  if (!is_smooth_) return albedo_.single(direction.z, ggx_.alpha.x);
  const float edge = schlick_weight(direction.z);
  return {1.0f - edge, edge, 0.0f};
}

Vec3f LayeredBsdf::fresnel_of(Vec3f f0, Vec3f f90, float cosine) const {
  const Vec3f bare = f0 + (f90 - f0) * schlick_weight(cosine);
  if (surface_.film_share == 0.0f) return bare;
  return glm::mix(bare, film_reflectance(surface_.film, f0, cosine), surface_.film_share);
}

/// A thin film's reflectance depends too irregularly on the angle for a table. This function uses the film's reflectance for
/// `direction` at all angles.
Vec3f LayeredBsdf::albedo_of(Vec3f f0, Vec3f f90, Vec3f direction) const {
  const Vec3f single = single_albedo(direction);
  const Vec3f bare = GgxAlbedo::directional(single, f0, f90);
  if (surface_.film_share == 0.0f) return bare;
  const Vec3f film = film_reflectance(surface_.film, f0, direction.z);
  return glm::mix(bare, GgxAlbedo::directional(single, film, film), surface_.film_share);
}

void LayeredBsdf::set_gloss() {
  const MetalRoughSurface& s = surface_.base;
  const Vec3f single = single_albedo(view_);
  gloss_albedo_ =
      matt_ * albedo_of(dielectric_f0_, dielectric_f90_, view_) + s.metallic * albedo_of(s.base_color, Vec3f(1.0f), view_);
  Vec3f f0 = matt_ * dielectric_f0_ + s.metallic * s.base_color, f90 = matt_ * dielectric_f90_ + Vec3f(s.metallic);
  Vec3f once = f0 * single.x + f90 * single.y;
  if (surface_.film_share > 0.0f) {
    const Vec3f film = matt_ * film_reflectance(surface_.film, dielectric_f0_, view_.z) +
                       s.metallic * film_reflectance(surface_.film, s.base_color, view_.z);
    once = glm::mix(once, film * (single.x + single.y), surface_.film_share);
  }
  for (int c = 0; c < 3; ++c) gloss_compensation_[c] = once[c] > 0.0f ? gloss_albedo_[c] / once[c] : 1.0f;
  if (matt_ == 0.0f) return;
  gloss_passes_ = passes_gloss(view_);
  const Vec3f mean = is_smooth_ ? dielectric_f0_ * (20.0f / 21.0f) + dielectric_f90_ / 21.0f
                                : albedo_.mean(std::sqrt(ggx_.alpha.x * ggx_.alpha.y), dielectric_f0_, dielectric_f90_);
  diffuse_passes_ = glm::max(Vec3f(1.0f) - mean, Vec3f(1e-3f));
}

void LayeredBsdf::set_coat() {
  const float edge = schlick_weight(coat_view_.z);
  const Vec3f single = is_mirror(coat_alpha_) ? Vec3f(1.0f - edge, edge, 0.0f) : albedo_.single(coat_view_.z, coat_alpha_);
  below_coat_ = 1.0f - surface_.base.clearcoat * GgxAlbedo::directional(single, Vec3f(kCoatReflectance), Vec3f(1.0f)).x;
}

/// Returns the fraction of light that passes the gloss along `direction`. Below a thin film, the fraction is grey, so that the
/// film does not colour the layers below.
Vec3f LayeredBsdf::passes_gloss(Vec3f direction) const {
  const Vec3f reflected = albedo_of(dielectric_f0_, dielectric_f90_, direction);
  if (surface_.film_share == 0.0f) return Vec3f(1.0f) - reflected;
  return Vec3f(std::max(0.0f, 1.0f - most(reflected)));
}

/// Returns the factor by which the gloss scales diffuse light from the direction `light`, which is on the viewer's side.
Vec3f LayeredBsdf::below_gloss(Vec3f light) const {
  const Vec3f in = passes_gloss(light);
  return surface_.film_share == 0.0f ? in * gloss_passes_ / diffuse_passes_ : glm::min(in, gloss_passes_);
}

float LayeredBsdf::passes_sheen(float cosine) const {
  return std::max(0.0f, 1.0f - most_sheen_ * albedo_.sheen()(cosine, surface_.sheen_roughness));
}

float LayeredBsdf::below_sheen(Vec3f light) const {
  return most_sheen_ > 0.0f ? std::min(sheen_passes_, passes_sheen(std::abs(light.z))) : 1.0f;
}

LayeredBsdf::GlassFacet LayeredBsdf::glass_facet(float cosine) const {
  const float bare = fresnel_dielectric(cosine, eta_);
  if (surface_.film_share == 0.0f || bare >= 1.0f) return {Vec3f(bare), (1.0f - bare) * surface_.base.base_color, bare};
  const Vec3f film = film_reflectance(surface_.film, Vec3f(normal_reflectance(surface_.base.ior)), cosine);
  const Vec3f reflected = glm::mix(Vec3f(bare), film, surface_.film_share);
  return {reflected, (1.0f - most(reflected)) * surface_.base.base_color, luminance(reflected)};
}

void LayeredBsdf::set_shares() {
  const float below = below_coat_ * sheen_passes_;
  shares_.coat = 1.0f - below_coat_;
  shares_.sheen = most_sheen_ > 0.0f ? below_coat_ * (1.0f - sheen_passes_) : 0.0f;
  shares_.gloss = below * luminance(gloss_albedo_);
  shares_.diffuse = below * luminance(diffuse_color_ * gloss_passes_);
  shares_.through = below * luminance(through_color_ * gloss_passes_);
  shares_.glass = below * glass_share_ * std::max(0.1f, luminance(surface_.base.base_color));
  Shares& s = shares_;
  const float sum = s.diffuse + s.through + s.sheen + s.gloss + s.glass + s.coat;
  if (!(sum > 0.0f)) return;
  for (float* share : {&s.diffuse, &s.through, &s.sheen, &s.gloss, &s.glass, &s.coat}) *share /= sum;
}

Vec3f LayeredBsdf::evaluate_diffuse(Vec3f light_world) const {
  const Vec3f light = basis_.to_local(light_world);
  if (!(light.z > 0.0f)) return Vec3f(0.0f);
  const Vec3f to_viewer = sheen_passes_ * gloss_passes_, both = below_sheen(light) * below_gloss(light);
  const float cosine = light.z * (1.0f / kPi);
  Vec3f share(0.0f);
  for (int c = 0; c < 3; ++c)
    if (to_viewer[c] > 0.0f) share[c] = both[c] / to_viewer[c];
  return cosine * share;
}

bool LayeredBsdf::has_coat_apart() const {
  return surface_.base.clearcoat > 0.0f && !is_mirror(coat_alpha_) && coat_basis_.z != basis_.z;
}

void LayeredBsdf::add_diffuse(Vec3f light, BsdfValue& value) const {
  const bool reflected = light.z > 0.0f;
  const Vec3f color = reflected ? diffuse_color_ : through_color_;
  const float cosine = std::abs(light.z) * (1.0f / kPi);
  if (color == Vec3f(0.0f)) return;
  value.cosine_f += cosine * color * below_gloss(above(light));
  value.density += (reflected ? shares_.diffuse : shares_.through) * cosine;
}

void LayeredBsdf::add_gloss(Vec3f light, BsdfValue& value) const {
  const Vec3f h = glm::normalize(view_ + light);
  const float cosine = glm::dot(view_, h);
  Vec3f fresnel(0.0f);
  if (matt_ > 0.0f) fresnel += matt_ * fresnel_of(dielectric_f0_, dielectric_f90_, cosine);
  if (surface_.base.metallic > 0.0f)
    fresnel += surface_.base.metallic * fresnel_of(surface_.base.base_color, Vec3f(1.0f), cosine);
  value.cosine_f += fresnel * gloss_compensation_ * (ggx_.distribution(h) * ggx_.masking(view_, light) / (4.0f * view_.z));
  value.density += shares_.gloss * ggx_.visible_density(view_, h) / (4.0f * cosine);
}

/// Adds the reflected or transmitted light of rough glass. The transmitted lobe of a thin wall is the reflected lobe, mirrored
/// to the other side of the wall.
void LayeredBsdf::add_glass(Vec3f light, BsdfValue& value) const {
  const bool reflected = light.z > 0.0f, bends = !reflected && !surface_.is_thin;
  Vec3f h = glm::normalize(bends ? view_ + eta_ * light : view_ + above(light));
  if (h.z < 0.0f) h = -h;
  const float cosine = glm::dot(view_, h), beyond = glm::dot(light, h);
  if (!(cosine > 0.0f) || (bends && !(beyond < 0.0f))) return;
  const GlassFacet facet = glass_facet(cosine);
  float density = ggx_.visible_density(view_, h), masked;
  if (bends) {
    density *= squared(eta_) * -beyond / squared(cosine + eta_ * beyond);
    masked = ggx_.masking(light);
  } else {
    density /= 4.0f * cosine;
    masked = ggx_.masking(view_, light) / ggx_.masking(view_);
  }
  value.cosine_f += glass_share_ * glass_compensation_ * density * masked * (reflected ? facet.reflected : facet.transmitted);
  value.density += shares_.glass * density * (reflected ? facet.chance : 1.0f - facet.chance);
}

void LayeredBsdf::add_sheen(Vec3f light, BsdfValue& value) const {
  value.cosine_f += surface_.sheen_color * (light.z * sheen_f(view_, light, surface_.sheen_roughness));
  value.density += shares_.sheen * (0.5f / kPi);
}

void LayeredBsdf::add_coat(Vec3f light, BsdfValue& value) const {
  if (!(light.z > 0.0f)) return;
  const Ggx ggx{coat_alpha_};
  const Vec3f h = glm::normalize(coat_view_ + light);
  const float cosine = glm::dot(coat_view_, h);
  const float fresnel = kCoatReflectance + (1.0f - kCoatReflectance) * schlick_weight(cosine);
  const Vec3f factor = GgxAlbedo::compensation(albedo_.single(coat_view_.z, coat_alpha_), Vec3f(kCoatReflectance), Vec3f(1.0f));
  value.cosine_f += factor * (surface_.base.clearcoat * fresnel * ggx.distribution(h) * ggx.masking(coat_view_, light) /
                              (4.0f * coat_view_.z));
  value.density += shares_.coat * ggx.visible_density(coat_view_, h) / (4.0f * cosine);
}

/// Transmitted light must be behind the normals of both the diffuse part and the gloss.
BsdfValue LayeredBsdf::evaluate(Vec3f light_world) const {
  const Vec3f local = basis_.to_local(light_world), light = local_to_gloss(light_world, local);
  BsdfValue value, under_sheen;
  value.transmitted = scatters_through() && local.z < 0.0f && light.z < 0.0f;
  if (local.z > 0.0f || value.transmitted) {
    add_diffuse(local, value);
    value.cosine_f *= below_sheen(local);
  }
  if (light.z != 0.0f) {
    if (shares_.gloss > 0.0f && !is_smooth_ && light.z > 0.0f) add_gloss(light, under_sheen);
    if (glass_share_ > 0.0f && !is_smooth_) add_glass(light, under_sheen);
    value.cosine_f += below_sheen(light) * under_sheen.cosine_f;
    value.density += under_sheen.density;
    if (most_sheen_ > 0.0f && light.z > 0.0f) add_sheen(light, value);
  }
  value.cosine_f *= below_coat_;
  if (surface_.base.clearcoat > 0.0f && !is_mirror(coat_alpha_)) add_coat(coat_basis_.to_local(light_world), value);
  return value;
}

bool LayeredBsdf::draw_gloss(Vec2f u, BsdfSample& s) const {
  const Vec3f light = mirrored(view_, is_smooth_ ? kAbove : ggx_.sample_visible(view_, u));
  if (!(light.z > 0.0f)) return false;
  s.direction = gloss_basis_.to_world(light);
  if (is_smooth_) s.density = kInfinity, s.weight = below_coat_ * below_sheen(light) / shares_.gloss * gloss_albedo_;
  return true;
}

Vec3f LayeredBsdf::straight() const {
  if (!surface_.is_thin || !is_smooth_ || !(glass_share_ > 0.0f)) return Vec3f(0.0f);
  return below_coat_ * sheen_passes_ * glass_share_ * glass_facet(view_.z).transmitted;
}

bool LayeredBsdf::draw_glass(float decision, Vec2f u, BsdfSample& s) const {
  const Vec3f normal = is_smooth_ ? kAbove : ggx_.sample_visible(view_, u);
  const GlassFacet facet = glass_facet(glm::dot(view_, normal));
  s.transmitted = !(decision < facet.chance);
  if (s.transmitted && surface_.is_thin && is_smooth_) return pass_straight(shares_.glass * (1.0f - facet.chance), s);
  Vec3f light = mirrored(view_, normal);
  if (s.transmitted) light = surface_.is_thin ? flipped(light) : refracted_away(view_, normal, eta_);
  if (light.z == 0.0f || (light.z < 0.0f) != s.transmitted) return false;
  s.direction = gloss_basis_.to_world(light);
  if (!is_smooth_) return true;
  const float chance = shares_.glass * (s.transmitted ? 1.0f - facet.chance : facet.chance);
  s.density = kInfinity;
  s.weight = below_coat_ * below_sheen(light) * glass_share_ / chance * (s.transmitted ? facet.transmitted : facet.reflected);
  return true;
}

/// Continues straight through a thin wall. `chance` is the probability with which sample() calls this function.
bool LayeredBsdf::pass_straight(float chance, BsdfSample& s) const {
  s.direction = ahead_;  // -view_ differs slightly if view_ was lifted, so paths through many walls would drift
  s.density = kInfinity;
  s.weight = straight() / chance;
  s.straight = surface_.shadow_rays_pass;
  s.is_vertex = !surface_.shadow_rays_pass;
  return true;
}

bool LayeredBsdf::draw_coat(Vec2f u, BsdfSample& s) const {
  if (!(shares_.coat > 0.0f)) return false;
  const bool smooth = is_mirror(coat_alpha_);
  const Vec3f light = mirrored(coat_view_, smooth ? kAbove : Ggx{coat_alpha_}.sample_visible(coat_view_, u));
  if (!(light.z > 0.0f)) return false;
  s.direction = coat_basis_.to_world(light);
  if (smooth) s.density = kInfinity, s.weight = Vec3f((1.0f - below_coat_) / shares_.coat);
  return true;
}

/// Samples a direction. Sets weight and density only for Dirac lobes. Returns false if no light arrives from the direction.
bool LayeredBsdf::draw(float lobe, Vec2f u, BsdfSample& s) const {
  if (lobe < shares_.diffuse) {
    s.direction = basis_.to_world(sample_cosine(u));
    return true;
  }
  if ((lobe -= shares_.diffuse) < shares_.through) {
    s.direction = basis_.to_world(flipped(sample_cosine(u)));
    s.transmitted = true;
    return !glossy_apart_ || glm::dot(s.direction, gloss_basis_.z) < 0.0f;
  }
  if ((lobe -= shares_.through) < shares_.sheen) {
    const float radius = std::sqrt(std::max(0.0f, 1.0f - u.x * u.x)), angle = 2.0f * kPi * u.y;
    s.direction = gloss_basis_.to_world({radius * std::cos(angle), radius * std::sin(angle), u.x});
    return u.x > 0.0f;
  }
  if ((lobe -= shares_.sheen) < shares_.gloss) return draw_gloss(u, s);
  if ((lobe -= shares_.gloss) < shares_.glass) return draw_glass(lobe / shares_.glass, u, s);
  return draw_coat(u, s);
}

std::optional<BsdfSample> LayeredBsdf::sample(float lobe, Vec2f u) const {
  BsdfSample s;
  if (!draw(lobe, u, s)) return std::nullopt;
  if (s.is_delta()) return s;
  const BsdfValue value = evaluate(s.direction);
  if (!(value.density > 0.0f)) return std::nullopt;
  s.weight = value.cosine_f / value.density;
  s.density = value.density;
  return s;
}

}  // namespace lippmann
