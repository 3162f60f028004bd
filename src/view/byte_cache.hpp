// Caches byte strings that are made on demand. The least recently used entries are evicted.
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

  /// Calls `make` if the entry is missing. If `make` throws, nothing is cached.
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
  std::list<Entry> entries_;
  std::map<std::string, std::list<Entry>::iterator> by_key_;
  std::size_t bytes_ = 0;
};

}  // namespace lippmann
