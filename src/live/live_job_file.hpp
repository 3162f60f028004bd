// The job file that the page's Save button writes. It never overwrites a file that another program wrote.
#pragma once

#include <filesystem>
#include <string>

#include "job/resolved_job.hpp"

namespace lippmann {

class LiveJobFile {
 public:
  /// `wanted` is the file to write. If it exists, stem-2.toml, stem-3.toml, ... in the same folder is written instead.
  explicit LiveJobFile(std::filesystem::path wanted) : wanted_(std::move(wanted)) {}

  /// Writes the job atomically and returns the path of the file. Overwrites the file that it saved last, unless that file was
  /// changed since. Otherwise writes a new file. Throws Error that names the file.
  std::filesystem::path save(const ResolvedJob& job);

 private:
  std::filesystem::path wanted_, written_;
  std::string text_;  ///< text that was last written to `written_`
};

}  // namespace lippmann
