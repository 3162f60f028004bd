// A 64-bit number that tells contents apart, for caches and journals: equal contents give equal numbers on every machine of one
// byte order. It is quick, and no protection against anybody.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>

namespace lippmann {

class Fingerprint {
 public:
  /// Contents and their length.
  void add_bytes(const void* bytes, std::size_t size) {
    mix(size);
    const auto* at = static_cast<const unsigned char*>(bytes);
    for (; size >= sizeof(std::uint64_t); at += sizeof(std::uint64_t), size -= sizeof(std::uint64_t)) mix(word(at, 8));
    if (size > 0) mix(word(at, size));
  }

  void add(std::string_view text) { add_bytes(text.data(), text.size()); }

  template <class T>
  requires std::is_arithmetic_v<T> || std::is_enum_v<T>
  void add(T value) { mix(word(reinterpret_cast<const unsigned char*>(&value), sizeof(T))); }

  std::uint64_t value() const { return state_; }

 private:
  static std::uint64_t word(const unsigned char* bytes, std::size_t size) {
    std::uint64_t value = 0;
    std::memcpy(&value, bytes, size);
    return value;
  }

  /// FNV-1a's step on words, with the upper half folded back so that every bit reaches every other.
  void mix(std::uint64_t value) {
    state_ = (state_ ^ value) * 0x9e3779b97f4a7c15u;
    state_ ^= state_ >> 32;
  }

  std::uint64_t state_ = 0xcbf29ce484222325u;
};

}  // namespace lippmann
