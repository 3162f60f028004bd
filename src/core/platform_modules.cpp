#include <dlfcn.h>

#include "core/platform.hpp"

namespace lippmann::platform {

std::filesystem::path program_file() {
  std::error_code ignored;
  return std::filesystem::read_symlink("/proc/self/exe", ignored);
}

std::filesystem::path file_of_code(const void* address) {
  Dl_info info;
  if (dladdr(address, &info) == 0 || !info.dli_fname) return {};
  std::error_code ignored;
  return std::filesystem::canonical(info.dli_fname, ignored);
}

void* load_library(const std::filesystem::path& file, std::string& problem) {
  void* loaded = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!loaded) problem = dlerror();
  return loaded;
}

void* find_symbol(void* library, const char* name) { return dlsym(library, name); }

}  // namespace lippmann::platform
