// The file of a journal that one run writes: lines are added, and none is lost once it has been.
#pragma once

#include <filesystem>
#include <string>
#include <system_error>

#include "core/platform.hpp"

namespace lippmann {

class JournalPart {
 public:
  /// Begins a file of this run alone in the folder of journals, which exists: its first line says whose render it is. Throws
  /// Error if it cannot be written.
  JournalPart(const std::filesystem::path& folder, const std::string& job);

  /// Adds a line and waits until it is on the disk. Throws Error if it cannot be written or the file is no longer in its
  /// folder, and from then on always: what stands there of the line stays the end of the file.
  void add(const std::string& line);

  /// Says that the run goes on (is_held). May run beside add().
  void renew() const;

  /// Takes the file away, as nothing has been recorded in it.
  void remove();

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  platform::OpenFile file_;
  std::error_code problem_;  ///< of a line that could not be written
};

}  // namespace lippmann
