// A disk in memory that keeps only synced data when the power fails.
//
// A file's bytes are safe after sync() of the file; its name is safe after sync() of its folder. When power fails, unsafe data
// survives, is lost or is torn at random: a renamed file may be empty, the end of a file may be zeros, a name may be the old
// one. Errors are negative errno values.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "simulation/random.hpp"

namespace lippmann::test {

struct Inode {
  bool is_folder = false;
  int machine = -1;          ///< that wrote last
  std::int64_t written = 0;  ///< time of the last write, in nanoseconds since 1970
  std::string bytes, safe;   ///< bytes seen by programs; bytes that survive
  std::map<std::string, int> entries, safe_entries;
};

class Disk {
 public:
  Disk();

  /// Returns an inode's number or an error. Paths are absolute.
  int find(std::string_view path) const;
  int create_file(std::string_view path);
  int make_folder(std::string_view path);
  int remove(std::string_view path, bool folder);
  int rename(std::string_view from, std::string_view to);
  int link(std::string_view from, std::string_view to);

  Inode& at(int inode) { return inodes_[static_cast<std::size_t>(inode)]; }
  void sync(int inode);

  /// Keeps or loses all unsafe data at random.
  void lose_power(Random& random);
  /// Keeps or loses unsynced bytes written by this machine; the disk belongs to another machine, which continues.
  void lose_machine(int machine, Random& random);

 private:
  struct Change {  ///< unsafe change of a folder's entries
    int folder;
    std::string removed, added;
    int inode;
  };
  struct Place {
    int folder;  ///< or an error
    std::string name;
  };

  Place place_of(std::string_view path) const;
  int add(std::string_view path, bool is_folder);
  void change(Change change);
  void apply(const Change& change, std::map<std::string, int> Inode::*entries);

  std::vector<Inode> inodes_;
  std::vector<Change> unsafe_;
};

}  // namespace lippmann::test
