// The job file that the page's Save button writes. It never overwrites a file that another program wrote.
#pragma once

#include <filesystem>
#include <string>

#include "job/resolved_job.hpp"

namespace lippmann {

class LiveJobFile {
 public:
  /// If the file `wanted` exists, stem-2.toml, stem-3.toml, ... is written instead.
  explicit LiveJobFile(std::filesystem::path wanted) : wanted_(std::move(wanted)) {}

  /// Overwrites the file of the last save(), unless someone has changed it. Throws Error naming the file.
  std::filesystem::path save(const ResolvedJob& job);

 private:
  std::filesystem::path wanted_, written_;
  std::string text_;
};

}  // namespace lippmann
