#include <array>

#include "trace/integrator_model.hpp"

namespace lippmann {

constinit const Integrator Integrator::kWhitted{whitted_model};
constinit const Integrator Integrator::kPath{path_model};

std::span<const Integrator> integrators() {
  static const std::array all{Integrator::kWhitted, Integrator::kPath};
  return all;
}

const IntegratorFacts& Integrator::facts() const { return model_->facts; }

void FrameIntegrator::set_probe(BlockProbe*) {}

}  // namespace lippmann
