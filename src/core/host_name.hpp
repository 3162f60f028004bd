// The machine's name, for names of files that several machines write into one folder.
#pragma once

#include <string>

namespace lippmann {

/// In letters, digits and dashes; "host" if it has no name of these.
std::string host_name();

}  // namespace lippmann
