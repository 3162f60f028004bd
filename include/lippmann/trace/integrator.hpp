// The integrators: which light they compute, and with which method.
#pragma once

#include <span>
#include <string_view>

namespace lippmann {

/// Properties of an integrator. Code outside the integrators depends on these only, never on which integrator is used.
struct IntegratorFacts {
  std::string_view name{};         ///< name in flags and job files
  int default_samples = 1;         ///< number of samples per pixel
  bool is_stochastic = false;      ///< images have noise that differs between frames and decreases with the number of samples
  bool can_share_pixels = false;   ///< frames may copy or interpolate pixels from other frames
  bool separates_light = false;    ///< true: fills the layers of direct and indirect light
  bool samples_all_light = false;  ///< needs tables of all lights, emissive surfaces and media of the scene
  bool is_lit_by_surroundings = false;  ///< the surroundings suffice to light a scene without lamps
};

struct IntegratorModel;  // trace/integrator_model.hpp

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
