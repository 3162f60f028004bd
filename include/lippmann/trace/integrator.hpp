// The integrators, which compute the light of a frame.
#pragma once

#include <span>
#include <string_view>

namespace lippmann {

/// Properties of an integrator.
struct IntegratorFacts {
  std::string_view name{};
  int default_samples = 1;
  bool is_stochastic = false;     ///< images have noise, which decreases with the number of samples
  bool can_share_pixels = false;  ///< frames may copy or interpolate pixels from other frames
  bool separates_light = false;   ///< the layers of direct and indirect light are available
  /// The integrator samples all lights, emissive surfaces and media, which needs tables of them.
  bool samples_all_light = false;
  bool is_lit_by_surroundings = false;  ///< the background alone lights a scene, so that lamps are not needed
};

struct IntegratorModel;

/// Identifies an integrator. Two objects are equal if they refer to the same model.
class Integrator {
 public:
  static const Integrator kWhitted;  ///< direct light, sharp shadows, mirrors and refraction
  static const Integrator kPath;     ///< all light, by path tracing

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
