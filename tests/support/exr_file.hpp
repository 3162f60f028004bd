// Writes uncompressed OpenEXR files of floats, with any windows, channels and attributes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace lippmann::test {

struct ExrWindow {
  std::int32_t left = 0, top = 0, right = 0, bottom = 0;
};

struct ExrPart {
  ExrWindow data, display;
  /// Sorted by name, as the format requires. Values cover the data window row by row.
  std::vector<std::pair<std::string, std::vector<float>>> channels;
  float pixel_aspect = 1.0f;
  std::string attributes{};
  std::string name{};       ///< name of the part; required with several parts
  int chroma_sampling = 1;  ///< RY and BY have one sample per block of this many columns and rows
};

inline int exr_sampling(const ExrPart& part, const std::string& channel) {
  return channel == "RY" || channel == "BY" ? part.chroma_sampling : 1;
}

template <class Value>
std::string bytes_of_value(const Value& value) {
  return {reinterpret_cast<const char*>(&value), sizeof value};
}

inline std::string exr_attribute(std::string_view name, std::string_view type, std::string_view value) {
  std::string text(name);
  text += '\0';
  text += type;
  text += '\0';
  return text + bytes_of_value(static_cast<std::int32_t>(value.size())) + std::string(value);
}

inline std::string exr_chromaticities(const std::array<float, 8>& xy) {
  return exr_attribute("chromaticities", "chromaticities", bytes_of_value(xy));
}

inline std::string exr_header(const ExrPart& part, bool several) {
  std::string channels;
  for (const auto& [name, values] : part.channels) {
    channels += name;
    channels += '\0';
    const int sampling = exr_sampling(part, name);
    // The words are the sample type (2 is float), a flag for perceptually linear samples, and the sampling in x and y.
    for (const std::int32_t word : {2, 0, sampling, sampling}) channels += bytes_of_value(word);
  }
  channels += '\0';
  std::string header = exr_attribute("channels", "chlist", channels) + exr_attribute("compression", "compression", {"\0", 1}) +
                       exr_attribute("dataWindow", "box2i", bytes_of_value(part.data)) +
                       exr_attribute("displayWindow", "box2i", bytes_of_value(part.display)) +
                       exr_attribute("lineOrder", "lineOrder", {"\0", 1}) +
                       exr_attribute("pixelAspectRatio", "float", bytes_of_value(part.pixel_aspect)) +
                       exr_attribute("screenWindowCenter", "v2f", bytes_of_value(std::array<float, 2>{})) +
                       exr_attribute("screenWindowWidth", "float", bytes_of_value(1.0f)) + part.attributes;
  if (several)
    header += exr_attribute("name", "string", part.name) + exr_attribute("type", "string", "scanlineimage") +
              exr_attribute("chunkCount", "int", bytes_of_value(part.data.bottom - part.data.top + 1));
  return header + '\0';
}

inline std::vector<std::byte> exr_file(const std::vector<ExrPart>& parts) {
  const bool several = parts.size() > 1;
  std::string file("\x76\x2f\x31\x01\x02\0\0\0", 8);
  if (several) file[5] = '\x10';
  std::size_t rows = 0;
  for (const ExrPart& part : parts) {
    file += exr_header(part, several);
    rows += static_cast<std::size_t>(part.data.bottom - part.data.top + 1);
  }
  if (several) file += '\0';
  std::uint64_t place = file.size() + 8 * rows;
  std::string chunks;
  for (std::size_t index = 0; index < parts.size(); ++index) {
    const ExrPart& part = parts[index];
    const auto width = static_cast<std::size_t>(part.data.right - part.data.left + 1);
    for (std::int32_t y = part.data.top; y <= part.data.bottom; ++y) {
      file += bytes_of_value(place + chunks.size());
      if (several) chunks += bytes_of_value(static_cast<std::int32_t>(index));
      std::string samples;
      for (const auto& [name, values] : part.channels) {
        const auto step = static_cast<std::size_t>(exr_sampling(part, name));
        for (std::size_t x = 0; x < width && y % static_cast<int>(step) == 0; x += step)
          samples += bytes_of_value(values[static_cast<std::size_t>(y - part.data.top) * width + x]);
      }
      chunks += bytes_of_value(y) + bytes_of_value(static_cast<std::int32_t>(samples.size())) + samples;
    }
  }
  file += chunks;
  const auto bytes = reinterpret_cast<const std::byte*>(file.data());
  return {bytes, bytes + file.size()};
}

inline std::vector<std::byte> exr_file(const ExrPart& part) { return exr_file(std::vector{part}); }

}  // namespace lippmann::test
