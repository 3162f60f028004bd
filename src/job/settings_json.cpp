#include "job/settings_json.hpp"

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/json_text.hpp"
#include "job/params_table.hpp"

namespace lippmann {
namespace {

using Json = nlohmann::ordered_json;

Json setting_json(const ParamInfo& info, const RenderParams& params) {
  const std::vector<std::string> values = info.get(params);
  if (info.kind == ParamKind::kList) return values;
  if (values.empty()) return nullptr;
  if (info.kind == ParamKind::kText) return values.front();
  return json_from_text(values.front());  // the text of a number or a flag is valid JSON
}

}  // namespace

Json settings_json(const RenderParams& params) {
  Json json = Json::object();
  for (const ParamInfo& info : params_table())
    if (info.name != "scene") json[std::string(info.name)] = setting_json(info, params);
  return json;
}

}  // namespace lippmann
