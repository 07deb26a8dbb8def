#include "meshes.hpp"
#include "scratch.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/mesh/generators.hpp>
#include <isostretch/mesh_io/io.hpp>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <cstdint>
#include <cstring>
#include <limits>

using namespace isostretch;
using namespace isostretch::mesh;
using namespace isostretch::mesh::test;
using nlohmann::json;

namespace {

const std::string png = std::string("\x89PNG\r\n\x1a\n") + "not really a picture";

template <class T>
T at(const std::string& bytes, std::size_t offset) {
  T value;
  REQUIRE(offset + sizeof value <= bytes.size());
  std::memcpy(&value, bytes.data() + offset, sizeof value);
  return value;
}

// A file taken apart, with what the specification says of lengths and alignment checked on the way.
struct Glb {
  json document;
  std::string data;

  explicit Glb(const std::string& file) {
    CHECK(file.substr(0, 4) == "glTF");
    CHECK(at<std::uint32_t>(file, 4) == 2);
    CHECK(at<std::uint32_t>(file, 8) == file.size());
    const std::size_t json_length = at<std::uint32_t>(file, 12);
    CHECK(file.substr(16, 4) == "JSON");
    CHECK(json_length % 4 == 0);
    const std::size_t data_length = at<std::uint32_t>(file, 20 + json_length);
    CHECK(file.substr(24 + json_length, 4) == std::string("BIN\0", 4));
    CHECK(data_length % 4 == 0);
    CHECK(28 + json_length + data_length == file.size());
    document = json::parse(file.substr(20, json_length));
    data = file.substr(28 + json_length);
    CHECK(document["asset"]["version"] == "2.0");
    CHECK(document["buffers"][0]["byteLength"] == data.size());
  }

  std::string view(const json& index) const {
    const json& view = document["bufferViews"].at(index.get<std::size_t>());
    const std::size_t offset = view["byteOffset"], length = view["byteLength"];
    CHECK(offset % 4 == 0);
    CHECK(offset + length <= data.size());
    return data.substr(offset, length);
  }

  // Numbers of an accessor, row by row.
  template <class T>
  std::vector<T> numbers(const json& index) const {
    const json& accessor = document["accessors"].at(index.get<std::size_t>());
    const std::string type = accessor["type"];
    const std::size_t columns = type == "SCALAR" ? 1 : type == "VEC2" ? 2 : 3;
    CHECK(accessor["componentType"] == (std::is_same_v<T, float> ? 5126 : 5125));
    const std::string bytes = view(accessor["bufferView"]);
    CHECK(bytes.size() == accessor["count"].get<std::size_t>() * columns * sizeof(T));
    std::vector<T> values(bytes.size() / sizeof(T));
    std::memcpy(values.data(), bytes.data(), bytes.size());
    return values;
  }

  const json& primitive() const { return document["meshes"][0]["primitives"][0]; }
  std::vector<float> attribute(const char* name) const {
    return numbers<float>(primitive()["attributes"].at(name));
  }
  std::vector<std::uint32_t> indices() const { return numbers<std::uint32_t>(primitive()["indices"]); }
};

// A square with a seam along its diagonal.
SurfaceMesh textured() {
  SurfaceMesh mesh = square();
  mesh.uv = rows<Points2>({0, 0, 1, 0, 1, 1, 0.25, 0.5, 0, 1, 0.5, 0.5});
  mesh.uv_triangles = rows<Triangles>({0, 1, 2, 3, 5, 4});
  return mesh;
}

}  // namespace

