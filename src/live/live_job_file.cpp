#include "live/live_job_file.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <span>

#include "core/atomic_file.hpp"
#include "core/folder.hpp"
#include "core/regular_file.hpp"
#include "job/job_file.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

constexpr int kMaxNames = 1000;

std::string text_in(const fs::path& file) {
  constexpr std::size_t kMax = 1 << 20;
  return read_file_begin(file, kMax);
}

/// Creates an empty file with an unused name, so that no other process takes the name.
fs::path reserve_name(const fs::path& wanted) {
  for (int i = 1; i <= kMaxNames; ++i) {
    const fs::path file =
        i == 1 ? wanted : wanted.parent_path() / fmt::format("{}-{}{}", wanted.stem().string(), i, wanted.extension().string());
    if (std::FILE* made = std::fopen(file.c_str(), "wx")) return std::fclose(made), file;
    std::error_code ignored;
    if (!fs::exists(file, ignored)) throw Error(file.string(), "cannot be written", "a folder that can be written to");
  }
  throw Error(wanted.string(), "exists, and so do the files numbered after it", "another name");
}

}  // namespace

fs::path LiveJobFile::save(const ResolvedJob& job) {
  make_folder(wanted_.parent_path());
  const bool is_own = !written_.empty() && text_in(written_) == text_;
  const fs::path file = is_own ? written_ : reserve_name(wanted_);
  const std::string text = job_text(job.params(), file.parent_path());
  write_file_atomically(file, std::as_bytes(std::span(text)));
  written_ = file, text_ = text;
  return file;
}

}  // namespace lippmann
