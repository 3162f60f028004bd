// Opens light fields in files of any format that `convert` reads, without being told which.
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
  LightField field;                   ///< with cameras, where the format or the report beside a render's picture knows them
  std::optional<Optics> optics = {};  ///< that it was rendered for, as the report says: it holds all views; none: no report
  std::string_view format = {};       ///< its name in light_field_formats()
};

/// `path`: a picture or a folder of views, of one moment. `from`: a format's name; empty: as names and a report.json beside it
/// say. Options that are given win over the report. Throws Error naming the file, or the option that has to say what nothing
/// else says.
OpenedLightField open_light_field(const std::filesystem::path& path, const std::string& from, const FormatOptions& options);

/// The light fields of an animation, by frame: frame_0000.png, frame_0001.png, ... (or folders of such names) of a folder;
/// `path` alone where it is a file or holds one light field. Throws Error where there is nothing.
std::vector<std::filesystem::path> light_fields_in(const std::filesystem::path& path, const std::string& from);

}  // namespace lippmann
