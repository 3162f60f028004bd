// The results of `bench NAME` as a section of a page: the machine, the rows, and a bar for each number.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace lippmann {

/// Returns whether a JSON object is the output of a benchmark.
bool is_bench_result(const nlohmann::ordered_json& json);

/// Returns the HTML of the section. Throws Error that names the file if its rows are not objects.
std::string bench_section(const nlohmann::ordered_json& result, const std::filesystem::path& path);

}  // namespace lippmann
