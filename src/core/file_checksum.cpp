#include "core/file_checksum.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>
#include <xxhash.h>

#include <cerrno>
#include <memory>

namespace lippmann {
namespace {

struct StateDeleter {
  void operator()(XXH3_state_t* state) const { XXH3_freeState(state); }
};

class OpenFile {
 public:
  /// Without waiting for the other end of a FIFO.
  explicit OpenFile(const char* path) : descriptor_(open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC)) {}
  ~OpenFile() {
    if (descriptor_ >= 0) close(descriptor_);
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  bool is_regular() const {
    struct stat status {};
    return descriptor_ >= 0 && fstat(descriptor_, &status) == 0 && S_ISREG(status.st_mode);
  }
  int descriptor() const { return descriptor_; }

 private:
  int descriptor_;
};

std::string digits_of(XXH64_hash_t hash) { return fmt::format("{:016x}", hash); }

}  // namespace

FileChecksum checksum_of(std::span<const std::byte> bytes) {
  return {bytes.size(), digits_of(XXH3_64bits(bytes.data(), bytes.size()))};
}

std::optional<FileChecksum> file_checksum(const std::filesystem::path& path) {
  constexpr std::size_t kBufferBytes = std::size_t{1} << 18;
  const OpenFile file(path.c_str());
  const std::unique_ptr<XXH3_state_t, StateDeleter> state(XXH3_createState());
  if (!file.is_regular() || !state || XXH3_64bits_reset(state.get()) != XXH_OK) return std::nullopt;
  const auto buffer = std::make_unique_for_overwrite<char[]>(kBufferBytes);
  FileChecksum sum;
  for (;;) {
    const ssize_t count = read(file.descriptor(), buffer.get(), kBufferBytes);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return std::nullopt;
    if (count == 0) break;
    XXH3_64bits_update(state.get(), buffer.get(), static_cast<std::size_t>(count));
    sum.bytes += static_cast<std::uint64_t>(count);
  }
  sum.xxh3 = digits_of(XXH3_64bits_digest(state.get()));
  return sum;
}

}  // namespace lippmann
