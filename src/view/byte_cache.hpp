// Caches byte strings made on demand, with eviction of the least recently used.
#pragma once

#include <cstddef>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <string>

namespace lippmann {

using Bytes = std::shared_ptr<const std::string>;

/// Thread-safe. Only one thread at a time makes a missing entry, which bounds the memory in use.
class ByteCache {
 public:
  explicit ByteCache(std::size_t most_bytes) : most_bytes_(most_bytes) {}

  /// Returns the entry of `key`, made by `make` if it is missing. Exceptions of `make` are passed on, and nothing is cached.
  Bytes get(const std::string& key, const std::function<std::string()>& make);

 private:
  struct Entry {
    std::string key;
    Bytes bytes;
  };

  Bytes find(const std::string& key);
  void keep(const std::string& key, const Bytes& bytes);

  const std::size_t most_bytes_;
  std::mutex making_;
  std::mutex entries_mutex_;
  std::list<Entry> entries_;  ///< the most recently used first
  std::map<std::string, std::list<Entry>::iterator> by_key_;
  std::size_t bytes_ = 0;
};

}  // namespace lippmann
