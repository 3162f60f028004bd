// The reader of job files must throw Error, or return parameters that stay the same when they are written to a job file and
// read again.
//
// fuzz/job_seeds SEEDS && fuzz_job -dict=fuzz/job.dict CORPUS SEEDS; or scripts/fuzz job.
#include <cstdlib>
#include <iostream>

#include "file_in_memory.hpp"
#include "job/job_file.hpp"
#include "lippmann/core/error.hpp"

using namespace lippmann;

namespace {

/// Parses a job file and writes it as text. Paths are relative to the folder of the input file. Throws Error.
std::string read(const std::filesystem::path& file) {
  RenderParams params;
  read_job(file, params);
  return job_text(params, file.parent_path());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  static const FileInMemory file;
  std::string text;
  try {
    text = read(file.with(data, size));
  } catch (const Error&) {
    return 0;
  }
  try {
    const std::string again = read(file.with(reinterpret_cast<const unsigned char*>(text.data()), text.size()));
    if (again == text) return 0;
    std::cerr << "an accepted job:\n" << text << "changes when it is written and read again:\n" << again;
  } catch (const Error& error) {
    std::cerr << "a written job cannot be read: " << error.what() << '\n' << text;
  }
  std::abort();
}
