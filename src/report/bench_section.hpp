// What `bench NAME` has measured, as a page shows it: the machine, the rows, and one column as bars.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace lippmann {

/// Whether a JSON object is what a benchmark prints.
bool is_bench_result(const nlohmann::ordered_json& json);

/// HTML. Throws Error naming the file where its rows are no objects.
std::string bench_section(const nlohmann::ordered_json& result, const std::filesystem::path& path);

}  // namespace lippmann
