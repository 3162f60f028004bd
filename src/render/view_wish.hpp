// What people say of the view instead of leaving it to the fit: --focus, --fit-to, --zoom and --orbit.
//
// Nodes are called by the name of a node, which stands for everything below it too, or by that of an object that is shown.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/math.hpp"
#include "scene/scene.hpp"

namespace lippmann {

/// How far the view is turned about what it looks at.
struct Orbit {
  float yaw_deg = 0.0f;    ///< the viewer moves to the right
  float pitch_deg = 0.0f;  ///< the viewer moves up; not beyond straight above or below
  bool operator==(const Orbit&) const = default;
};

struct ViewWish {
  std::string focus;   ///< a node's name, X,Y,Z in the world, or a distance from the viewer; empty: not said
  std::string fit_to;  ///< a node's name; empty: not said
  float zoom = 1.0f;   ///< > 0; what is seen of the plane is that much smaller
  Orbit orbit;
};

/// Which instances a name means, one flag for each. Throws a usage Error at `flag` where there is no such name, with the
/// nearest one, or where nothing is shown below it.
std::vector<bool> instances_named(const Scene& scene, const std::string& name, const char* flag);

/// Whether a node or an instance has that name.
bool is_name_of_node(const Scene& scene, std::string_view name);

/// "-30" or "-30,15", in degrees. Throws a usage Error at `where`.
Orbit read_orbit(std::string_view text, const std::string& where);
std::string write_orbit(const Orbit& orbit);

/// The numbers between commas: one or three. Throws a usage Error at --focus where `text` is neither; the scene's names are
/// what the Error then suggests.
std::vector<float> read_focus(const Scene& scene, const std::string& text);

}  // namespace lippmann
