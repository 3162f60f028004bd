#include "scene/tachyon.hpp"

#include "core/error.hpp"

namespace lippmann {

Scene load_tachyon(const std::filesystem::path& path, const std::optional<std::filesystem::path>&, const Context&, double) {
  throw Error(path.string(), "Tachyon scenes cannot be read yet");
}

}  // namespace lippmann
