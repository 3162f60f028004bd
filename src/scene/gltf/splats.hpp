#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "lippmann/scene/scene.hpp"
#include "scene/gltf/attribute.hpp"

namespace lippmann::gltf {

bool is_splats(Value primitive);

/// Returns whether a document has primitives and all of them are splats. The document need not be valid.
bool is_of_splats_alone(const nlohmann::json& document);

/// Returns the splats of a primitive. If no splat is valid, warns and returns none. Throws Error for missing attributes, wrong
/// types or counts, and unknown kernels or colour spaces.
std::optional<Splats> read_splats(Document& document, PrimitiveId id);

}  // namespace lippmann::gltf
