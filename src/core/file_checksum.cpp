#include "core/file_checksum.hpp"

#include <fmt/core.h>
#include <xxhash.h>

#include <memory>

#include "core/regular_file.hpp"

namespace lippmann {
namespace {

struct StateDeleter {
  void operator()(XXH3_state_t* state) const { XXH3_freeState(state); }
};

std::string digits_of(XXH64_hash_t hash) { return fmt::format("{:016x}", hash); }

}  // namespace

FileChecksum checksum_of(std::span<const std::byte> bytes) {
  return {bytes.size(), digits_of(XXH3_64bits(bytes.data(), bytes.size()))};
}

std::optional<FileChecksum> file_checksum(const std::filesystem::path& path) {
  constexpr std::size_t kBufferBytes = std::size_t{1} << 18;
  RegularFile file(path);
  const std::unique_ptr<XXH3_state_t, StateDeleter> state(XXH3_createState());
  if (!file.problem().empty() || !state || XXH3_64bits_reset(state.get()) != XXH_OK) return std::nullopt;
  const auto buffer = std::make_unique_for_overwrite<char[]>(kBufferBytes);
  FileChecksum sum;
  while (const std::size_t count = file.read(buffer.get(), kBufferBytes)) {
    XXH3_64bits_update(state.get(), buffer.get(), count);
    sum.bytes += count;
  }
  if (!file.problem().empty()) return std::nullopt;
  sum.xxh3 = digits_of(XXH3_64bits_digest(state.get()));
  return sum;
}

}  // namespace lippmann
