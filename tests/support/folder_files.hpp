// Reads all files of a folder into memory.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "support/file_bytes.hpp"

namespace lippmann::test {

using Files = std::map<std::string, std::string>;  ///< contents of files by their names

/// Returns the files in the folder whose names end with `ending`.
inline Files files_in(const std::filesystem::path& folder, std::string_view ending) {
  Files files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ending) files[entry.path().filename().string()] = file_bytes(entry.path());
  return files;
}

/// Returns all files below the folder. The keys are paths relative to the folder. Returns no files if the folder does not
/// exist.
inline Files all_files(const std::filesystem::path& folder) {
  Files files;
  if (!std::filesystem::exists(folder)) return files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) files[entry.path().lexically_relative(folder).string()] = file_bytes(entry.path());
  return files;
}

/// Returns the files below the folder except journals, report.json and job.toml, whose contents differ from run to run.
inline Files pictures_below(const std::filesystem::path& folder) {
  Files files = all_files(folder);
  std::erase_if(files, [](const auto& file) {
    return file.first == "report.json" || file.first == "job.toml" || file.first.starts_with(".lippmann/");
  });
  return files;
}

}  // namespace lippmann::test
