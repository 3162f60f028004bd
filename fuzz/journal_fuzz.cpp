// Reads the input as a journal. Every file that the journal names must be inside the folder, every number must be in its range,
// and writing each entry again must not fail.
//
// fuzz/journal_seeds SEEDS && fuzz_journal -dict=fuzz/journal.dict CORPUS SEEDS; or scripts/fuzz journal.
#include <cstdlib>
#include <iostream>
#include <nlohmann/json.hpp>

#include "file_in_memory.hpp"
#include "folder/journal.hpp"

using namespace lippmann;

namespace {

void require(bool holds, const std::string& what) {
  if (holds) return;
  std::cerr << what << '\n';
  std::abort();
}

void check_names(const FileRecords& files) {
  for (const auto& [name, sum] : files) {
    const std::filesystem::path path(name);
    require(path.is_relative() && !path.empty(), "a frame's file has no relative path:  " + name);
    for (const auto& part : path) require(part != "..", "a file of a frame is outside the folder: " + name);
  }
}

void check_frame(int frame, const JournalEntry& finished) {
  require(frame >= 0 && finished.report.frame == frame, "a frame has another frame's report");
  check_names(finished.files);
  require(!frame_line(finished.report, finished.files).empty(), "a frame cannot be written");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  static const FileInMemory file;
  const FolderJournal journal = read_journal_part(file.with(data, size));
  for (const int frame : journal.asked) require(frame >= 0, "a requested frame is negative");
  for (const auto& [frame, finished] : journal.frames) check_frame(frame, finished);
  for (const auto& [frame, strips] : journal.strips)
    for (const auto& [strip, finished] : strips.finished) {
      require(strip >= 0 && strip < strips.count, "a strip's index is out of range");
      check_frame(frame, finished);
    }
  for (const RunReport& run : journal.runs) require(!to_json(run).dump().empty(), "a run cannot be written");
  return 0;
}
