// The results of `bench NAME` as a section of a page: the machine, and a table with a bar for each number.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace lippmann {

bool is_bench_result(const nlohmann::ordered_json& json);

/// Returns the HTML of the section. Throws Error naming `path` if the rows of `result` are not JSON objects.
std::string bench_section(const nlohmann::ordered_json& result, const std::filesystem::path& path);

}  // namespace lippmann
