#include "core/regular_file.hpp"

#include <system_error>

#include "lippmann/core/error.hpp"

namespace lippmann {

bool is_regular_file_there(const std::filesystem::path& path) {
  std::error_code problem;
  const std::filesystem::file_status status = std::filesystem::status(path, problem);
  if (status.type() == std::filesystem::file_type::regular) return true;
  const bool dangles = std::filesystem::is_symlink(std::filesystem::symlink_status(path, problem));
  if (status.type() == std::filesystem::file_type::not_found && !dangles) return false;
  throw Error(path.string(), "is no regular file that can be read", "a file, or nothing of that name");
}

}  // namespace lippmann
