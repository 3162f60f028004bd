#pragma once

namespace lippmann {

bool is_ranks_module_installed();

}  // namespace lippmann
