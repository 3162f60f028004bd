// Which version of Lippmann this is.
#pragma once

namespace lippmann {

/// As in "0.1.0". Job files, reports and EXR files name it.
const char* version();

}  // namespace lippmann
