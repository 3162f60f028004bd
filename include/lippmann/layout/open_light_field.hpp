// Opens light fields in files of any format that `convert` reads, with automatic detection of the format.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lippmann/layout/formats.hpp"
#include "lippmann/layout/light_field.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

struct OpenedLightField {
  LightField field{};  ///< includes cameras if the format or the report beside a rendered picture has them
  /// Optics that the picture was rendered for, covering all views. None: there is no report.
  std::optional<Optics> optics = {};
  std::string_view format = {};  ///< name in light_field_formats()
};

/// Opens one light field: a picture or a folder of views. `from`: a format's name; empty: detected from file names and a
/// report.json. `options` override the report. Throws Error naming the file, or the option that must be set because no file
/// states its value.
OpenedLightField open_light_field(const std::filesystem::path& path, const std::string& from, const FormatOptions& options);

/// Returns the light fields of an animation in frame order: the pictures or folders frame_0000, frame_0001, ... in the folder
/// `path`. Returns `path` alone if it is a file or holds a single light field. Throws Error if there is none.
std::vector<std::filesystem::path> light_fields_in(const std::filesystem::path& path, const std::string& from);

}  // namespace lippmann
