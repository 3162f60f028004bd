// What the library says when it refuses something.
#pragma once

#include <functional>
#include <string>

#include "lippmann/core/error.hpp"

namespace lippmann::test {

/// The message of the Error that `work` throws; "(no Error)" if it throws none.
inline std::string error_message(const std::function<void()>& work) {
  try {
    work();
  } catch (const Error& error) {
    return error.what();
  }
  return "(no Error)";
}

}  // namespace lippmann::test
