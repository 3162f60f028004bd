// Where the page's Save writes its job: a file that was not there before, or that it has written itself.
#pragma once

#include <filesystem>
#include <string>

#include "job/resolved_job.hpp"

namespace lippmann {

class LiveJobFile {
 public:
  /// `wanted`: the file; where it is taken, stem-2.toml, stem-3.toml, ... beside it.
  explicit LiveJobFile(std::filesystem::path wanted) : wanted_(std::move(wanted)) {}

  /// Writes the job whole or not at all, over what it wrote last unless somebody has changed that since. Returns the file.
  /// Throws Error naming it.
  std::filesystem::path save(const ResolvedJob& job);

 private:
  std::filesystem::path wanted_, written_;
  std::string text_;  ///< what has been written to written_
};

}  // namespace lippmann
