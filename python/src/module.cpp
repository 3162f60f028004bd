#include "bindings.hpp"
#include "lippmann/core/version.hpp"

PYBIND11_MODULE(_core, module) {
  using namespace lippmann::python;
  module.doc() = "The C++ library behind the package lippmann. Do not call it directly.";
  module.attr("version") = lippmann::version();
  bind_errors(module);
  bind_scene(module);
  bind_deformation(module);
  bind_optics(module);
  bind_light_field(module);
  bind_renderer(module);
  bind_dataset(module);
}
