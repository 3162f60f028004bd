#include "lippmann/core/error.hpp"

#include <utility>

#include "core/printable.hpp"

namespace lippmann {
namespace {

std::string compose(const std::string& where, const std::string& problem, const std::string& accepted) {
  std::string text = where.empty() ? problem : where + ": " + problem;
  if (!accepted.empty()) text += "; accepted: " + accepted;
  return printable_line(text);
}

}  // namespace

Error::Error(std::string where, std::string problem, std::string accepted, ErrorKind kind)
    : std::runtime_error(compose(where, problem, accepted)),
      where_(printable_line(where)),
      problem_(printable_line(problem)),
      accepted_(printable_line(accepted)),
      kind_(kind) {}

Error usage_error(std::string where, std::string problem, std::string accepted) {
  return Error(std::move(where), std::move(problem), std::move(accepted), ErrorKind::kUsage);
}

}  // namespace lippmann
