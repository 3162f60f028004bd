// A disk in memory that keeps, of what programs have written, only what they have synced when the power fails.
//
// A file's bytes are safe after sync() of the file; that it is there under a name, after sync() of its folder. When power
// fails, what is not safe is there, or lost, or torn, as chance has it: a renamed file may be empty, a file's end may be zeros,
// a name may be the old one. Errors are negative numbers of errno.
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
  int machine = -1;          ///< that has written last
  std::int64_t written = 0;  ///< when, in nanoseconds since 1970
  std::string bytes, safe;   ///< as programs see them; as they survive
  std::map<std::string, int> entries, safe_entries;
};

class Disk {
 public:
  Disk();

  /// An inode's number, or an error. Paths are absolute.
  int find(std::string_view path) const;
  int create_file(std::string_view path);
  int make_folder(std::string_view path);
  int remove(std::string_view path, bool folder);
  int rename(std::string_view from, std::string_view to);
  int link(std::string_view from, std::string_view to);

  Inode& at(int inode) { return inodes_[static_cast<std::size_t>(inode)]; }
  void sync(int inode);

  /// Everything that is not safe is left to chance.
  void lose_power(Random& random);
  /// Only bytes that this machine has written and not synced: the disk is another machine's, which goes on.
  void lose_machine(int machine, Random& random);

 private:
  struct Change {  ///< to a folder's entries, not safe yet
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
