#include "view/byte_cache.hpp"

#include <utility>

namespace lippmann {

Bytes ByteCache::get(const std::string& key, const std::function<std::string()>& make) {
  if (Bytes found = find(key)) return found;
  const std::lock_guard lock(making_);
  if (Bytes found = find(key)) return found;  // another thread may have made the entry
  const Bytes made = std::make_shared<const std::string>(make());
  keep(key, made);
  return made;
}

Bytes ByteCache::find(const std::string& key) {
  const std::lock_guard lock(entries_mutex_);
  const auto found = by_key_.find(key);
  if (found == by_key_.end()) return nullptr;
  entries_.splice(entries_.begin(), entries_, found->second);
  return found->second->bytes;
}

void ByteCache::keep(const std::string& key, const Bytes& bytes) {
  if (bytes->size() > most_bytes_) return;
  const std::lock_guard lock(entries_mutex_);
  entries_.push_front({key, bytes});
  by_key_[key] = entries_.begin();
  bytes_ += bytes->size();
  while (bytes_ > most_bytes_) {
    bytes_ -= entries_.back().bytes->size();
    by_key_.erase(entries_.back().key);
    entries_.pop_back();
  }
}

}  // namespace lippmann
