// Simulates a disk that keeps only synced data when the power fails. The bytes of a file are safe after sync() of the
// file, its name after sync() of its folder. Other changes survive at random, in whole or in part. Functions return
// negative errno values as errors.
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
  int machine = -1;
  std::int64_t written = 0;
  std::string bytes, safe;  ///< programs see `bytes`; `safe` survives a power failure
  std::map<std::string, int> entries, safe_entries;
};

class Disk {
 public:
  Disk();

  /// Returns the number of the inode, or an error. Paths are absolute.
  int find(std::string_view path) const;
  int create_file(std::string_view path);
  int make_folder(std::string_view path);
  int remove(std::string_view path, bool folder);
  int rename(std::string_view from, std::string_view to);
  int link(std::string_view from, std::string_view to);

  Inode& at(int inode) { return inodes_[static_cast<std::size_t>(inode)]; }
  void sync(int inode);

  void lose_power(Random& random);
  void lose_machine(int machine, Random& random);

 private:
  struct Change {  ///< a change of a folder's entries that is not yet synced
    int folder;
    std::string removed, added;
    int inode;
  };
  struct Place {
    int folder;
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
