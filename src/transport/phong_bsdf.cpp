#include "transport/phong_bsdf.hpp"

namespace lippmann {

PhongBsdf::PhongBsdf(const PhongPoint& point, Vec3f normal, Vec3f view, bool entering)
    : point_(point), normal_(normal), view_(view), entering_(entering) {
  const float diffuse = luminance(point_.diffuse), mirror = luminance(point_.mirror);
  const float sum = diffuse + mirror + point_.through;
  diffuse_share_ = sum > 0.0f ? diffuse / sum : 0.0f;
  mirror_share_ = sum > 0.0f ? mirror / sum : 0.0f;
  through_share_ = sum > 0.0f ? point_.through / sum : 0.0f;
}

Vec3f PhongBsdf::evaluate_diffuse(Vec3f light) const { return Vec3f(std::max(0.0f, glm::dot(normal_, light) * (1.0f / kPi))); }

BsdfValue PhongBsdf::evaluate(Vec3f light) const {
  const float cosine = glm::dot(normal_, light) * (1.0f / kPi);
  if (!(cosine > 0.0f)) return {Vec3f(0.0f), 0.0f, true};
  return {point_.diffuse * cosine, diffuse_share_ * cosine, false};
}

Vec3f PhongBsdf::highlight(Vec3f light) const {
  if (point_.highlight == Vec3f(0.0f) || !(glm::dot(normal_, light) > 0.0f)) return Vec3f(0.0f);
  const float along = glm::dot(normal_, glm::normalize(light + view_));
  return along > 0.0f ? point_.highlight * (std::pow(along, point_.highlight_size) / kPi) : Vec3f(0.0f);
}

std::optional<BsdfSample> PhongBsdf::sample(float lobe, Vec2f u) const {
  BsdfSample s;
  if (lobe < diffuse_share_) {
    const Vec3f local = sample_cosine(u);
    s.direction = Basis(normal_).to_world(local);
    s.weight = point_.diffuse / diffuse_share_;
    s.density = diffuse_share_ * local.z * (1.0f / kPi);
    if (!(s.density > 0.0f)) return std::nullopt;
    return s;
  }
  s.density = kInfinity;
  if (lobe < diffuse_share_ + mirror_share_) {
    s.direction = mirrored(view_, normal_);
    s.weight = point_.mirror / mirror_share_;
    return s;
  }
  if (!(through_share_ > 0.0f)) return std::nullopt;
  s.straight = point_.ior == 1.0f;
  s.direction = s.straight ? -view_ : refracted_away(view_, normal_, entering_ ? point_.ior : 1.0f / point_.ior);
  s.transmitted = s.direction != Vec3f(0.0f);
  if (!s.transmitted) s.direction = mirrored(view_, normal_);
  s.weight = Vec3f(point_.through / through_share_);
  return s;
}

}  // namespace lippmann
