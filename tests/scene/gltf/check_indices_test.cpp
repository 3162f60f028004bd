// Indices of models that another version of tinygltf may make: what it writes where the file has no index.
#include "scene/gltf/check_indices.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "scene/gltf/animation.hpp"
#include "support/error_message.hpp"

namespace lippmann::gltf {
namespace {

using testing::HasSubstr;

/// A document with a model of one of everything, as the parser leaves it.
struct ParsedDocument {
  Context context;
  LoadOptions options;
  Document document{"a.glb", options, context, GltfLimits{}};
  std::vector<std::byte> bytes = std::vector<std::byte>(16);
  tinygltf::Model& model = document.model;

  ParsedDocument() {
    document.buffers = {bytes};
    document.images.resize(1);
    model.bufferViews.resize(1), model.bufferViews[0].buffer = 0, model.bufferViews[0].byteLength = 16;
    model.accessors.resize(1), model.accessors[0].bufferView = 0, model.accessors[0].count = 4;
    model.accessors[0].componentType = TINYGLTF_COMPONENT_TYPE_FLOAT, model.accessors[0].type = TINYGLTF_TYPE_SCALAR;
    tinygltf::Primitive primitive;
    primitive.attributes["POSITION"] = 0;
    primitive.targets = {{{"POSITION", 0}}};
    model.meshes.resize(1), model.meshes[0].primitives = {primitive};
    model.nodes.resize(2), model.nodes[0].children = {1}, model.nodes[0].mesh = 0;
    model.skins.resize(1), model.skins[0].joints = {1};
    model.textures.resize(1), model.textures[0].source = 0;
    model.scenes.resize(1), model.scenes[0].nodes = {0}, model.defaultScene = 0;
    model.animations.resize(1), model.animations[0].samplers.resize(1), model.animations[0].channels.resize(1);
    model.animations[0].samplers[0].input = model.animations[0].samplers[0].output = 0;
    channel().sampler = 0, channel().target_node = 0, channel().target_path = "translation";
  }

  tinygltf::AnimationChannel& channel() { return model.animations[0].channels[0]; }
  tinygltf::Primitive& primitive() { return model.meshes[0].primitives[0]; }
};

TEST(GltfIndices, good_model_passes) {
  ParsedDocument parsed;
  EXPECT_NO_THROW(check_indices(parsed.document));
}

TEST(GltfIndices, channel_without_node_is_left_out) {
  ParsedDocument parsed;
  parsed.channel().target_node = -1;
  EXPECT_NO_THROW(check_indices(parsed.document));
  Scene scene;
  scene.nodes.resize(2);
  read_animation(parsed.document, NodeMap{{0, 1}, {0, 1}, {}, {false, false}}, {}, 0.0, scene);
  EXPECT_TRUE(scene.timeline.animations.empty());
}

struct Fault {
  const char* name;
  std::function<void(ParsedDocument&)> spoil;
  const char* message;
};
void PrintTo(const Fault& fault, std::ostream* out) { *out << fault.name; }

class GltfIndexFault : public testing::TestWithParam<Fault> {};

TEST_P(GltfIndexFault, is_an_error_that_names_the_element) {
  ParsedDocument parsed;
  GetParam().spoil(parsed);
  EXPECT_THAT(test::error_message([&] { check_indices(parsed.document); }), HasSubstr(GetParam().message));
}

INSTANTIATE_TEST_SUITE_P(
    All, GltfIndexFault,
    testing::Values(
        Fault{"buffer", [](ParsedDocument& p) { p.model.bufferViews[0].buffer = -1; }, "bufferViews[0]: refers to buffers[-1]"},
        Fault{"view", [](ParsedDocument& p) { p.model.accessors[0].bufferView = 1; }, "accessors[0]: refers to bufferViews[1]"},
        Fault{"sparse_view",
              [](ParsedDocument& p) {
                p.model.accessors[0].sparse.isSparse = true, p.model.accessors[0].sparse.indices.bufferView = -1;
              },
              "accessors[0].sparse.indices: refers to bufferViews[-1]"},
        Fault{"attribute", [](ParsedDocument& p) { p.primitive().attributes["NORMAL"] = -1; },
              "meshes[0]: refers to accessors"},
        Fault{"target", [](ParsedDocument& p) { p.primitive().targets[0]["NORMAL"] = 1; }, "meshes[0]: refers to accessors[1]"},
        Fault{"indices", [](ParsedDocument& p) { p.primitive().indices = 1; }, "meshes[0]: refers to accessors[1]"},
        Fault{"material", [](ParsedDocument& p) { p.primitive().material = 0; }, "meshes[0]: refers to materials[0]"},
        Fault{"joint", [](ParsedDocument& p) { p.model.skins[0].joints[0] = -1; }, "skins[0]: refers to nodes[-1]"},
        Fault{"image", [](ParsedDocument& p) { p.model.textures[0].source = 1; }, "textures[0]: refers to images[1]"},
        Fault{"sampler_of_texture", [](ParsedDocument& p) { p.model.textures[0].sampler = 0; }, "refers to samplers[0]"},
        Fault{"child", [](ParsedDocument& p) { p.model.nodes[0].children[0] = 2; }, "nodes[0]: refers to nodes[2]"},
        Fault{"mesh", [](ParsedDocument& p) { p.model.nodes[1].mesh = -2; }, "nodes[1]: refers to meshes[-2]"},
        Fault{"camera", [](ParsedDocument& p) { p.model.nodes[1].camera = 0; }, "nodes[1]: refers to cameras[0]"},
        Fault{"skin", [](ParsedDocument& p) { p.model.nodes[1].skin = 1; }, "nodes[1]: refers to skins[1]"},
        Fault{"root", [](ParsedDocument& p) { p.model.scenes[0].nodes[0] = -1; }, "scenes[0]: refers to nodes[-1]"},
        Fault{"scene", [](ParsedDocument& p) { p.model.defaultScene = 1; }, "scene: refers to scenes[1]"},
        Fault{"sampler", [](ParsedDocument& p) { p.channel().sampler = -1; }, "channels[0]: refers to samplers[-1]"},
        Fault{"input", [](ParsedDocument& p) { p.model.animations[0].samplers[0].input = -1; }, "refers to accessors[-1]"},
        Fault{"animated_node", [](ParsedDocument& p) { p.channel().target_node = 2; }, "channels[0]: refers to nodes[2]"}),
    [](const auto& fault) { return std::string(fault.param.name); });

}  // namespace
}  // namespace lippmann::gltf
