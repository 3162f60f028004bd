// Writes seeds for fuzz_gltf: small documents that reach every part of the reader.
#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <meshoptimizer.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string_view>

#include "scene/gltf/gltf_builder.hpp"
#include "support/encode_image.hpp"

namespace {

using namespace lippmann;
using test::GltfBuilder;
using test::Json;

std::vector<unsigned char> encode(std::string_view format) {
  const std::vector<std::uint8_t> pixels(3 * 8 * 8, 100);
  return format == "png" ? test::encode_png(8, 8, 3, pixels) : test::encode_jpeg(8, 8, 3, pixels);
}

GltfBuilder geometry() {
  GltfBuilder b;
  const int indices = b.add_accessor(std::vector<std::uint16_t>{0, 1, 2, 2, 1, 0});
  const int normals = b.add_accessor(std::vector<Vec3f>(3, Vec3f(0, 0, 1)));
  const int uvs = b.add_accessor(std::vector<Vec2f>(3, Vec2f(0.5f)));
  b.add_triangle({{"indices", indices}, {"attributes", {{"NORMAL", normals}, {"TEXCOORD_0", uvs}}}, {"mode", 5}});
  const int sparse_indices = b.add_view(std::vector<std::uint8_t>{1}), values = b.add_view(std::vector<Vec3f>{{1, 2, 3}});
  b.accessor(normals)["sparse"] = {{"count", 1},
                                   {"indices", {{"bufferView", sparse_indices}, {"componentType", 5121}}},
                                   {"values", {{"bufferView", values}}}};
  b.add_node({{"mesh", 0}, {"children", {1}}, {"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}});
  b.add_node({{"translation", {1, 2, 3}}, {"rotation", {0, 0, 0, 1}}, {"scale", {1, 1, 1}}});
  b.add("scenes", {{"nodes", {0}}});
  b.root["scene"] = 0;
  return b;
}

GltfBuilder textured(const char* format) {
  GltfBuilder b;
  b.add("images", {{"bufferView", b.add_view(encode(format))}});
  b.add("samplers", {{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9729}});
  b.add("textures", {{"source", 0}, {"sampler", 0}});
  const Json map = {{"index", 0}};
  const Json transform = {{"offset", {0.5, 0}}, {"rotation", 1}, {"scale", {2, 3}}, {"texCoord", 1}};
  const Json transformed = {{"index", 0}, {"texCoord", 0}, {"extensions", {{"KHR_texture_transform", transform}}}};
  b.add("materials", {{"pbrMetallicRoughness",
                       {{"baseColorTexture", transformed}, {"metallicRoughnessTexture", map}, {"metallicFactor", 0}}},
                      {"normalTexture", {{"index", 0}, {"scale", 0.5}}},
                      {"occlusionTexture", {{"index", 0}, {"strength", 0.5}, {"texCoord", 2}}},
                      {"emissiveFactor", {1, 1, 1}},
                      {"emissiveTexture", {{"index", 0}}},
                      {"alphaMode", "MASK"},
                      {"alphaCutoff", 0.3},
                      {"doubleSided", true},
                      {"extensions",
                       {{"KHR_materials_ior", {{"ior", 1.3}}},
                        {"KHR_materials_emissive_strength", {{"emissiveStrength", 5}}},
                        {"KHR_materials_specular", {{"specularColorFactor", {1, 1, 2}}, {"specularTexture", map}}},
                        {"KHR_materials_clearcoat", {{"clearcoatFactor", 1}, {"clearcoatNormalTexture", transformed}}},
                        {"KHR_materials_transmission", {{"transmissionFactor", 0.5}, {"transmissionTexture", map}}}}}});
  const int uvs = b.add_accessor(std::vector<Vec2f>(3, Vec2f(0.5f))), colors = b.add_accessor(std::vector<Vec4f>(3));
  const Json attributes = {{"TEXCOORD_0", uvs}, {"TEXCOORD_1", uvs}, {"COLOR_0", colors}, {"TANGENT", colors}};
  b.add_node({{"mesh", b.add_triangle({{"material", 0}, {"attributes", attributes}})}});
  return b;
}

GltfBuilder animated() {
  GltfBuilder b;
  b.add_node(Json::object());
  const int times = b.add_accessor(std::vector<float>{0, 1});
  const int rotations = b.add_accessor(std::vector<Vec4f>{{0, 0, 0, 1}, {0, 1, 0, 0}});
  const int splines = b.add_accessor(std::vector<Vec3f>(6, Vec3f(1)));
  const auto channel = [](int sampler, const char* path) {
    return Json{{"sampler", sampler}, {"target", {{"node", 0}, {"path", path}}}};
  };
  b.add("animations", {{"name", "a"},
                       {"channels", {channel(0, "rotation"), channel(1, "translation"), channel(2, "scale")}},
                       {"samplers",
                        {{{"input", times}, {"output", rotations}},
                         {{"input", times}, {"output", splines}, {"interpolation", "CUBICSPLINE"}},
                         {{"input", times}, {"output", splines}, {"interpolation", "CUBICSPLINE"}}}}});
  return b;
}

GltfBuilder skinned() {
  GltfBuilder b;
  const int matrices = b.add_accessor(std::vector<glm::mat4>(2, glm::mat4(1.0f)), test::kFloat, "MAT4", 2);
  const int joints = b.add_accessor(std::vector<std::uint8_t>(12, 1), test::kUnsignedByte, "VEC4", 3);
  const int weights = b.add_accessor(std::vector<Vec4f>(3, Vec4f(0.25f)));
  const int deltas = b.add_accessor(std::vector<Vec3f>(3, Vec3f(0.5f)));
  const int mesh =
      b.add_triangle({{"attributes", {{"JOINTS_0", joints}, {"WEIGHTS_0", weights}}}, {"targets", {{{"POSITION", deltas}}}}});
  const int times = b.add_accessor(std::vector<float>{0, 1}), morphs = b.add_accessor(std::vector<float>{0, 1});
  b.add("animations", {{"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "weights"}}}}}},
                       {"samplers", {{{"input", times}, {"output", morphs}}}}});
  b.add("skins", {{"joints", {1, 2}}, {"inverseBindMatrices", matrices}, {"skeleton", 1}});
  b.add_node({{"mesh", mesh}, {"skin", 0}, {"weights", {0.5}}});
  b.add_node({{"children", {2}}});
  b.add_node({{"translation", {0, 1, 0}}});
  return b;
}

GltfBuilder lights_and_cameras() {
  GltfBuilder b;
  b.root["extensionsUsed"] = {"KHR_lights_punctual", "KHR_other"};
  b.root["extensions"]["KHR_lights_punctual"]["lights"] = {
      {{"type", "spot"}, {"spot", {{"innerConeAngle", 0.1}, {"outerConeAngle", 0.5}}}, {"range", 5}},
      {{"type", "point"}, {"color", {1, 0.5, 0.2}}, {"intensity", 100}},
      {{"type", "directional"}}};
  for (int i = 0; i < 3; ++i) b.add_node({{"extensions", {{"KHR_lights_punctual", {{"light", i}}}}}});
  b.add("cameras",
        {{"type", "perspective"}, {"perspective", {{"yfov", 0.5}, {"znear", 0.1}, {"zfar", 10}, {"aspectRatio", 1.5}}}});
  b.add("cameras", {{"type", "orthographic"}, {"orthographic", {{"xmag", 1}, {"ymag", 2}, {"znear", 0}, {"zfar", 10}}}});
  b.add_node({{"camera", 0}});
  b.add_node({{"camera", 1}});
  b.add_node({{"mesh", b.add_triangle()}});
  return b;
}

GltfBuilder packed_by_meshopt() {
  GltfBuilder b;
  const std::vector<Vec3f> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  std::vector<unsigned char> packed(meshopt_encodeVertexBufferBound(3, 12));
  packed.resize(meshopt_encodeVertexBuffer(packed.data(), packed.size(), corners.data(), 3, 12));
  const int mesh = b.add_triangle(), places = b.add_accessor(std::vector<Vec3f>(2));
  const Json attributes = {{"TRANSLATION", places}};
  b.add_node({{"mesh", mesh}, {"extensions", {{"EXT_mesh_gpu_instancing", {{"attributes", attributes}}}}}});
  b.add_view(packed);
  b.root["bufferViews"][0]["extensions"]["EXT_meshopt_compression"] = {{"buffer", 0},
                                                                       {"byteOffset", b.binary.size() - packed.size()},
                                                                       {"byteLength", packed.size()},
                                                                       {"byteStride", 12},
                                                                       {"count", 3},
                                                                       {"mode", "ATTRIBUTES"},
                                                                       {"filter", "NONE"}};
  return b;
}

GltfBuilder packed_by_draco(int method) {
  draco::TriangleSoupMeshBuilder builder;
  builder.Start(1);
  const int positions = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
  const Vec3f a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
  builder.SetAttributeValuesForFace(positions, draco::FaceIndex(0), &a.x, &b.x, &c.x);
  draco::Encoder encoder;
  encoder.SetEncodingMethod(method);
  draco::EncoderBuffer packed;
  encoder.EncodeMeshToBuffer(*builder.Finalize(), &packed);
  GltfBuilder file;
  const int view = file.add_view(std::vector<char>(packed.data(), packed.data() + packed.size()));
  file.add("accessors", {{"componentType", test::kFloat}, {"type", "VEC3"}, {"count", 3}});
  file.add("accessors", {{"componentType", test::kUnsignedShort}, {"type", "SCALAR"}, {"count", 3}});
  const Json extension = {{"bufferView", view}, {"attributes", {{"POSITION", 0}}}};
  const Json primitive = {
      {"attributes", {{"POSITION", 0}}}, {"indices", 1}, {"extensions", {{"KHR_draco_mesh_compression", extension}}}};
  file.add_node({{"mesh", file.add_mesh(primitive)}});
  return file;
}

GltfBuilder splats() {
  GltfBuilder b;
  const std::string own = "KHR_gaussian_splatting:";
  Json attributes = {{"POSITION", b.add_accessor(std::vector<Vec3f>(2, Vec3f(1.0f)))},
                     {own + "ROTATION", b.add_accessor(std::vector<Vec4f>(2, Vec4f(0, 0, 0, 1)))},
                     {own + "SCALE", b.add_accessor(std::vector<Vec3f>(2, Vec3f(0.5f)))},
                     {own + "OPACITY", b.add_accessor(std::vector<float>(2, 0.5f))}};
  const int harmonic = b.add_accessor(std::vector<Vec3f>(2, Vec3f(0.5f)));
  for (const char* name : {"SH_DEGREE_0_COEF_0", "SH_DEGREE_1_COEF_0", "SH_DEGREE_1_COEF_1", "SH_DEGREE_1_COEF_2"})
    attributes[own + name] = harmonic;
  b.add_node(
      {{"mesh", b.add_mesh({{"mode", 0},
                            {"attributes", attributes},
                            {"extensions",
                             {{"KHR_gaussian_splatting", {{"kernel", "ellipse"}, {"colorSpace", "srgb_rec709_display"}}}}}})}});
  return b;
}

/// A JSON file whose buffer is a data URI with the triangle (0, 0, 0), (1, 0, 0), (0, 1, 0).
std::string data_uri() {
  GltfBuilder b;
  b.add_node({{"mesh", b.add_triangle()}});
  Json root = b.document();
  root["buffers"][0]["uri"] = "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA";
  root["images"] = {{{"uri", "data:image/png;base64,iVBORw0KGgo="}}};
  root["textures"] = {{{"source", 0}}};
  root["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
  return root.dump();
}

void write(const std::filesystem::path& path, const std::string& head, const test::Contents& rest) {
  std::ofstream file(path, std::ios::binary);
  file << head;
  file.write(reinterpret_cast<const char*>(rest.data()), static_cast<std::streamsize>(rest.size()));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: fuzz_gltf_seeds FOLDER\n");
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  std::filesystem::create_directories(folder);
  int count = 0;
  for (const GltfBuilder& builder : {geometry(), textured("png"), textured("jpeg"), animated(), skinned(), lights_and_cameras(),
                                     splats(), packed_by_meshopt(), packed_by_draco(draco::MESH_SEQUENTIAL_ENCODING),
                                     packed_by_draco(draco::MESH_EDGEBREAKER_ENCODING)}) {
    const std::string name = std::to_string(count++);
    write(folder / ("whole" + name), "W", builder.glb());
    write(folder / ("chunks" + name), "C" + builder.document().dump() + '\0', builder.binary);
  }
  write(folder / "data_uri", "W" + data_uri(), {});
  write(folder / "side_file", R"(W{"asset":{"version":"2.0"},"buffers":[{"byteLength":1,"uri":"a%2f..%20b.bin"}]})", {});
}
