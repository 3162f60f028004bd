// Which light is computed, and how.
#pragma once

#include <span>
#include <string_view>

namespace lippmann {

/// Answers of an integrator to the rest of the program. Nothing outside the integrators asks which one it is.
struct IntegratorFacts {
  std::string_view name;                ///< in flags and job files
  int default_samples = 1;              ///< per pixel
  bool is_stochastic = false;           ///< pictures have noise, different in every frame, that more samples reduce
  bool can_share_pixels = false;        ///< pixels may be copied or interpolated from other frames
  bool separates_light = false;         ///< makes the layers of direct and of indirect light
  bool samples_all_light = false;       ///< needs tables of all lights, emissive surfaces and media of the scene
  bool is_lit_by_surroundings = false;  ///< a scene without lamps is lit well enough by what surrounds it
};

struct IntegratorModel;  // trace/integrator_model.hpp

/// How light is computed: the name of an integrator.
class Integrator {
 public:
  static const Integrator kWhitted;  ///< direct light, sharp shadows, mirrors, refraction
  static const Integrator kPath;     ///< all of it, by random paths

  /// `model` outlives the result.
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
