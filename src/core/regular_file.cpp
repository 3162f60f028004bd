#include "core/regular_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

std::string not_regular(fs::file_type type) {
  using Type = fs::file_type;
  const char* kind = type == Type::directory                          ? "a folder"
                     : type == Type::fifo                             ? "a FIFO"
                     : type == Type::socket                           ? "a socket"
                     : type == Type::character || type == Type::block ? "a device"
                                                                      : "something else";
  return fmt::format("is not a regular file but {}", kind);
}

std::string not_opened(const std::error_code& problem) { return fmt::format("cannot be opened ({})", problem.message()); }

std::string not_read(const std::error_code& problem) { return fmt::format("cannot be read ({})", problem.message()); }

Error unreadable(const RegularFile& file, const fs::path& path, const std::string& accepted) {
  return Error(path.string(), file.exists() ? file.problem() : "there is no such file", accepted);
}

std::string readable_size(std::uintmax_t bytes) {
  constexpr std::uintmax_t kMega = std::uintmax_t{1} << 20;
  return bytes % kMega == 0 ? fmt::format("{} MiB", bytes / kMega) : fmt::format("{} bytes", bytes);
}

template <class Contents>
Contents read_whole(const fs::path& path, std::uintmax_t limit_bytes, const std::string& accepted) {
  RegularFile file(path);
  if (!file.problem().empty()) throw unreadable(file, path, accepted);
  if (file.size() > limit_bytes)
    throw Error(path.string(), fmt::format("is too large: {} bytes", file.size()),
                fmt::format("{} of at most {}", accepted.empty() ? "a file" : accepted, readable_size(limit_bytes)));
  Contents contents(static_cast<std::size_t>(file.size()), {});
  const std::size_t read = file.read(contents.data(), contents.size());
  if (!file.problem().empty()) throw unreadable(file, path, accepted);
  if (read < contents.size())
    throw Error(path.string(), "cannot be read to its end: another program shortened the file meanwhile");
  return contents;
}

}  // namespace

RegularFile::RegularFile(const fs::path& path) {
  std::error_code unopened, unknown;
  file_ = platform::OpenFile(path, platform::OpenFile::Mode::kRead, unopened);
  // If a file cannot be opened, its type may still be known.
  const fs::file_type type = unopened ? fs::status(path, unknown).type() : file_.kind(size_, unknown);
  exists_ = type != fs::file_type::not_found;
  if (!exists_)
    problem_ = "does not exist";
  else if (unknown)
    problem_ = unopened ? not_opened(unknown) : not_read(unknown);
  else if (type != fs::file_type::regular)
    problem_ = not_regular(type);
  else if (unopened)
    problem_ = not_opened(unopened);
  if (!problem_.empty()) size_ = 0;
}

std::size_t RegularFile::read(void* to, std::size_t count) {
  if (!problem_.empty()) return 0;
  std::error_code problem;
  const std::size_t done = file_.read(to, count, problem);
  if (problem) problem_ = not_read(problem);
  return done;
}

std::string read_file_text(const fs::path& path, std::uintmax_t limit_bytes, const std::string& accepted) {
  return read_whole<std::string>(path, limit_bytes, accepted);
}

std::vector<std::byte> read_file_bytes(const fs::path& path, std::uintmax_t limit_bytes, const std::string& accepted) {
  return read_whole<std::vector<std::byte>>(path, limit_bytes, accepted);
}

std::string read_file_begin(const fs::path& path, std::size_t count) {
  RegularFile file(path);
  std::string begin(static_cast<std::size_t>(std::min<std::uintmax_t>(count, file.size())), '\0');
  begin.resize(file.read(begin.data(), begin.size()));
  return begin;
}

void require_regular_file(const fs::path& path, const std::string& accepted) {
  const RegularFile file(path);
  if (!file.problem().empty()) throw unreadable(file, path, accepted);
}

bool is_regular_file_there(const fs::path& path) {
  constexpr const char* kAccepted = "a file, or nothing of that name";
  std::error_code unknown, ignored;
  const fs::file_type type = fs::status(path, unknown).type();
  if (type == fs::file_type::regular) return true;
  const bool is_missing = type == fs::file_type::not_found;
  if (!is_missing && !unknown) throw Error(path.string(), not_regular(type), kAccepted);
  const bool dangles = fs::is_symlink(fs::symlink_status(path, ignored));
  if (is_missing && !dangles) return false;
  throw Error(path.string(), dangles ? "is a link without a target" : fmt::format("cannot be accessed ({})", unknown.message()),
              kAccepted);
}

}  // namespace lippmann
