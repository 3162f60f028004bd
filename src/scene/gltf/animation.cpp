#include "scene/gltf/animation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "lippmann/core/error.hpp"
#include "lippmann/scene/timeline.hpp"
#include "scene/gltf.hpp"
#include "scene/gltf/accessor.hpp"
#include "scene/gltf/choice.hpp"

namespace lippmann::gltf {
namespace {

float value_of(float x) { return x; }
Vec3f value_of(Vec3f v) { return v; }
Quatf value_of(Vec4f v) { return {v.w, v.x, v.y, v.z}; }

Interpolation interpolation_of(Value sampler) {
  const std::string& name = sampler["interpolation"].text();
  if (name == "STEP") return Interpolation::kStep;
  return name == "CUBICSPLINE" ? Interpolation::kCubicSpline : Interpolation::kLinear;
}

class AnimationReader {
 public:
  AnimationReader(Document& document, const NodeMap& nodes, Scene& scene)
      : document_(document), report_(document.report), nodes_(nodes), scene_(scene) {}

  double duration = 0.0;

  void read(std::size_t index) {
    const Value animation = document_.root["animations"].at(index), channels = animation["channels"];
    for (std::size_t i = 0; i < channels.size(); ++i) {
      const Value sampler = animation["samplers"].at(channels.at(i)["sampler"].count());
      read_channel(sampler, channels.at(i)["target"], element("animations", index, "channels", i));
    }
  }

 private:
  void read_channel(Value sampler, Value animated, const std::string& where) {
    const int file_node = animated["node"].index();
    if (file_node < 0) return;  // an extension defines the target, which is not a node
    const int node = nodes_.scene_node[static_cast<std::size_t>(file_node)];
    if (node < 0) return;
    const std::string& path = animated["path"].text();
    if (path == "weights") return read_weights(sampler, where, node);
    if (scene_.nodes[static_cast<std::size_t>(node)].matrix)
      report_.fail(where, fmt::format("animates nodes[{}], which has a matrix", file_node),
                   "a node with translation, rotation and scale");
    NodeAnimation& target = animation_of(node);
    if (path == "translation")
      read_values<Vec3f>(sampler, where, target.translation);
    else if (path == "scale")
      read_values<Vec3f>(sampler, where, target.scale);
    else if (path == "rotation")
      read_rotations(sampler, where, target.rotation);
    else
      report_.fail(where + ".target.path", "is " + shown(path), "translation, rotation, scale, weights");
  }

  NodeAnimation& animation_of(int node) {
    std::vector<NodeAnimation>& all = scene_.timeline.animations;
    const auto [found, is_new] = animation_of_node_.try_emplace(node, all.size());
    if (is_new) all.emplace_back().node = node;
    return all[found->second];
  }

  /// Reads the keys of a channel. `count` is the number of values per key.
  template <class V, class T>
  void read_values(Value sampler, const std::string& where, Channel<T>& channel, std::size_t count = 1) {
    if (!channel.times.empty()) report_.fail(where, "has the same target as an earlier channel");
    channel.interpolation = interpolation_of(sampler);
    channel.times = read_times(sampler["input"].index());
    const std::vector<V> values = unpack<V>(document_, sampler["output"].index());
    const std::size_t per_key = count * (channel.interpolation == Interpolation::kCubicSpline ? 3 : 1);
    if (values.size() != per_key * channel.times.size())
      report_.fail(where, fmt::format("has {} keys, but {} values", channel.times.size(), values.size()),
                   fmt::format("{} per key", per_key));
    for (const V& value : values) channel.values.push_back(value_of(value));
    duration = std::max(duration, channel.times.back());
  }

  void read_weights(Value sampler, const std::string& where, int node) {
    const std::size_t count = scene_.nodes[static_cast<std::size_t>(node)].morph_weights.size();
    if (count == 0) return report_.warn_at("animated weights of nodes without morph targets are left out", where);
    read_values<float>(sampler, where, animation_of(node).morph_weights, count);
  }

  void read_rotations(Value sampler, const std::string& where, Channel<Quatf>& channel) {
    read_values<Vec4f>(sampler, where, channel);
    const bool cubic = channel.interpolation == Interpolation::kCubicSpline;
    for (std::size_t key = 0; key < channel.times.size(); ++key) {
      Quatf& value = channel.values[cubic ? 3 * key + 1 : key];
      const float length = glm::length(value);
      if (!(length > 1e-6f) || !std::isfinite(length))
        report_.fail(where, fmt::format("the rotation of key {} is not a unit quaternion", key));
      value /= length;
    }
  }

  std::vector<double> read_times(int accessor) {
    const std::vector<float> times = unpack<float>(document_, accessor);
    const std::string where = element("accessors", static_cast<std::size_t>(accessor));
    if (times.front() < 0.0f) report_.fail(where, fmt::format("the first key's time is {}", times.front()), "0 or more");
    for (std::size_t i = 1; i < times.size(); ++i)
      if (!(times[i - 1] < times[i]))
        report_.fail(where,
                     fmt::format("key {} at {} s is not later than the one before it at {} s", i, times[i], times[i - 1]));
    return {times.begin(), times.end()};
  }

  Document& document_;
  Report& report_;
  const NodeMap& nodes_;
  Scene& scene_;
  std::map<int, std::size_t> animation_of_node_;
};

/// Returns a frame rate at which all keys fall on frames, or kGltfFramesPerSecond if there is none.
double rate_of_keys(const Timeline& timeline) {
  for (const double rate : {kGltfFramesPerSecond, 24.0, 25.0, 60.0})
    if (keys_fall_on_frames(timeline, rate)) return rate;
  return kGltfFramesPerSecond;
}

}  // namespace

void read_animation(Document& document, const NodeMap& nodes, const std::string& wanted, double frames_per_second,
                    Scene& scene) {
  scene.timeline.frames_per_second = frames_per_second > 0.0 ? frames_per_second : kGltfFramesPerSecond;
  scene.animation_names = names_in(document.root["animations"]);
  if (scene.animation_names.empty()) {
    if (!wanted.empty()) throw usage_error("animation", "has no effect: the file has no animations", "a file with animations");
    return;
  }
  const std::size_t chosen = wanted.empty() ? 0 : choose("animation", scene.animation_names, wanted);
  scene.animation = static_cast<int>(chosen);
  AnimationReader reader(document, nodes, scene);
  reader.read(chosen);
  const double rate = frames_per_second > 0.0 ? frames_per_second : rate_of_keys(scene.timeline);
  scene.timeline.frames_per_second = rate;

  // In a loop, a frame for the last key would repeat the first frame.
  const double frames = std::round(reader.duration * rate);
  if (frames > document.limits.frames)
    document.report.fail(element("animations", chosen),
                         fmt::format("lasts {} s, which is {} frames at {} per second", reader.duration, frames, rate),
                         fmt::format("at most {} frames", document.limits.frames));
  scene.timeline.frame_count = std::max(1, static_cast<int>(frames));
}

}  // namespace lippmann::gltf
