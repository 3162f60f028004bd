#include "stage/read_view_wish.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <set>

#include "core/number_text.hpp"
#include "core/printable.hpp"
#include "core/suggest.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

std::vector<std::string_view> names_in(const Scene& scene) {
  std::vector<std::string_view> names;
  std::set<std::string_view> known;
  const auto add = [&](std::string_view name) {
    if (!name.empty() && known.insert(name).second) names.push_back(name);
  };
  for (const Instance& instance : scene.instances) add(instance.name);
  for (const Node& node : scene.nodes) add(node.name);
  return names;
}

std::string list_names(const std::vector<std::string_view>& names) {
  constexpr std::size_t kListed = 12;
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), kListed); ++i)
    text += fmt::format("{}{}", i == 0 ? "" : ", ", printable(names[i]));
  if (names.size() > kListed) text += fmt::format(" and {} more", names.size() - kListed);
  return text;
}

Error no_such_name(const Scene& scene, const std::string& name, const char* flag, const std::string& also_accepted) {
  const std::vector<std::string_view> names = names_in(scene);
  std::string accepted = list_names(names);
  if (!also_accepted.empty()) accepted += (accepted.empty() ? "" : "; ") + also_accepted;
  return usage_error(flag, fmt::format("{} is not in the scene{}", shown(name), did_you_mean(name, names)),
                     accepted.empty() ? "no name: the nodes of this scene have none" : accepted);
}

std::vector<bool> nodes_below(const Scene& scene, std::string_view name) {
  std::vector<bool> below(scene.nodes.size(), false);
  for (std::size_t i = 0; i < below.size(); ++i) {
    const int parent = scene.nodes[i].parent;
    below[i] = scene.nodes[i].name == name || (parent >= 0 && below[static_cast<std::size_t>(parent)]);
  }
  return below;
}

std::vector<std::string_view> split_at_commas(std::string_view text) {
  std::vector<std::string_view> parts;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t comma = std::min(text.find(',', start), text.size());
    parts.push_back(text.substr(start, comma - start));
    start = comma + 1;
  }
  return parts;
}

}  // namespace

bool is_name_of_node(const Scene& scene, std::string_view name) {
  const auto is_called = [&](const auto& element) { return element.name == name; };
  return !name.empty() && (std::any_of(scene.nodes.begin(), scene.nodes.end(), is_called) ||
                           std::any_of(scene.instances.begin(), scene.instances.end(), is_called));
}

std::vector<bool> instances_named(const Scene& scene, const std::string& name, const char* flag) {
  if (!is_name_of_node(scene, name)) throw no_such_name(scene, name, flag, {});
  const std::vector<bool> below = nodes_below(scene, name);
  const auto is_below = [&](int node) { return node >= 0 && below[static_cast<std::size_t>(node)]; };
  std::vector<bool> named;
  for (const Instance& instance : scene.instances) {
    bool is_meant = instance.name == name || is_below(instance.node);
    if (instance.skin >= 0) {
      // The user may only know the name of the skeleton's node, to which a skinned mesh belongs.
      const std::vector<int>& joints = scene.skins[static_cast<std::size_t>(instance.skin)].joints;
      is_meant = is_meant || (!joints.empty() && std::all_of(joints.begin(), joints.end(), is_below));
    }
    named.push_back(is_meant);
  }
  if (std::find(named.begin(), named.end(), true) == named.end())
    throw usage_error(flag, fmt::format("{} and its children have no shapes", shown(name)), "a node that shows a shape");
  return named;
}

Orbit read_orbit(std::string_view text, const std::string& where) {
  const std::vector<std::string_view> parts = split_at_commas(text);
  if (parts.size() > 2) throw usage_error(where, shown(text) + " has more than two numbers", "YAW or YAW,PITCH in degrees");
  Orbit orbit;
  orbit.yaw_deg = static_cast<float>(read_number(parts[0], -360.0, 360.0, where));
  if (parts.size() == 2) orbit.pitch_deg = static_cast<float>(read_number(parts[1], -90.0, 90.0, where));
  return orbit;
}

std::string write_orbit(const Orbit& orbit) {
  if (orbit == Orbit{}) return {};
  return fmt::format("{},{}", orbit.yaw_deg, orbit.pitch_deg);
}

std::vector<double> read_focus(const Scene& scene, const std::string& text) {
  constexpr double kFarthest = 1e15;
  const std::vector<std::string_view> parts = split_at_commas(text);
  std::vector<double> numbers;
  try {
    for (const std::string_view part : parts) numbers.push_back(read_number(part, -kFarthest, kFarthest, "focus"));
  } catch (const Error&) {
    throw no_such_name(scene, text, "focus", "a point X,Y,Z, or a distance above 0");
  }
  const bool is_distance = numbers.size() == 1 && numbers[0] > 0.0;
  if (!is_distance && numbers.size() != 3)
    throw usage_error("focus", shown(text) + " is neither a point nor a distance",
                      "a node's name, a point X,Y,Z, or a distance above 0");
  return numbers;
}

}  // namespace lippmann
