// The job file that the page's Save writes: a new file, or one that it wrote itself.
#pragma once

#include <filesystem>
#include <string>

#include "job/resolved_job.hpp"

namespace lippmann {

class LiveJobFile {
 public:
  /// wanted: the file; if it exists, stem-2.toml, stem-3.toml, ... beside it.
  explicit LiveJobFile(std::filesystem::path wanted) : wanted_(std::move(wanted)) {}

  /// Writes the job atomically. Overwrites the file saved last, unless it was changed since. Returns the file. Throws Error
  /// naming it.
  std::filesystem::path save(const ResolvedJob& job);

 private:
  std::filesystem::path wanted_, written_;
  std::string text_;  ///< content written to written_
};

}  // namespace lippmann
