// Feeds bytes to the reader of job files. Whatever they are, they either throw Error or give parameters that, written as a job
// and read again, are the same.
//
// fuzz/job_seeds SEEDS && fuzz_job -dict=fuzz/job.dict CORPUS SEEDS; or scripts/fuzz job.
#include <cstdlib>
#include <iostream>

#include "file_in_memory.hpp"
#include "job/job_file.hpp"
#include "lippmann/core/error.hpp"

using namespace lippmann;

namespace {

/// As a job in the folder that the file of all inputs lies in. Throws Error.
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
    std::cerr << "a job that was accepted:\n" << text << "is another one when it is read again:\n" << again;
  } catch (const Error& error) {
    std::cerr << "a job that was written is not read: " << error.what() << '\n' << text;
  }
  std::abort();
}
