// Replaces system calls of the C library. Paths below /sim/ go to the simulated world, all others to the operating
// system.
#include <dirent.h>
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <iterator>
#include <string>
#include <string_view>

#include "simulation/world.hpp"

namespace lippmann::test {
namespace {

template <class Function>
Function* real(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

struct OpenFile {
  bool is_used = false, appends = false;
  int inode = -1;
  std::size_t at = 0;
};

constexpr int kFirstDescriptor = 1 << 20;  // larger than any real file descriptor
std::array<OpenFile, 1024> open_files;

struct OpenFolder {
  bool is_used = false;
  int descriptor = -1;
  std::vector<std::pair<std::string, bool>> entries;
  std::size_t next = 0;
  dirent entry{};
};

std::array<OpenFolder, 64> folders;

OpenFile* file_of(int descriptor) {
  const int index = descriptor - kFirstDescriptor;
  return index >= 0 && index < static_cast<int>(open_files.size()) ? &open_files[static_cast<std::size_t>(index)] : nullptr;
}

OpenFile* file_of(FILE* stream) {
  auto* file = reinterpret_cast<OpenFile*>(stream);
  return std::less_equal<>()(open_files.data(), file) && std::less<>()(file, open_files.data() + open_files.size()) ? file
                                                                                                                    : nullptr;
}

OpenFolder* folder_of(DIR* stream) {
  auto* folder = reinterpret_cast<OpenFolder*>(stream);
  return std::less_equal<>()(folders.data(), folder) && std::less<>()(folder, folders.data() + folders.size()) ? folder
                                                                                                               : nullptr;
}

int descriptor_of(const OpenFile* file) { return kFirstDescriptor + static_cast<int>(file - open_files.data()); }

bool is_simulated(const char* path) { return world() && path && std::string_view(path).starts_with("/sim"); }

int fail(int error) {
  errno = error;
  return -1;
}

int result(int error) { return error < 0 ? fail(-error) : 0; }

/// Makes the calling function return `failure` if the simulation lets this call fail.
#define LIPPMANN_CALL(kind, failure) \
  if (const int problem = world()->before(World::Call::kind)) return errno = problem, failure

Inode& inode_of(const OpenFile& file) { return world()->disk.at(file.inode); }

int open_simulated(const char* path, int flags) {
  const bool reads = (flags & O_ACCMODE) == O_RDONLY && (flags & O_CREAT) == 0;
  if (const int problem = world()->before(reads ? World::Call::kRead : World::Call::kWrite)) return fail(problem);
  Disk& disk = world()->disk;
  int inode = disk.find(path);
  if (inode >= 0 && (flags & O_CREAT) && (flags & O_EXCL)) return fail(EEXIST);
  if (inode == -ENOENT && (flags & O_CREAT)) inode = disk.create_file(path);
  if (inode < 0) return fail(-inode);
  if (disk.at(inode).is_folder && (flags & O_ACCMODE) != O_RDONLY) return fail(EISDIR);
  if (!disk.at(inode).is_folder && (flags & O_DIRECTORY)) return fail(ENOTDIR);
  if (flags & O_TRUNC) disk.at(inode).bytes.clear();
  const auto free = std::find_if(open_files.begin(), open_files.end(), [](const OpenFile& file) { return !file.is_used; });
  if (free == open_files.end()) std::abort();
  *free = {true, (flags & O_APPEND) != 0, inode, 0};
  return descriptor_of(&*free);
}

FILE* open_simulated(const char* path, const char* mode) {
  int flags = std::strchr(mode, '+') ? O_RDWR : mode[0] == 'r' ? O_RDONLY : O_WRONLY;
  if (mode[0] != 'r') flags |= O_CREAT | (mode[0] == 'a' ? O_APPEND : O_TRUNC);
  const int descriptor = open_simulated(path, flags);
  return descriptor < 0 ? nullptr : reinterpret_cast<FILE*>(file_of(descriptor));
}

ssize_t read_simulated(OpenFile& file, void* to, std::size_t count) {
  LIPPMANN_CALL(kRead, -1);
  const std::string& bytes = inode_of(file).bytes;
  if (inode_of(file).is_folder) return fail(EISDIR);
  count = std::min(count, bytes.size() - std::min(file.at, bytes.size()));
  count = world()->moved(count);
  std::memcpy(to, bytes.data() + file.at, count);
  file.at += count;
  return static_cast<ssize_t>(count);
}

ssize_t write_simulated(OpenFile& file, const void* from, std::size_t count) {
  LIPPMANN_CALL(kWrite, -1);
  Inode& inode = inode_of(file);
  count = world()->moved(count);
  if (file.appends) file.at = inode.bytes.size();
  if (inode.bytes.size() < file.at + count) inode.bytes.resize(file.at + count);
  std::memcpy(inode.bytes.data() + file.at, from, count);
  file.at += count;
  if (world()->current()) inode.machine = world()->current()->machine, inode.written = world()->nanoseconds(inode.machine);
  return static_cast<ssize_t>(count);
}

int close_simulated(OpenFile& file) {
  file = {};
  LIPPMANN_CALL(kOther, -1);
  return 0;
}

int sync_simulated(const OpenFile& file) {
  LIPPMANN_CALL(kWrite, -1);
  world()->disk.sync(file.inode);
  return 0;
}

off64_t seek_simulated(OpenFile& file, off64_t offset, int from) {
  const std::size_t size = inode_of(file).bytes.size();
  file.at = static_cast<std::size_t>(offset) + (from == SEEK_SET ? 0 : from == SEEK_CUR ? file.at : size);
  return static_cast<off64_t>(file.at);
}

void fill(const Inode& inode, int number, struct stat64& status) {
  status = {};
  status.st_mode = inode.is_folder ? S_IFDIR | 0755 : S_IFREG | 0644;
  status.st_size = static_cast<off64_t>(inode.bytes.size());
  status.st_ino = static_cast<ino_t>(number) + 1, status.st_dev = 1u << 30, status.st_nlink = 1;
  status.st_mtim = {inode.written / 1'000'000'000, inode.written % 1'000'000'000};
}

int stat_simulated(const char* path, struct stat64& status) {
  LIPPMANN_CALL(kOther, -1);
  const int inode = world()->disk.find(path);
  if (inode < 0) return fail(-inode);
  fill(world()->disk.at(inode), inode, status);
  return 0;
}

DIR* list_simulated(int descriptor) {
  const auto free = std::find_if(folders.begin(), folders.end(), [](const OpenFolder& folder) { return !folder.is_used; });
  if (free == folders.end()) std::abort();
  *free = {true, descriptor, {}, 0, {}};
  for (const auto& [name, inode] : inode_of(*file_of(descriptor)).entries)
    free->entries.emplace_back(name, world()->disk.at(inode).is_folder);
  return reinterpret_cast<DIR*>(&*free);
}

dirent* next_entry(OpenFolder& folder) {
  LIPPMANN_CALL(kRead, nullptr);
  if (folder.next == folder.entries.size()) return nullptr;
  const auto& [name, is_folder] = folder.entries[folder.next++];
  folder.entry.d_type = is_folder ? DT_DIR : DT_REG;
  std::strncpy(static_cast<char*>(folder.entry.d_name), name.c_str(), sizeof(folder.entry.d_name) - 1);
  return &folder.entry;
}

int remove_simulated(const char* path, bool folder) {
  LIPPMANN_CALL(kOther, -1);
  return result(world()->disk.remove(path, folder));
}

mode_t mode_of(int flags, va_list rest) { return (flags & O_CREAT) != 0 ? va_arg(rest, mode_t) : mode_t{0}; }

}  // namespace
}  // namespace lippmann::test

using namespace lippmann::test;

extern "C" {

#define LIPPMANN_OPEN(name)                                                              \
  int name(const char* path, int flags, ...) {                                           \
    static const auto actual = real<int(const char*, int, ...)>(#name);                  \
    va_list rest;                                                                        \
    va_start(rest, flags);                                                               \
    const mode_t mode = mode_of(flags, rest);                                            \
    va_end(rest);                                                                        \
    return is_simulated(path) ? open_simulated(path, flags) : actual(path, flags, mode); \
  }
LIPPMANN_OPEN(open)
LIPPMANN_OPEN(open64)

/// Code compiled with _FORTIFY_SOURCE calls this instead of `open`, and __openat_2 instead of `openat`.
int __open_2(const char* path, int flags) { return open(path, flags); }

int openat(int folder, const char* path, int flags, ...) {
  static const auto actual = real<int(int, const char*, int, ...)>("openat");
  va_list rest;
  va_start(rest, flags);
  const mode_t mode = mode_of(flags, rest);
  va_end(rest);
  return is_simulated(path) ? open_simulated(path, flags) : actual(folder, path, flags, mode);
}

int __openat_2(int folder, const char* path, int flags) { return openat(folder, path, flags); }

FILE* fopen(const char* path, const char* mode) {
  static const auto actual = real<FILE*(const char*, const char*)>("fopen");
  return is_simulated(path) ? open_simulated(path, mode) : actual(path, mode);
}

FILE* fopen64(const char* path, const char* mode) {
  static const auto actual = real<FILE*(const char*, const char*)>("fopen64");
  return is_simulated(path) ? open_simulated(path, mode) : actual(path, mode);
}

int fclose(FILE* stream) {
  static const auto actual = real<int(FILE*)>("fclose");
  OpenFile* file = file_of(stream);
  return file ? close_simulated(*file) : actual(stream);
}

int fflush(FILE* stream) {
  static const auto actual = real<int(FILE*)>("fflush");
  return file_of(stream) ? 0 : actual(stream);
}

int fileno(FILE* stream) noexcept {
  static const auto actual = real<int(FILE*)>("fileno");
  const OpenFile* file = file_of(stream);
  return file ? descriptor_of(file) : actual(stream);
}

int close(int descriptor) {
  static const auto actual = real<int(int)>("close");
  OpenFile* file = file_of(descriptor);
  return file ? close_simulated(*file) : actual(descriptor);
}

ssize_t read(int descriptor, void* to, size_t count) {
  static const auto actual = real<ssize_t(int, void*, size_t)>("read");
  OpenFile* file = file_of(descriptor);
  return file ? read_simulated(*file, to, count) : actual(descriptor, to, count);
}

ssize_t write(int descriptor, const void* from, size_t count) {
  static const auto actual = real<ssize_t(int, const void*, size_t)>("write");
  OpenFile* file = file_of(descriptor);
  return file ? write_simulated(*file, from, count) : actual(descriptor, from, count);
}

ssize_t writev(int descriptor, const iovec* pieces, int count) {
  static const auto actual = real<ssize_t(int, const iovec*, int)>("writev");
  OpenFile* file = file_of(descriptor);
  if (!file) return actual(descriptor, pieces, count);
  std::string bytes;
  for (int i = 0; i < count; ++i) bytes.append(static_cast<const char*>(pieces[i].iov_base), pieces[i].iov_len);
  return write_simulated(*file, bytes.data(), bytes.size());
}

off64_t lseek64(int descriptor, off64_t offset, int from) noexcept {
  static const auto actual = real<off64_t(int, off64_t, int)>("lseek64");
  OpenFile* file = file_of(descriptor);
  return file ? seek_simulated(*file, offset, from) : actual(descriptor, offset, from);
}

int ioctl(int descriptor, unsigned long request, ...) noexcept {
  static const auto actual = real<int(int, unsigned long, ...)>("ioctl");
  va_list rest;
  va_start(rest, request);
  void* argument = va_arg(rest, void*);
  va_end(rest);
  return file_of(descriptor) ? fail(ENOTTY) : actual(descriptor, request, argument);
}

int fsync(int descriptor) {
  static const auto actual = real<int(int)>("fsync");
  const OpenFile* file = file_of(descriptor);
  return file ? sync_simulated(*file) : actual(descriptor);
}

int fdatasync(int descriptor) {
  static const auto actual = real<int(int)>("fdatasync");
  const OpenFile* file = file_of(descriptor);
  return file ? sync_simulated(*file) : actual(descriptor);
}

int fchmod(int descriptor, mode_t mode) noexcept {
  static const auto actual = real<int(int, mode_t)>("fchmod");
  return file_of(descriptor) ? 0 : actual(descriptor, mode);
}

static_assert(sizeof(struct stat) == sizeof(struct stat64));

int fstat64(int descriptor, struct stat64* status) noexcept {
  static const auto actual = real<int(int, struct stat64*)>("fstat64");
  const OpenFile* file = file_of(descriptor);
  if (!file) return actual(descriptor, status);
  fill(inode_of(*file), file->inode, *status);
  return 0;
}

int fstat(int descriptor, struct stat* status) noexcept {
  return fstat64(descriptor, reinterpret_cast<struct stat64*>(status));
}

#define LIPPMANN_STAT(name, type)                                           \
  int name(const char* path, type* status) noexcept {                       \
    static const auto actual = real<int(const char*, type*)>(#name);        \
    if (!is_simulated(path)) return actual(path, status);                   \
    return stat_simulated(path, *reinterpret_cast<struct stat64*>(status)); \
  }
LIPPMANN_STAT(stat, struct stat)
LIPPMANN_STAT(stat64, struct stat64)
LIPPMANN_STAT(lstat, struct stat)
LIPPMANN_STAT(lstat64, struct stat64)

int access(const char* path, int mode) noexcept {
  static const auto actual = real<int(const char*, int)>("access");
  if (!is_simulated(path)) return actual(path, mode);
  struct stat64 status;
  return stat_simulated(path, status);
}

int mkdir(const char* path, mode_t mode) noexcept {
  static const auto actual = real<int(const char*, mode_t)>("mkdir");
  if (!is_simulated(path)) return actual(path, mode);
  LIPPMANN_CALL(kWrite, -1);
  return result(world()->disk.make_folder(path));
}

int unlink(const char* path) noexcept {
  static const auto actual = real<int(const char*)>("unlink");
  return is_simulated(path) ? remove_simulated(path, false) : actual(path);
}

int rmdir(const char* path) noexcept {
  static const auto actual = real<int(const char*)>("rmdir");
  return is_simulated(path) ? remove_simulated(path, true) : actual(path);
}

int remove(const char* path) noexcept {
  static const auto actual = real<int(const char*)>("remove");
  if (!is_simulated(path)) return actual(path);
  const int inode = world()->disk.find(path);
  return remove_simulated(path, inode >= 0 && world()->disk.at(inode).is_folder);
}

int rename(const char* from, const char* to) noexcept {
  static const auto actual = real<int(const char*, const char*)>("rename");
  if (!is_simulated(from)) return actual(from, to);
  LIPPMANN_CALL(kWrite, -1);
  return result(world()->disk.rename(from, to));
}

int link(const char* from, const char* to) noexcept {
  static const auto actual = real<int(const char*, const char*)>("link");
  if (!is_simulated(from)) return actual(from, to);
  LIPPMANN_CALL(kWrite, -1);
  return result(world()->disk.link(from, to));
}

ssize_t sendfile(int to, int from, off_t* offset, size_t count) noexcept {
  static const auto actual = real<ssize_t(int, int, off_t*, size_t)>("sendfile");
  return file_of(to) || file_of(from) ? fail(EINVAL) : actual(to, from, offset, count);
}

DIR* fdopendir(int descriptor) {
  static const auto actual = real<DIR*(int)>("fdopendir");
  return file_of(descriptor) ? list_simulated(descriptor) : actual(descriptor);
}

DIR* opendir(const char* path) {
  static const auto actual = real<DIR*(const char*)>("opendir");
  if (!is_simulated(path)) return actual(path);
  const int descriptor = open_simulated(path, O_RDONLY | O_DIRECTORY);
  return descriptor < 0 ? nullptr : list_simulated(descriptor);
}

dirent* readdir(DIR* stream) {
  static const auto actual = real<dirent*(DIR*)>("readdir");
  OpenFolder* folder = folder_of(stream);
  return folder ? next_entry(*folder) : actual(stream);
}

int dirfd(DIR* stream) noexcept {
  static const auto actual = real<int(DIR*)>("dirfd");
  const OpenFolder* folder = folder_of(stream);
  return folder ? folder->descriptor : actual(stream);
}

int closedir(DIR* stream) {
  static const auto actual = real<int(DIR*)>("closedir");
  OpenFolder* folder = folder_of(stream);
  if (!folder) return actual(stream);
  *file_of(folder->descriptor) = {};
  *folder = {};
  return 0;
}

pid_t getpid() noexcept {
  static const auto actual = real<pid_t()>("getpid");
  return world() && world()->current() ? world()->current()->pid : actual();
}

int gethostname(char* name, size_t size) noexcept {
  static const auto actual = real<int(char*, size_t)>("gethostname");
  if (!world() || !world()->current()) return actual(name, size);
  std::strncpy(name, world()->machine_name(world()->current()->machine).c_str(), size);
  return 0;
}

int getentropy(void* to, size_t size) {
  static const auto actual = real<int(void*, size_t)>("getentropy");
  if (!world() || !world()->current()) return actual(to, size);
  const std::uint64_t number = world()->random.next();
  std::memcpy(to, &number, std::min(size, sizeof(number)));
  return 0;
}

int kill(pid_t process, int signal) noexcept {
  static const auto actual = real<int(pid_t, int)>("kill");
  if (!world() || !world()->current()) return actual(process, signal);
  return world()->is_alive(world()->current()->machine, process) ? 0 : fail(ESRCH);
}

int nanosleep(const timespec* time, timespec* left) {
  static const auto actual = real<int(const timespec*, timespec*)>("nanosleep");
  if (!world() || !world()->current()) return actual(time, left);
  world()->pass(time->tv_sec * 1'000'000'000 + time->tv_nsec);
  LIPPMANN_CALL(kOther, -1);
  return 0;
}

int clock_gettime(clockid_t clock, timespec* time) noexcept {
  static const auto actual = real<int(clockid_t, timespec*)>("clock_gettime");
  if (!world() || !world()->current()) return actual(clock, time);
  const std::int64_t now = world()->nanoseconds(world()->current()->machine);
  *time = {now / 1'000'000'000, now % 1'000'000'000};
  return 0;
}
}
