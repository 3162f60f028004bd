#include "optics/optics_kind.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "lippmann/core/error.hpp"
#include "optics/models.hpp"

namespace lippmann {
namespace {

template <std::size_t... i>
std::vector<OpticsKind> kinds_of_models(std::index_sequence<i...>) {
  std::vector<OpticsKind> kinds;
  const auto add = [&kinds]<class Model>(const Model& model) {
    if constexpr (HasKindInfo<Model>) kinds.emplace_back(kind_info(model));
  };
  (add(std::variant_alternative_t<i, OpticsModel>{}), ...);
  return kinds;
}

std::string alternatives(const std::vector<std::string>& texts) {
  std::string list;
  for (std::size_t i = 0; i < texts.size(); ++i) list += (i == 0 ? "" : i + 1 < texts.size() ? ", " : " or ") + texts[i];
  return list;
}

std::string kinds_that_take(std::string_view param) {
  std::vector<std::string> names;
  for (const OpticsKind kind : optics_kinds())
    if (kind.info().takes_param(param)) names.emplace_back(kind.info().name);
  return alternatives(names);
}

}  // namespace

constinit const OpticsKind OpticsKind::kLenticular{lenticular_kind};
constinit const OpticsKind OpticsKind::kMicrolens{microlens_kind};
constinit const OpticsKind OpticsKind::kMultiview{multiview_kind};
constinit const OpticsKind OpticsKind::kSingle{single_kind};

std::span<const OpticsKind> optics_kinds() {
  static const std::vector<OpticsKind> all = kinds_of_models(std::make_index_sequence<std::variant_size_v<OpticsModel>>{});
  return all;
}

bool OpticsKindInfo::takes_param(std::string_view param) const {
  return std::find(takes.begin(), takes.end(), param) != takes.end();
}

void check_kind_params(const OpticsParams& params, OpticsKind kind) {
  for (const KindParam& param : kKindParams)
    if (param.is_given(params) && !kind.info().takes_param(param.name))
      throw usage_error(std::string(param.name), "has no effect on this kind of optics",
                        "`optics` " + kinds_that_take(param.name));
}

std::string_view optics_kinds_help() {
  static const std::string help = [] {
    std::vector<std::string> kinds;
    for (const OpticsKind kind : optics_kinds()) {
      const OpticsKindInfo& info = kind.info();
      kinds.push_back(std::string(info.name) + (info.help.empty() ? "" : " (" + std::string(info.help) + ")"));
    }
    return alternatives(kinds);
  }();
  return help;
}

float view_angle(const OpticsParams& params) { return radians(params.view_angle_deg.value_or(28.0f)); }

}  // namespace lippmann
