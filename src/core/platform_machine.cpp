#include <pthread.h>
#include <sched.h>
#include <sys/random.h>
#include <sys/utsname.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <thread>

#include "core/platform.hpp"

#ifdef __SSE2__
#include <xmmintrin.h>
#endif

namespace lippmann::platform {
namespace {

double seconds_of(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace

std::string cpu_model() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name")) return line.substr(line.find(": ") + 2);
  return "unknown";
}

int usable_cpus() {
#ifdef CPU_COUNT
  cpu_set_t set;
  CPU_ZERO(&set);
  if (sched_getaffinity(0, sizeof(set), &set) == 0) return std::max(1, CPU_COUNT(&set));
#endif
  return static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
}

int online_cpus() { return std::max(1, static_cast<int>(sysconf(_SC_NPROCESSORS_ONLN))); }

#if defined(__SSE2__)

unsigned flush_denormals() {
  constexpr unsigned kFlushToZero = 0x8000, kDenormalsAreZero = 0x0040;
  const unsigned control = _mm_getcsr();
  _mm_setcsr(control | kFlushToZero | kDenormalsAreZero);
  return control;
}

void restore_float_control(unsigned control) { _mm_setcsr(control); }

#elif defined(__aarch64__)

// Only the lower half of FPCR is saved, because the upper half is reserved.
unsigned flush_denormals() {
  constexpr std::uint64_t kFlushToZero = std::uint64_t{1} << 24;
  std::uint64_t control = 0;
  asm volatile("mrs %0, fpcr" : "=r"(control));
  asm volatile("msr fpcr, %0" : : "r"(control | kFlushToZero));
  return static_cast<unsigned>(control);
}

void restore_float_control(unsigned control) { asm volatile("msr fpcr, %0" : : "r"(std::uint64_t{control})); }

#else

unsigned flush_denormals() { return 0; }

void restore_float_control(unsigned) {}

#endif

double process_cpu_seconds() { return seconds_of(CLOCK_PROCESS_CPUTIME_ID); }

double thread_cpu_seconds() { return seconds_of(CLOCK_THREAD_CPUTIME_ID); }

ThreadClock::ThreadClock() {
  clockid_t clock{};
  pthread_getcpuclockid(pthread_self(), &clock);
  clock_ = clock;
}

double ThreadClock::seconds() const { return seconds_of(static_cast<clockid_t>(clock_)); }

std::string machine_name() {
  std::array<char, 256> name{};
  return gethostname(name.data(), name.size() - 1) == 0 ? std::string(name.data()) : std::string();
}

std::string host_name() {
  std::string host = machine_name();
  std::erase_if(host, [](unsigned char c) { return !std::isalnum(c) && c != '-'; });
  constexpr std::size_t kMostLetters = 64;  // file names contain the host name and have at most 255 bytes
  return host.empty() ? "host" : host.substr(0, kMostLetters);
}

std::string system_name() {
  utsname system{};
  uname(&system);
  return std::string(system.sysname) + " " + system.release;
}

std::uint32_t random_bits() {
  std::uint32_t number = 0;
  return getentropy(&number, sizeof(number)) == 0 ? number : 0;
}

}  // namespace lippmann::platform
