// A library for LD_PRELOAD that makes system calls fail as on a full disk. LIPPMANN_FAIL_CALL selects the kind: write
// (to a regular file), open (for writing), rename, remove, mkdir, fsync or allocate (memory). Call number
// LIPPMANN_FAIL_NUMBER fails, and with LIPPMANN_FAIL_ALL all later ones. After a failure, the file LIPPMANN_FAILED
// exists. Allocations count from the start of main(), except within dlopen(), because constructors of libraries cannot
// report a failure.
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

bool is_wanted(const char* call) {
  static const char* wanted = std::getenv("LIPPMANN_FAIL_CALL");
  return std::strcmp(wanted ? wanted : "write", call) == 0;
}

/// Counts calls of the selected kind. Returns whether this call must fail.
bool fails(const char* call) {
  static std::atomic<long> calls{0};
  static const long failing = std::getenv("LIPPMANN_FAIL_NUMBER") ? std::atol(std::getenv("LIPPMANN_FAIL_NUMBER")) : 0;
  if (!is_wanted(call)) return false;
  const long number = ++calls;
  if (std::getenv("LIPPMANN_FAIL_ALL") ? number < failing : number != failing) return false;
  close(static_cast<int>(syscall(SYS_openat, AT_FDCWD, std::getenv("LIPPMANN_FAILED"), O_WRONLY | O_CREAT, 0600)));
  errno = ENOSPC;
  return true;
}

bool write_fails(int descriptor) {
  struct stat status {};
  return fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode) && fails("write");
}

bool is_file_of_system(const char* path) { return std::strncmp(path, "/dev/", 5) == 0 || std::strncmp(path, "/proc/", 6) == 0; }

bool open_fails(const char* path, int flags) {
  return (flags & (O_WRONLY | O_RDWR | O_CREAT)) != 0 && !is_file_of_system(path) && fails("open");
}

bool open_fails(const char* path, const char* mode) {
  return std::strpbrk(mode, "wa+") && !is_file_of_system(path) && fails("open");
}

std::atomic<bool> is_in_main{false};
thread_local int loading = 0;

bool allocation_fails() {
  if (!is_in_main || loading > 0 || !fails("allocate")) return false;
  errno = ENOMEM;
  return true;
}

using Main = int(int, char**, char**);
Main* real_main = nullptr;

int counted_main(int argc, char** argv, char** environment) {
  is_in_main = true;
  const int code = real_main(argc, argv, environment);
  is_in_main = false;
  return code;
}

template <class Function>
Function* next(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

}  // namespace

extern "C" {

// Programs that replace malloc() call the C library's allocator by these names.
void* __libc_malloc(size_t bytes);
void* __libc_calloc(size_t count, size_t bytes);
void* __libc_realloc(void* old, size_t bytes);
void* __libc_memalign(size_t alignment, size_t bytes);

ssize_t write(int descriptor, const void* bytes, size_t count) {
  static const auto real = next<ssize_t(int, const void*, size_t)>("write");
  return write_fails(descriptor) ? -1 : real(descriptor, bytes, count);
}

ssize_t writev(int descriptor, const iovec* pieces, int count) {
  static const auto real = next<ssize_t(int, const iovec*, int)>("writev");
  return write_fails(descriptor) ? -1 : real(descriptor, pieces, count);
}

ssize_t pwrite(int descriptor, const void* bytes, size_t count, off_t at) {
  static const auto real = next<ssize_t(int, const void*, size_t, off_t)>("pwrite");
  return write_fails(descriptor) ? -1 : real(descriptor, bytes, count, at);
}

ssize_t pwrite64(int descriptor, const void* bytes, size_t count, off64_t at) {
  static const auto real = next<ssize_t(int, const void*, size_t, off64_t)>("pwrite64");
  return write_fails(descriptor) ? -1 : real(descriptor, bytes, count, at);
}

int open(const char* path, int flags, ...) {
  static const auto real = next<int(const char*, int, ...)>("open");
  va_list rest;
  va_start(rest, flags);
  const auto mode = (flags & O_CREAT) != 0 ? va_arg(rest, mode_t) : mode_t{0};
  va_end(rest);
  return open_fails(path, flags) ? -1 : real(path, flags, mode);
}

int open64(const char* path, int flags, ...) {
  static const auto real = next<int(const char*, int, ...)>("open64");
  va_list rest;
  va_start(rest, flags);
  const auto mode = (flags & O_CREAT) != 0 ? va_arg(rest, mode_t) : mode_t{0};
  va_end(rest);
  return open_fails(path, flags) ? -1 : real(path, flags, mode);
}

FILE* fopen(const char* path, const char* mode) {
  static const auto real = next<FILE*(const char*, const char*)>("fopen");
  return open_fails(path, mode) ? nullptr : real(path, mode);
}

FILE* fopen64(const char* path, const char* mode) {
  static const auto real = next<FILE*(const char*, const char*)>("fopen64");
  return open_fails(path, mode) ? nullptr : real(path, mode);
}

int rename(const char* from, const char* to) {
  static const auto real = next<int(const char*, const char*)>("rename");
  return fails("rename") ? -1 : real(from, to);
}

int remove(const char* path) {
  static const auto real = next<int(const char*)>("remove");
  return fails("remove") ? -1 : real(path);
}

int mkdir(const char* path, mode_t mode) {
  static const auto real = next<int(const char*, mode_t)>("mkdir");
  return fails("mkdir") ? -1 : real(path, mode);
}

int fsync(int descriptor) {
  static const auto real = next<int(int)>("fsync");
  return fails("fsync") ? -1 : real(descriptor);
}

void* malloc(size_t bytes) { return allocation_fails() ? nullptr : __libc_malloc(bytes); }
void* calloc(size_t count, size_t bytes) { return allocation_fails() ? nullptr : __libc_calloc(count, bytes); }
void* realloc(void* old, size_t bytes) { return allocation_fails() ? nullptr : __libc_realloc(old, bytes); }
void* memalign(size_t alignment, size_t bytes) { return allocation_fails() ? nullptr : __libc_memalign(alignment, bytes); }
void* aligned_alloc(size_t alignment, size_t bytes) { return memalign(alignment, bytes); }
int posix_memalign(void** result, size_t alignment, size_t bytes) {
  void* memory = memalign(alignment, bytes);
  if (memory) *result = memory;
  return memory ? 0 : ENOMEM;
}

void* dlopen(const char* file, int mode) {
  static const auto real = next<void*(const char*, int)>("dlopen");
  ++loading;
  void* library = real(file, mode);
  --loading;
  return library;
}

int __libc_start_main(Main* main, int argc, char** argv, void (*init)(), void (*fini)(), void (*rtld_fini)(), void* stack) {
  using Start = int(Main*, int, char**, void (*)(), void (*)(), void (*)(), void*);
  real_main = main;
  return next<Start>("__libc_start_main")(counted_main, argc, argv, init, fini, rtld_fini, stack);
}
}
