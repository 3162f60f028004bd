#include "core/host_name.hpp"

#include <unistd.h>

#include <array>
#include <cctype>

namespace lippmann {

std::string host_name() {
  std::array<char, 256> name{};
  if (gethostname(name.data(), name.size() - 1) != 0) return "host";
  std::string host(name.data());
  std::erase_if(host, [](unsigned char c) { return !std::isalnum(c) && c != '-'; });
  constexpr std::size_t kMostLetters = 64;  // what a file is called has at most 255
  return host.empty() ? "host" : host.substr(0, kMostLetters);
}

}  // namespace lippmann