TEST_CASE("glTF: a plain surface has positions, normals and indices") {
  const Glb glb(format_glb(square()));
  CHECK(glb.indices() == std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3});
  CHECK(glb.attribute("POSITION") == std::vector<float>{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
  CHECK(glb.attribute("NORMAL") == std::vector<float>{0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
  CHECK_FALSE(glb.primitive()["attributes"].contains("TEXCOORD_0"));
  CHECK_FALSE(glb.document.contains("images"));
  CHECK_FALSE(Glb(format_glb(square(), {.normals = false})).primitive()["attributes"].contains("NORMAL"));
}

TEST_CASE("glTF: vertices are doubled along seams only, v runs downwards") {
  const Glb glb(format_glb(textured()));
  CHECK(glb.indices() == std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5});
  CHECK(glb.attribute("TEXCOORD_0") == std::vector<float>{0, 1, 1, 1, 1, 0, 0.25, 0.5, 0.5, 0.5, 0, 0});
  CHECK(glb.attribute("POSITION") ==
        std::vector<float>{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0});
  SurfaceMesh smooth = textured();
  smooth.uv_triangles = smooth.triangles;
  CHECK(Glb(format_glb(smooth)).attribute("POSITION").size() == 12);
}

TEST_CASE("glTF: a picture is embedded as it is") {
  const Glb glb(format_glb(textured(), {.base_color_png = png}));
  const json& image = glb.document["images"][0];
  CHECK(image["mimeType"] == "image/png");
  CHECK(glb.view(image["bufferView"]) == png);
  const json& material = glb.document["materials"][0]["pbrMetallicRoughness"];
  CHECK(glb.document["textures"][material["baseColorTexture"]["index"].get<std::size_t>()]["source"] == 0);
}

TEST_CASE("glTF: the repeats of a picture are in the material, not in the coordinates") {
  SurfaceMesh mesh = grid(2, 2);
  mesh.uv = mesh.vertices.leftCols(2);
  mesh.uv_triangles = mesh.triangles;
  const std::string png = "\x89PNG\r\n\x1a\n";
  const Glb once(format_glb(mesh, {.base_color_png = png})),
      often(format_glb(mesh, {.base_color_png = png, .repeats = 3.5}));
  const auto uv = [](const Glb& glb) {
    return glb.numbers<float>(glb.primitive()["attributes"]["TEXCOORD_0"]);
  };
  CHECK(uv(once) == uv(often));
  CHECK(!once.document.contains("extensionsUsed"));
  CHECK(often.document["extensionsUsed"] == json::array({"KHR_texture_transform"}));
  const json& transform = often.document["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]
                                        ["extensions"]["KHR_texture_transform"];
  CHECK(transform["scale"] == json::array({3.5, 3.5}));
  // The lower left corner, (0, 1) in glTF, keeps a corner of the picture.
  CHECK(1 * transform["scale"][1].get<double>() + transform["offset"][1].get<double>() == 1);
  for (const double repeats : {0.0, -1.0, std::nan(""), HUGE_VAL})
    CHECK_THROWS_AS(format_glb(mesh, {.base_color_png = png, .repeats = repeats}), Error);
}

TEST_CASE("glTF: limits of positions are those of the floats, normals are unit vectors") {
  SurfaceMesh mesh = procedural_face(20);
  mesh.vertices.col(0) *= 1e30;
  mesh.vertices.col(1) *= 1e-30;
  const Glb glb(format_glb(mesh));
  const json& accessor =
      glb.document["accessors"][glb.primitive()["attributes"]["POSITION"].get<std::size_t>()];
  const std::vector<float> positions = glb.attribute("POSITION");
  for (std::size_t c = 0; c < 3; ++c) {
    float low = positions[c], high = positions[c];
    for (std::size_t i = c; i < positions.size(); i += 3) {
      low = std::min(low, positions[i]);
      high = std::max(high, positions[i]);
    }
    CHECK(accessor["min"][c].get<double>() == static_cast<double>(low));
    CHECK(accessor["max"][c].get<double>() == static_cast<double>(high));
  }
  const std::vector<float> normals = glb.attribute("NORMAL");
  for (std::size_t i = 0; i < normals.size(); i += 3)
    CHECK(std::hypot(normals[i], normals[i + 1], normals[i + 2]) == doctest::Approx(1).epsilon(1e-6));
}

TEST_CASE("glTF: vertices without a direction or without a triangle") {
  SurfaceMesh mesh = surface({0, 0, 0, 9, 9, 9, 1, 0, 0, 2, 0, 0}, {0, 2, 3});
  const Glb glb(format_glb(mesh));
  CHECK(glb.attribute("POSITION") == std::vector<float>{0, 0, 0, 1, 0, 0, 2, 0, 0});
  CHECK(glb.attribute("NORMAL") == std::vector<float>{0, 0, 1, 0, 0, 1, 0, 0, 1});
  for (const double size : {1e-300, 1e-30, 1e30}) {
    mesh = square();
    mesh.vertices *= size;
    CHECK(Glb(format_glb(mesh)).attribute("NORMAL") ==
          std::vector<float>{0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
  }
}

TEST_CASE("glTF: what cannot be written is refused and leaves nothing behind") {
  const Scratch folder;
  const std::string path = folder.file("a.glb");
  SurfaceMesh mesh = square();
  mesh.vertices(3, 1) = -1e39;
  CHECK_THROWS_WITH_AS(write_glb(path, mesh), "vertex 3 has a coordinate that is too large for glTF", Error);
  mesh = textured();
  mesh.uv(5, 0) = 1e39;
  CHECK_THROWS_WITH_AS(write_glb(path, mesh), "uv point 5 has a coordinate that is too large for glTF",
                       Error);
  mesh.uv(5, 0) = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH_AS(write_glb(path, mesh), "uv point 5 has a coordinate that is not finite", Error);
  CHECK_THROWS_WITH_AS(write_glb(path, square(), {.base_color_png = png}),
                       "a base colour texture needs texture coordinates, the mesh has none", Error);
  CHECK_THROWS_WITH_AS(write_glb(path, textured(), {.base_color_png = "GIF89a"}),
                       "the base colour is not a PNG file", Error);
  CHECK(folder.empty());
  write_glb(path, textured());
  CHECK(std::filesystem::file_size(path) == format_glb(textured()).size());
}

TEST_CASE("GLB: frames become morph targets with an animation") {
  mesh::SurfaceMesh triangle;
  triangle.vertices.resize(3, 3);
  triangle.vertices << 0, 0, 0, 1, 0, 0, 0, 1, 0;
  triangle.triangles.resize(1, 3);
  triangle.triangles << 0, 1, 2;
  std::vector<mesh::GlbFrame> frames{{0, triangle.vertices}, {0.25, triangle.vertices}};
  frames[1].vertices(1, 0) = 3;
  const std::string bytes = mesh::format_glb_animation(triangle, frames);
  const std::uint32_t length = at<std::uint32_t>(bytes, 12);
  const auto gltf = json::parse(bytes.substr(20, length));
  const auto& primitive = gltf["meshes"][0]["primitives"][0];
  REQUIRE(primitive["targets"].size() == 2);
  CHECK_FALSE(primitive["attributes"].contains("NORMAL"));
  const auto& target = gltf["accessors"][primitive["targets"][1]["POSITION"].get<std::size_t>()];
  CHECK(target["count"] == 3);
  CHECK(target["max"] == json({2.0, 0.0, 0.0}));
  const auto& animation = gltf["animations"][0];
  CHECK(animation["channels"][0]["target"]["path"] == "weights");
  const auto& input = gltf["accessors"][animation["samplers"][0]["input"].get<std::size_t>()];
  CHECK(input["max"] == json({0.25}));
  CHECK(gltf["accessors"][animation["samplers"][0]["output"].get<std::size_t>()]["count"] == 4);
  CHECK_THROWS_WITH_AS(mesh::format_glb_animation(triangle, {}), doctest::Contains("without frames"), Error);
  frames[1].seconds = 0;
  CHECK_THROWS_WITH_AS(mesh::format_glb_animation(triangle, frames), doctest::Contains("frame 1"), Error);
  frames[1] = {1, mesh::Points3::Zero(4, 3)};
  CHECK_THROWS_WITH_AS(mesh::format_glb_animation(triangle, frames), doctest::Contains("4 vertices"), Error);
}
