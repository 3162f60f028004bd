#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "support/file_bytes.hpp"

namespace lippmann::test {

using Files = std::map<std::string, std::string>;

inline Files files_in(const std::filesystem::path& folder, std::string_view ending) {
  Files files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ending) files[entry.path().filename().string()] = file_bytes(entry.path());
  return files;
}

/// Returns all files below the folder, by relative path; none if it does not exist.
inline Files all_files(const std::filesystem::path& folder) {
  Files files;
  if (!std::filesystem::exists(folder)) return files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) files[entry.path().lexically_relative(folder).string()] = file_bytes(entry.path());
  return files;
}

/// Returns the files below the folder without journals, report.json and job.toml, which differ from run to run.
inline Files pictures_below(const std::filesystem::path& folder) {
  Files files = all_files(folder);
  std::erase_if(files, [](const auto& file) {
    return file.first == "report.json" || file.first == "job.toml" || file.first.starts_with(".lippmann/");
  });
  return files;
}

}  // namespace lippmann::test
