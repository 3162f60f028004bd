// The integrators. Each computes a part of the light by a certain method.
#pragma once

#include <span>
#include <string_view>

namespace lippmann {

/// Properties of an integrator. Code outside the integrators depends only on these properties, not on the integrator itself.
struct IntegratorFacts {
  std::string_view name{};
  int default_samples = 1;        ///< default number of samples per pixel
  bool is_stochastic = false;     ///< images have noise, which differs between frames and decreases with the number of samples
  bool can_share_pixels = false;  ///< frames may copy or interpolate pixels from other frames
  bool separates_light = false;   ///< the layers of direct and indirect light are available
  /// The integrator samples all lights, emissive surfaces and media of the scene, so that tables of them are needed.
  bool samples_all_light = false;
  bool is_lit_by_surroundings = false;  ///< the background alone lights a scene, so that lamps are not needed
};

struct IntegratorModel;  // defined in trace/integrator_model.hpp

/// Identifies an integrator. Two objects are equal if they refer to the same model.
class Integrator {
 public:
  static const Integrator kWhitted;  ///< computes direct light, sharp shadows, mirrors and refraction
  static const Integrator kPath;     ///< computes all light, by path tracing

  /// `model` must outlive this object.
  constexpr explicit Integrator(const IntegratorModel& model) : model_(&model) {}

  const IntegratorFacts& facts() const;
  const IntegratorModel& model() const { return *model_; }

  friend bool operator==(Integrator, Integrator) = default;

 private:
  const IntegratorModel* model_;
};

/// Returns all integrators that flags and job files can name.
std::span<const Integrator> integrators();

}  // namespace lippmann
