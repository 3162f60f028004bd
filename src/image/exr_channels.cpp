#include "image/exr_channels.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>
#include <tuple>

namespace lippmann {
namespace {

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return result;
}

struct ChannelName {
  std::string layer, channel;
};

ChannelName split(const std::string& name) {
  const std::size_t at = name.find_last_of(".:/");
  if (at == std::string::npos) return {"", name};
  return {name.substr(0, at), name.substr(at + 1)};
}

std::string meaning_of(std::string_view channel) {
  const std::string name = lower(channel);
  if (name == "red") return "R";
  if (name == "green") return "G";
  if (name == "blue") return "B";
  if (name == "alpha") return "A";
  for (const char* known : {"R", "G", "B", "A", "Y", "RY", "BY", "X", "Z"})
    if (name == lower(known)) return known;
  return "";
}

/// Maps "R" etc. to the full name of a channel. A channel named exactly "R" has precedence over "r" and "Red".
using Layer = std::map<std::string, std::string>;

void add(Layer& layer, const std::string& name, const std::string& channel) {
  const std::string meaning = meaning_of(channel);
  if (!meaning.empty() && (!layer.contains(meaning) || meaning == channel)) layer[meaning] = name;
}

bool has_exact_name(const Layer& layer, const std::string& meaning) { return split(layer.at(meaning)).channel == meaning; }

ExrColors colors_of(const Layer& layer) {
  ExrColors colors;
  const auto has = [&](const char* meaning) { return layer.contains(meaning); };
  const auto take = [&](std::initializer_list<const char*> meanings) {
    for (const char* meaning : meanings) colors.channels.push_back(layer.at(meaning));
  };
  if (has("R") && has("G") && has("B")) {
    take({"R", "G", "B"});
  } else if (has("Y") && has("RY") && has("BY") && has_exact_name(layer, "Y") && has_exact_name(layer, "RY") &&
             has_exact_name(layer, "BY")) {
    take({"Y", "RY", "BY"});
    colors.luma_chroma = true;
  } else if (has("Y") && !has("X")) {  // beside X, Y is a coordinate and not brightness
    take({"Y"});
  }
  if (!colors.channels.empty() && has("A")) colors.alpha = layer.at("A");
  return colors;
}

bool is_main(const std::string& layer) {
  constexpr std::array<std::string_view, 10> kMain{"combined", "beauty", "rgba",   "rgb",  "color",
                                                   "colour",   "image",  "master", "main", "composite"};
  const std::string name = lower(split(layer).channel);
  return std::find(kMain.begin(), kMain.end(), name) != kMain.end();
}

int rank_of(const std::string& channel) {
  constexpr std::array<std::string_view, 5> kFirst{"R", "G", "B", "A", "Z"};
  return static_cast<int>(std::find(kFirst.begin(), kFirst.end(), channel) - kFirst.begin());
}

/// True for data other than brightness, such as depth, alpha or a coordinate.
bool is_data(const std::string& name) {
  constexpr std::array<std::string_view, 17> kData{"a",     "alpha",    "x",         "z",      "ry",      "by",
                                                   "u",     "v",        "w",         "n",      "id",      "depth",
                                                   "zback", "distance", "disparity", "normal", "position"};
  const auto [layer, channel] = split(name);
  const auto is_known = [&](const std::string& word) {
    return std::find(kData.begin(), kData.end(), lower(word)) != kData.end();
  };
  return is_known(channel) || is_known(split(layer).channel);
}

}  // namespace

ExrColors find_exr_colors(std::span<const std::string> names) {
  std::vector<std::pair<std::string, Layer>> layers{{"", {}}};
  for (const std::string& name : names) {
    const auto [layer, channel] = split(name);
    auto found = std::find_if(layers.begin(), layers.end(),
                              [&, &layer_name = layer](const auto& known) { return known.first == layer_name; });
    if (found == layers.end()) found = layers.insert(layers.end(), {layer, {}});
    add(found->second, name, channel);
  }
  std::erase_if(layers, [](const auto& layer) { return colors_of(layer.second).channels.empty(); });
  if (layers.empty())
    return names.size() == 1 && !is_data(names.front()) ? ExrColors{{names.front()}, "", false, false, {}} : ExrColors{};
  const auto main =
      std::find_if(layers.begin(), layers.end(), [](const auto& layer) { return layer.first.empty() || is_main(layer.first); });
  const auto chosen = main == layers.end() ? layers.begin() : main;
  ExrColors colors = colors_of(chosen->second);
  if (main == layers.end())
    for (auto layer = layers.begin(); layer != layers.end(); ++layer)
      if (layer != chosen) colors.others.push_back(layer->first);
  return colors;
}

std::vector<std::string> sorted_exr_channels(std::span<const std::string> names, const ExrColors& colors) {
  const auto place_of = [&](const std::string& name) {
    const auto color = std::find(colors.channels.begin(), colors.channels.end(), name);
    const bool is_alpha = !colors.alpha.empty() && name == colors.alpha;
    const auto first = color == colors.channels.end() && is_alpha ? colors.channels.size()
                       : color == colors.channels.end()           ? colors.channels.size() + 1
                                                                  : static_cast<std::size_t>(color - colors.channels.begin());
    const std::size_t dot = name.rfind('.');
    const std::string layer = dot == std::string::npos ? "" : name.substr(0, dot);
    return std::tuple(first, layer, rank_of(dot == std::string::npos ? name : name.substr(dot + 1)), name);
  };
  std::vector<std::string> sorted(names.begin(), names.end());
  std::sort(sorted.begin(), sorted.end(), [&](const auto& a, const auto& b) { return place_of(a) < place_of(b); });
  return sorted;
}

}  // namespace lippmann
