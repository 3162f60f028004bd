// Based on: Khronos Group, "glTF 2.0 Specification", 2021, section 3.11 "Animations".
#include "scene/gltf/animation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "scene/gltf/accessor.hpp"

namespace lippmann::gltf {
namespace {

Vec3f value_of(Vec3f v) { return v; }
Quatf value_of(Vec4f v) { return {v.w, v.x, v.y, v.z}; }

Interpolation interpolation_of(const tinygltf::AnimationSampler& sampler) {
  if (sampler.interpolation == "STEP") return Interpolation::kStep;
  return sampler.interpolation == "CUBICSPLINE" ? Interpolation::kCubicSpline : Interpolation::kLinear;
}

class AnimationReader {
 public:
  AnimationReader(Document& document, const NodeMap& nodes, Scene& scene)
      : document_(document), report_(document.report), nodes_(nodes), scene_(scene) {}

  /// In seconds, from 0 to the last key of any channel that is read.
  double duration = 0.0;

  void read(std::size_t index) {
    const tinygltf::Animation& animation = document_.model.animations[index];
    for (std::size_t i = 0; i < animation.channels.size(); ++i)
      read_channel(animation, animation.channels[i], element("animations", index, "channels", i));
  }

 private:
  void read_channel(const tinygltf::Animation& animation, const tinygltf::AnimationChannel& channel, const std::string& where) {
    if (static_cast<std::size_t>(channel.sampler) >= animation.samplers.size())
      report_.fail(where, fmt::format("refers to samplers[{}], but there are {}", channel.sampler, animation.samplers.size()));
    const tinygltf::AnimationSampler& sampler = animation.samplers[static_cast<std::size_t>(channel.sampler)];
    if (channel.target_path == "weights")
      return report_.not_supported("morph targets are", "meshes keep their base shape", where);
    const int node = nodes_.scene_node[static_cast<std::size_t>(channel.target_node)];
    if (node < 0) return;
    if (scene_.nodes[static_cast<std::size_t>(node)].matrix)
      report_.fail(where, fmt::format("animates nodes[{}], which has a matrix", channel.target_node),
                   "a node with translation, rotation and scale");
    NodeAnimation& target = animation_of(node);
    if (channel.target_path == "translation")
      read_values<Vec3f>(sampler, where, target.translation);
    else if (channel.target_path == "scale")
      read_values<Vec3f>(sampler, where, target.scale);
    else if (channel.target_path == "rotation")
      read_rotations(sampler, where, target.rotation);
    else
      report_.fail(where + ".target.path", "is " + shown(channel.target_path), "translation, rotation, scale, weights");
  }

  NodeAnimation& animation_of(int node) {
    std::vector<NodeAnimation>& all = scene_.timeline.animations;
    const auto [found, is_new] = animation_of_node_.try_emplace(node, all.size());
    if (is_new) all.emplace_back().node = node;
    return all[found->second];
  }

  template <class V, class T>
  void read_values(const tinygltf::AnimationSampler& sampler, const std::string& where, Channel<T>& channel) {
    if (!channel.times.empty()) report_.fail(where, "animates what another channel animates already");
    channel.interpolation = interpolation_of(sampler);
    channel.times = read_times(sampler.input);
    const std::vector<V> values = unpack<V>(document_, sampler.output);
    const std::size_t per_key = channel.interpolation == Interpolation::kCubicSpline ? 3 : 1;
    if (values.size() != per_key * channel.times.size())
      report_.fail(where, fmt::format("has {} keys, but {} values", channel.times.size(), values.size()),
                   fmt::format("{} a key", per_key));
    for (const V& value : values) channel.values.push_back(value_of(value));
    duration = std::max(duration, channel.times.back());
  }

  void read_rotations(const tinygltf::AnimationSampler& sampler, const std::string& where, Channel<Quatf>& channel) {
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
        report_.fail(where, fmt::format("key {} at {} s does not come after the one at {} s", i, times[i], times[i - 1]));
    return {times.begin(), times.end()};
  }

  Document& document_;
  Report& report_;
  const NodeMap& nodes_;
  Scene& scene_;
  std::map<int, std::size_t> animation_of_node_;
};

void name_the_others(Document& document) {
  const std::vector<tinygltf::Animation>& all = document.model.animations;
  if (all.size() < 2) return;
  constexpr std::size_t kMost = 10;
  std::string others;
  for (std::size_t i = 1; i < std::min(all.size(), kMost + 1); ++i)
    others += fmt::format("{}{}", i > 1 ? ", " : "", shown(all[i].name));
  if (all.size() > kMost + 1) others += ", ...";
  document.report.warn(
      fmt::format("of {} animations only the first, {}, is read; left out: {}", all.size(), shown(all[0].name), others));
}

}  // namespace

void read_animation(Document& document, const NodeMap& nodes, double frames_per_second, Scene& scene) {
  scene.timeline.frames_per_second = frames_per_second;
  if (document.model.animations.empty()) return;
  name_the_others(document);
  AnimationReader reader(document, nodes, scene);
  reader.read(0);

  // The frame at the animation's very end would repeat its first one when it is played in a loop, hence no "+ 1".
  const double frames = std::round(reader.duration * frames_per_second);
  if (frames > document.limits.frames)
    document.report.fail(
        "animations[0]",
        fmt::format("lasts {} s, which is {} frames at {} a second", reader.duration, frames, frames_per_second),
        fmt::format("at most {} frames", document.limits.frames));
  scene.timeline.frame_count = std::max(1, static_cast<int>(frames));
}

}  // namespace lippmann::gltf
