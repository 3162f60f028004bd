// A library for LD_PRELOAD: the LIPPMANN_FAIL_WRITE-th write of the process to a regular file fails, as on a disk that is full
// for a moment; with LIPPMANN_FAIL_ALL all that follow fail too. When one has, a file LIPPMANN_FAILED is there. What the
// program prints goes to pipes and is left alone.
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdlib>

namespace {

bool fails(int descriptor) {
  static std::atomic<long> writes{0};
  static const long failing = std::getenv("LIPPMANN_FAIL_WRITE") ? std::atol(std::getenv("LIPPMANN_FAIL_WRITE")) : 0;
  struct stat status {};
  if (fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode)) return false;
  const long number = ++writes;
  if (std::getenv("LIPPMANN_FAIL_ALL") ? number < failing : number != failing) return false;
  close(open(std::getenv("LIPPMANN_FAILED"), O_WRONLY | O_CREAT, 0600));
  errno = ENOSPC;
  return true;
}

template <class Function>
Function* next(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

}  // namespace

extern "C" {

ssize_t write(int descriptor, const void* bytes, size_t count) {
  static const auto real = next<ssize_t(int, const void*, size_t)>("write");
  return fails(descriptor) ? -1 : real(descriptor, bytes, count);
}

ssize_t writev(int descriptor, const iovec* pieces, int count) {
  static const auto real = next<ssize_t(int, const iovec*, int)>("writev");
  return fails(descriptor) ? -1 : real(descriptor, pieces, count);
}

ssize_t pwrite(int descriptor, const void* bytes, size_t count, off_t at) {
  static const auto real = next<ssize_t(int, const void*, size_t, off_t)>("pwrite");
  return fails(descriptor) ? -1 : real(descriptor, bytes, count, at);
}

ssize_t pwrite64(int descriptor, const void* bytes, size_t count, off64_t at) {
  static const auto real = next<ssize_t(int, const void*, size_t, off64_t)>("pwrite64");
  return fails(descriptor) ? -1 : real(descriptor, bytes, count, at);
}
}
