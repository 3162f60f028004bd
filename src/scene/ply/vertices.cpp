#include "scene/ply/vertices.hpp"

#include <algorithm>
#include <cmath>

#include "scene/left_out.hpp"

namespace lippmann::ply {

const Element* vertices_of(const Header& header) {
  const auto found = std::find_if(header.elements.begin(), header.elements.end(),
                                  [](const Element& element) { return element.name == "vertex"; });
  return found == header.elements.end() ? nullptr : &*found;
}

void skip_others(const std::string& name, const Header& header, Body& body, const Context& context) {
  const Element* const vertices = vertices_of(header);
  LeftOut left_out;
  bool is_before = true;
  for (const Element& element : header.elements) {
    if (&element == vertices) is_before = false;
    if (&element == vertices || element.count == 0) continue;
    left_out.add(element.name, name);
    if (is_before) body.skip(element);
  }
  left_out.warn(context, "element", "elements");
}

Vec3f first_harmonic_of(Vec3f color) { return (color - 0.5f) * std::sqrt(4.0f * kPi); }

Quatf z_to_y() { return {std::sqrt(0.5f), -std::sqrt(0.5f), 0.0f, 0.0f}; }

}  // namespace lippmann::ply
