// The results of `bench NAME` as a section of a page: the machine, and a table with a bar for each number.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace lippmann {

bool is_bench_result(const nlohmann::ordered_json& json);

/// Throws Error naming the file if its rows are not objects.
std::string bench_section(const nlohmann::ordered_json& result, const std::filesystem::path& path);

}  // namespace lippmann
