#include "scene/gltf/value.hpp"

#include <nlohmann/json.hpp>

namespace lippmann::gltf {

Value Value::operator[](std::string_view property) const {
  if (!json_) return {};
  const auto found = json_->find(property);
  return found == json_->end() ? Value() : Value(*found);
}

Value Value::at(std::size_t i) const { return Value((*json_)[i]); }

std::size_t Value::size() const { return json_ ? json_->size() : 0; }

double Value::number(double otherwise) const { return json_ ? json_->get<double>() : otherwise; }

int Value::integer(int otherwise) const { return json_ ? json_->get<int>() : otherwise; }

std::size_t Value::count() const { return json_ ? json_->get<std::size_t>() : 0; }

bool Value::flag(bool otherwise) const {
  if (!json_) return otherwise;
  return json_->is_boolean() ? json_->get<bool>() : json_->get<double>() != 0.0;
}

const std::string& Value::text() const {
  static const std::string kEmpty;
  return json_ ? json_->get_ref<const std::string&>() : kEmpty;
}

std::vector<double> Value::numbers() const { return json_ ? json_->get<std::vector<double>>() : std::vector<double>(); }

std::vector<int> Value::indices() const { return json_ ? json_->get<std::vector<int>>() : std::vector<int>(); }

std::map<std::string, int> Value::index_map() const {
  return json_ ? json_->get<std::map<std::string, int>>() : std::map<std::string, int>();
}

}  // namespace lippmann::gltf
