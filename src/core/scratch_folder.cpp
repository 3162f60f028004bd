#include "core/scratch_folder.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>
#include <system_error>

#include "lippmann/core/error.hpp"

namespace lippmann {

ScratchFolder::ScratchFolder() {
  std::error_code ignored;
  const std::filesystem::path place = std::filesystem::temp_directory_path(ignored);
  std::string pattern = (place / "lippmann-XXXXXX").string();
  if (place.empty() || !mkdtemp(pattern.data()))
    throw Error(place.empty() ? "TMPDIR" : place.string(),
                std::string("no folder can be made there for files that are thrown away: ") + std::strerror(errno),
                "a TMPDIR that can be written");
  path_ = pattern;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace lippmann
