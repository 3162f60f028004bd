#include "shading/web_beams.hpp"

#include <algorithm>
#include <cmath>

#include "scene/photometric_web.hpp"

namespace lippmann {
namespace {

using Vec3d = glm::dvec3;

/// Largest integration steps in polar angle and azimuth, in radians.
constexpr double kPolarStep = 0.1, kAzimuthStep = 0.25;
/// Added to the half angle of cones in radians, because the sampled directions are coarse.
constexpr double kConeMargin = 0.5 * kAzimuthStep;
/// A web has no preferred direction if its mean direction vector is shorter than this.
constexpr double kLeastMeanDirection = 1e-3;

Vec3d direction_at(const PhotometricWeb& web, double polar, double azimuth) {
  const double sine = std::sin(polar);
  return glm::transpose(glm::dmat3(web.web_from_light)) *
         Vec3d(sine * std::cos(azimuth), sine * std::sin(azimuth), std::cos(polar));
}

template <class Visit>
void visit_steps(std::span<const float> angles, double most, const Visit& visit) {
  for (std::size_t i = 0; i + 1 < angles.size(); ++i) {
    const auto from = static_cast<double>(angles[i]), whole = static_cast<double>(angles[i + 1]) - from;
    const int steps = std::max(1, static_cast<int>(std::ceil(whole / most)));
    for (int s = 0; s < steps; ++s) visit(from + whole * s / steps, from + whole * (s + 1) / steps);
  }
}

/// Calls visit(direction, flux) for small parts of the sphere where the web emits. flux is intensity times solid angle / (4
/// pi).
template <class Visit>
void visit_parts_of_web(const PhotometricWeb& web, const Visit& visit) {
  constexpr float kAround[] = {0.0f, 2.0f * kPi};
  const std::span<const float> azimuths = web.azimuth.size() == 1 ? std::span<const float>(kAround) : web.azimuth;
  visit_steps(azimuths, kAzimuthStep, [&](double a0, double a1) {
    visit_steps(web.polar, kPolarStep, [&](double p0, double p1) {
      const Vec3d d = direction_at(web, 0.5 * (p0 + p1), 0.5 * (a0 + a1));
      const double flux =
          static_cast<double>(intensity(web, Vec3f(d))) * (std::cos(p0) - std::cos(p1)) * (a1 - a0) / (4.0 * M_PI);
      if (flux > 0.0) visit(d, flux);
    });
  });
}

double angle_to(Vec3d direction, Vec3d axis) { return std::acos(std::clamp(glm::dot(direction, axis), -1.0, 1.0)); }

WebBeam beam_of(const PhotometricWeb& web) {
  Vec3d mean(0.0);
  visit_parts_of_web(web, [&](Vec3d d, double flux) { mean += flux * d; });
  WebBeam beam;
  if (glm::length(mean) > kLeastMeanDirection) beam.axis = Vec3f(glm::normalize(mean));
  const Vec3d axis(beam.axis);
  beam.profile = {0.0, 0.0, 0.0};
  double angle = 0.0;
  visit_parts_of_web(web, [&](Vec3d d, double flux) {
    const double cosine = glm::dot(d, axis);
    beam.profile.mean += flux;
    beam.profile.linear += 3.0 * flux * cosine;
    beam.profile.square += 5.0 * flux * 0.5 * (3.0 * cosine * cosine - 1.0);
    angle = std::max(angle, angle_to(d, axis));
  });
  beam.half_angle = static_cast<float>(std::min(angle + kConeMargin, M_PI));
  if (!(beam.profile.mean > 0.0)) beam.profile = {};
  return beam;
}

}  // namespace

std::vector<WebBeam> beams_of(std::span<const PhotometricWeb> webs) {
  std::vector<WebBeam> beams;
  for (const PhotometricWeb& web : webs) beams.push_back(beam_of(web));
  return beams;
}

}  // namespace lippmann
