// What was made on demand and may be asked for again: byte strings by key, the least recently used given up first.
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

/// Thread-safe. What is missing is made by one thread at a time, which bounds the memory that making takes.
class ByteCache {
 public:
  explicit ByteCache(std::size_t most_bytes) : most_bytes_(most_bytes) {}

  /// What `make` throws is passed on, and nothing is kept.
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
