// Writes the journal file of one run. Appended lines survive a crash of the machine.
#pragma once

#include <filesystem>
#include <string>
#include <system_error>

#include "core/platform.hpp"

namespace lippmann {

class JournalPart {
 public:
  /// Creates the run's journal file, whose first line names the job. Throws Error if the file cannot be written.
  JournalPart(const std::filesystem::path& folder, const std::string& job);

  /// Appends a line and waits until it is on the disk. Throws Error if the line cannot be written or the file was removed. All
  /// later calls then throw too, so that an incomplete line stays the last line of the file.
  void add(const std::string& line);

  /// Renews the lease of the run: for kLeaseSeconds from now, is_held() considers the run active. Thread-safe.
  void renew() const;

  /// Call this only if no frame or file has been recorded.
  void remove();

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  platform::OpenFile file_;
  std::error_code problem_;  ///< error of the first failed write
};

}  // namespace lippmann
