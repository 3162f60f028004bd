// Opens light fields in files of any format that `convert` reads.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lippmann/formats/formats.hpp"
#include "lippmann/layout/light_field.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

struct OpenedLightField {
  LightField field{};  ///< with cameras if the format or the report has them
  /// Optics that the picture was rendered for; none without a report.
  std::optional<Optics> optics = {};
  std::string_view format = {};  ///< name in light_field_formats()
};

/// Opens a picture or a folder of views. `from` is a format's name, or empty to detect it. `options` override the report.
/// Throws Error naming the file, or the option that must be set because no file states its value.
OpenedLightField open_light_field(const std::filesystem::path& path, const std::string& from, const FormatOptions& options);

/// Returns the pictures or folders frame_0000, frame_0001, ... in the folder `path`, or `path` itself if it has none.
/// Throws Error if there is no light field.
std::vector<std::filesystem::path> light_fields_in(const std::filesystem::path& path, const std::string& from);

}  // namespace lippmann
