// The process that writes a part of a journal: whether it still does, and stopping it.
//
// A part is named TIME-HOST-PROCESS.jsonl (folder/journal.hpp). A number of a process alone proves nothing, as another process
// may have got it since; a process of that number that has that very file open for writing is the render. The system closes the
// file when the process ends, however it ends.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace lippmann {

struct JournalWriter {
  std::string host;    ///< the machine's name (platform::host_name)
  int process = 0;     ///< its number on that machine
  double began = 0.0;  ///< seconds since 1970, whole, by that machine's clock

  bool is_of_this_machine() const;
};

/// As the name of the part says; none where it is no name of a part.
std::optional<JournalWriter> writer_of(const std::filesystem::path& part);

/// Whether a process of this machine writes it. A process of another user is not seen.
bool is_being_written(const std::filesystem::path& part);

/// How long a run holds a folder since it has last renewed its lease (JournalPart::renew), where its process cannot be seen.
inline constexpr double kLeaseSeconds = 600.0;

/// Whether the run that writes it may still go on. Of this machine: while its process writes it. Of another machine, or of a
/// process that this one may not look into: until it records its end, while its lease lasts.
bool is_held(const std::filesystem::path& part);

/// Does to that process what Ctrl-C does, once: a second time would end it at once. False: there is none.
bool interrupt_writer(const std::filesystem::path& part);

}  // namespace lippmann
