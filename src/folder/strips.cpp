#include "folder/strips.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <system_error>
#include <vector>

#include "core/folder.hpp"
#include "formats/frame_names.hpp"
#include "image/exr.hpp"
#include "image/read_image.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

/// Layers are stored as floats, so that a joined frame has the same bits as one rendered as a whole.
ExrLayer float_layer(Aov aov, const Image& image) {
  const AovInfo& info = info_of(aov);
  ExrLayer layer{std::string(info.exr.layer), &image, {}, ExrSample::kFloat};
  for (int c = 0; c < info.channels; ++c) layer.channels.emplace_back(info.exr.channels[static_cast<std::size_t>(c)]);
  return layer;
}

std::vector<std::string> channel_names_of(const ExrLayer& layer) {
  std::vector<std::string> names;
  for (const std::string& channel : layer.channels) names.push_back(layer.name.empty() ? channel : layer.name + '.' + channel);
  return names;
}

std::vector<ExrLayer> layers_of_strip(const FramePictures& pictures) {
  std::vector<ExrLayer> layers{film_layer(pictures.film, ExrSample::kFloat)};
  for (std::size_t i = 0; i < kAovs; ++i)
    if (pictures.aovs.wanted[i]) layers.push_back(float_layer(static_cast<Aov>(i), pictures.aovs.images[i]));
  return layers;
}

void read_rows(const fs::path& file, const std::vector<std::string>& channels, int first_row, int rows, Image& into) {
  const Image strip = read_channels(file, channels);
  if (strip.width != into.width || strip.height != rows || first_row + rows > into.height)
    throw Error(file.string(), fmt::format("has {}x{} pixels", strip.width, strip.height),
                fmt::format("the strip of {}x{} that its render has written", into.width, rows));
  const std::size_t row = static_cast<std::size_t>(into.width) * static_cast<std::size_t>(into.channels);
  std::copy(strip.data.begin(), strip.data.end(),
            into.data.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(first_row) * row));
}

}  // namespace

std::optional<FrameReport> find_strip(const fs::path& folder, const FolderJournal& journal, int frame, int strip) {
  const auto strips = journal.strips.find(frame);
  if (strips == journal.strips.end()) return std::nullopt;
  const auto found = strips->second.finished.find(strip);
  if (found == strips->second.finished.end() || !are_as_recorded(folder, found->second.files)) return std::nullopt;
  return found->second.report;
}

FileRecords write_strip(const fs::path& folder, int frame, int strip, const FramePictures& pictures) {
  const fs::path file = folder / strip_name(frame, strip);
  // The file is temporary and read only once, so it is not compressed.
  write_exr(file, layers_of_strip(pictures), ExrCompression::kNone);
  return records_of(folder, {file});
}

void read_strip(const fs::path& file, int first_row, int rows, FramePictures& into) {
  read_rows(file, channel_names_of(film_layer(into.film)), first_row, rows, into.film);
  for (std::size_t i = 0; i < kAovs; ++i)
    if (into.aovs.wanted[i])
      read_rows(file, channel_names_of(float_layer(static_cast<Aov>(i), into.aovs.images[i])), first_row, rows,
                into.aovs.images[i]);
}

void remove_strips(const fs::path& folder, int frame, int count) {
  std::error_code ignored;
  for (int strip = 0; strip < count; ++strip)
    if (const fs::path file = folder / strip_name(frame, strip); !fs::is_directory(file, ignored)) remove_if_there(file);
}

}  // namespace lippmann
