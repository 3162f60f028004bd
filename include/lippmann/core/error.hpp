// The only exception type of the library: invalid input from outside (a file, a flag, a size), with enough details to correct
// it.
//
// The library throws Error only outside of rendering kernels.
#pragma once

#include <stdexcept>
#include <string>

namespace lippmann {

enum class ErrorKind {
  kInput,  ///< invalid file contents, I/O, limits; exit code 1
  kUsage,  ///< invalid flag, key or value on the command line or in a job file; exit code 2
};

class Error : public std::runtime_error {
 public:
  /// where: file, file:line, flag or key. problem: what is wrong. accepted: accepted values; empty if obvious.
  Error(std::string where, std::string problem, std::string accepted = {}, ErrorKind kind = ErrorKind::kInput);

  const std::string& where() const { return where_; }
  const std::string& problem() const { return problem_; }
  const std::string& accepted() const { return accepted_; }
  ErrorKind kind() const { return kind_; }
  int exit_code() const { return kind_ == ErrorKind::kUsage ? 2 : 1; }

 private:
  std::string where_, problem_, accepted_;
  ErrorKind kind_;
};

/// Returns an Error for invalid usage (exit code 2).
Error usage_error(std::string where, std::string problem, std::string accepted = {});

}  // namespace lippmann
