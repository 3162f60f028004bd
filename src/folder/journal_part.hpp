// Writes the journal file of one run. Appended lines survive a crash of the machine.
#pragma once

#include <filesystem>
#include <string>
#include <system_error>

#include "core/platform.hpp"

namespace lippmann {

class JournalPart {
 public:
  /// Creates this run's file in the existing folder of journals. Its first line names the job. Throws Error if it cannot be
  /// written.
  JournalPart(const std::filesystem::path& folder, const std::string& job);

  /// Appends a line and waits until it is on the disk. Throws Error if it cannot be written or the file was removed. All later
  /// calls then throw as well, so that an incomplete line stays the last one of the file.
  void add(const std::string& line);

  /// Renews the lease of the run (is_held). May be called in parallel with add().
  void renew() const;

  /// Removes the file. Call only if nothing has been recorded in it.
  void remove();

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  platform::OpenFile file_;
  std::error_code problem_;  ///< error of the first failed write
};

}  // namespace lippmann
