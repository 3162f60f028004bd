// Finds the process that writes a journal file (called `part`), and interrupts it. The file is named
// TIME-HOST-PROCESS.jsonl. Process ids are reused, so a process counts as the writer only while it has the file open
// for writing.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace lippmann {

struct JournalWriter {
  std::string host;    ///< name of the machine (platform::host_name)
  int process = 0;     ///< process id on that machine
  double began = 0.0;  ///< start of the run, in whole seconds since 1970, by that machine's clock

  bool is_of_this_machine() const;
};

/// Parses the name of a journal file. Returns nullopt if `part` has no such name.
std::optional<JournalWriter> writer_of(const std::filesystem::path& part);

/// Returns whether a process of this machine writes the file. Processes of other users may not be detected.
bool is_being_written(const std::filesystem::path& part);

/// A run whose process cannot be inspected counts as active for this time after its last JournalPart::renew().
inline constexpr double kLeaseSeconds = 600.0;

/// Returns whether the run that writes the file may be active. A run on this machine is active while its process writes
/// the file. If its process cannot be inspected, it counts as active until it records its end or its lease expires.
bool is_held(const std::filesystem::path& part);

/// Interrupts the writer like Ctrl-C. Call this only once, because a second interrupt ends the process immediately.
/// Returns false if there is no writer.
bool interrupt_writer(const std::filesystem::path& part);

}  // namespace lippmann
