#include "simulation/disk.hpp"

#include <algorithm>
#include <cerrno>
#include <utility>

namespace lippmann::test {
namespace {

/// Returns the bytes of a file after a failure. `safe` are the synced bytes; the rest may be lost, cut or replaced by
/// zeros.
std::string torn(const std::string& safe, const std::string& bytes, Random& random) {
  if (safe == bytes) return bytes;
  const std::size_t begin = bytes.starts_with(safe) ? safe.size() : 0;
  const std::size_t kept = begin + random.below(bytes.size() - begin + 1);
  switch (random.below(4)) {
    case 0:
      return safe;
    case 1:
      return bytes;
    case 2:
      return bytes.substr(0, kept);
    default:
      return bytes.substr(0, kept) + std::string(bytes.size() - kept, '\0');
  }
}

}  // namespace

Disk::Disk() : inodes_(1) { inodes_[0].is_folder = true; }

int Disk::find(std::string_view path) const {
  int inode = 0;
  while (!path.empty()) {
    if (path.front() == '/') {
      path.remove_prefix(1);
      continue;
    }
    const std::string_view name = path.substr(0, path.find('/'));
    path.remove_prefix(name.size());
    const Inode& folder = inodes_[static_cast<std::size_t>(inode)];
    if (!folder.is_folder) return -ENOTDIR;
    if (name == ".") continue;
    const auto found = folder.entries.find(std::string(name));
    if (found == folder.entries.end()) return -ENOENT;
    inode = found->second;
  }
  return inode;
}

Disk::Place Disk::place_of(std::string_view path) const {
  while (path.size() > 1 && path.back() == '/') path.remove_suffix(1);
  const std::size_t slash = path.rfind('/');
  const int folder = find(path.substr(0, slash));
  if (folder >= 0 && !inodes_[static_cast<std::size_t>(folder)].is_folder) return {-ENOTDIR, {}};
  return {folder, std::string(path.substr(slash + 1))};
}

void Disk::apply(const Change& change, std::map<std::string, int> Inode::*entries) {
  std::map<std::string, int>& names = at(change.folder).*entries;
  if (!change.removed.empty()) names.erase(change.removed);
  if (!change.added.empty()) names[change.added] = change.inode;
}

void Disk::change(Change change) {
  apply(change, &Inode::entries);
  unsafe_.push_back(std::move(change));
}

int Disk::add(std::string_view path, bool is_folder) {
  const Place place = place_of(path);
  if (place.folder < 0) return place.folder;
  if (at(place.folder).entries.contains(place.name)) return -EEXIST;
  inodes_.push_back({});
  inodes_.back().is_folder = is_folder;
  const int inode = static_cast<int>(inodes_.size()) - 1;
  change({place.folder, {}, place.name, inode});
  return inode;
}

int Disk::create_file(std::string_view path) { return add(path, false); }
int Disk::make_folder(std::string_view path) { return add(path, true); }

int Disk::remove(std::string_view path, bool folder) {
  const int inode = find(path);
  if (inode < 0) return inode;
  if (at(inode).is_folder != folder) return folder ? -ENOTDIR : -EISDIR;
  if (folder && !at(inode).entries.empty()) return -ENOTEMPTY;
  const Place place = place_of(path);
  change({place.folder, place.name, {}, -1});
  return 0;
}

int Disk::rename(std::string_view from, std::string_view to) {
  const int inode = find(from), there = find(to);
  if (inode < 0) return inode;
  if (there >= 0 && at(there).is_folder != at(inode).is_folder) return -EISDIR;
  const Place source = place_of(from), target = place_of(to);
  if (target.folder < 0) return target.folder;
  if (source.folder != target.folder) return -EXDEV;
  if (source.name != target.name) change({target.folder, source.name, target.name, inode});
  return 0;
}

int Disk::link(std::string_view from, std::string_view to) {
  const int inode = find(from);
  const Place target = place_of(to);
  if (inode < 0 || target.folder < 0) return std::min(inode, target.folder);
  if (at(target.folder).entries.contains(target.name)) return -EEXIST;
  change({target.folder, {}, target.name, inode});
  return 0;
}

void Disk::sync(int inode) {
  at(inode).safe = at(inode).bytes;
  std::erase_if(unsafe_, [&](const Change& change) {
    if (change.folder == inode) apply(change, &Inode::safe_entries);
    return change.folder == inode;
  });
}

void Disk::lose_power(Random& random) {
  const bool in_order = random.once_in(2);
  const std::size_t kept = random.below(unsafe_.size() + 1);
  for (std::size_t i = 0; i < unsafe_.size(); ++i)
    if (in_order ? i < kept : random.once_in(2)) apply(unsafe_[i], &Inode::safe_entries);
  unsafe_.clear();
  for (Inode& inode : inodes_) {
    inode.entries = inode.safe_entries;
    inode.bytes = torn(inode.safe, inode.bytes, random);
    inode.safe = inode.bytes;
  }
}

void Disk::lose_machine(int machine, Random& random) {
  for (Inode& inode : inodes_) {
    if (inode.machine != machine) continue;
    inode.bytes = torn(inode.safe, inode.bytes, random);
    inode.safe = inode.bytes;
  }
}

}  // namespace lippmann::test
