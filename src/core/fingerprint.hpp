// A 64-bit hash of contents for caches and journals, equal on all machines of the same byte order. It is not cryptographic.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>

namespace lippmann {

class Fingerprint {
 public:
  /// Adds bytes, and their number, to the hash.
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

  /// XORs a value into the state and multiplies the state, like FNV-1a but with words of 64 bits instead of bytes. Then XORs
  /// the upper half of the product into its lower half, because the upper bits of a factor do not affect the lower bits of the
  /// product.
  void mix(std::uint64_t value) {
    state_ = (state_ ^ value) * 0x9e3779b97f4a7c15u;
    state_ ^= state_ >> 32;
  }

  std::uint64_t state_ = 0xcbf29ce484222325u;
};

}  // namespace lippmann
