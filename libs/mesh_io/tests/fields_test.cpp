// Fields of VTU files, and formats that are registered.
#include <isostretch/core/error.hpp>
#include <isostretch/mesh_io/fields.hpp>
#include <isostretch/mesh_io/format.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <limits>

using namespace isostretch;
using namespace isostretch::mesh;

namespace {

constexpr Shape all_shapes[] = {Shape::triangle, Shape::quadratic_triangle, Shape::quad,
                                Shape::tet,      Shape::quadratic_tet,      Shape::hex};

// One element, its vertices anywhere.
ElementMesh one_element(Shape shape) {
  const int count = shape_node_count(shape);
  ElementMesh mesh{shape, Points3(count, 3), {}, {}};
  mesh.elements.resize(1, count);
  for (int i = 0; i < count; ++i) {
    mesh.vertices.row(i) << std::sin(i + 1.0), std::cos(3.0 * i), shape_dim(shape) == 3 ? 0.1 * i * i : 0;
    mesh.elements(0, i) = i;
  }
  return mesh;
}

std::vector<double> counted(std::size_t count) {
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i) values.push_back(1 / (1.0 + static_cast<double>(i)));
  return values;
}

// The doubles that stand in the raw data at the end under that name.
std::vector<double> raw_field(const std::string& text, const std::string& name) {
  const std::size_t tag = text.find("Name=\"" + name + "\"");
  REQUIRE(tag != std::string::npos);
  const std::string key = "offset=\"";
  const std::size_t offset = std::stoul(text.substr(text.find(key, tag) + key.size()));
  const std::size_t start = text.find("<AppendedData encoding=\"raw\">\n_") + 31 + offset;
  std::uint64_t bytes = 0;
  std::memcpy(&bytes, text.data() + start, sizeof bytes);
  std::vector<double> values(bytes / sizeof(double));
  std::memcpy(values.data(), text.data() + start + sizeof bytes, bytes);
  return values;
}

}  // namespace

TEST_CASE("VTU with fields: elements of every shape read back, fields to the bit") {
  for (const Shape shape : all_shapes) {
    CAPTURE(shape_name(shape));
    const ElementMesh mesh = one_element(shape);
    const auto vertices = static_cast<std::size_t>(mesh.vertices.rows());
    const std::string text =
        format_vtu(mesh, {{"displacement", counted(3 * vertices), 3}, {"weight", counted(vertices)}},
                   {{"det_F", {0.25}}});
    const ElementMesh again = parse_vtu_elements(text, "memory");
    CHECK(again.shape == shape);
    CHECK(again.vertices == mesh.vertices);
    CHECK(again.elements == mesh.elements);
    CHECK(raw_field(text, "displacement") == counted(3 * vertices));
    CHECK(raw_field(text, "weight") == counted(vertices));
    CHECK(raw_field(text, "det_F") == std::vector<double>{0.25});
    CHECK(text.find("Name=\"displacement\" NumberOfComponents=\"3\"") != std::string::npos);
  }
}

TEST_CASE("VTU with fields: names are escaped, and text is written when asked") {
  const std::string text =
      format_vtu(one_element(Shape::tet), {}, {{"a<b & \"c\"", {0.5}}}, {.encoding = Encoding::text});
  CHECK(text.find("Name=\"a&lt;b &amp; &quot;c&quot;\"") != std::string::npos);
  CHECK(text.find("<PointData>") == std::string::npos);
  CHECK(parse_vtu_elements(text, "memory").elements.rows() == 1);
}

TEST_CASE("VTU with fields: what does not fit is refused by its name") {
  const ElementMesh mesh = one_element(Shape::tet);
  CHECK_THROWS_WITH_AS(format_vtu(mesh, {{"u", counted(11), 3}}, {}),
                       "field 'u': 11 numbers, and there are 4 vertices with 3 each", Error);
  CHECK_THROWS_WITH_AS(format_vtu(mesh, {}, {{"e", {}}}),
                       "field 'e': 0 numbers, and there are 1 elements with 1 each", Error);
  ElementMesh wrong = mesh;
  wrong.shape = Shape::hex;
  CHECK_THROWS_WITH_AS(format_vtu(wrong, {}, {}), "elements: 4 vertices each, and the shape has 8", Error);
  wrong = mesh;
  wrong.vertices(2, 1) = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH_AS(format_vtu(wrong, {}, {}), doctest::Contains("vertex 2"), Error);
  wrong = mesh;
  wrong.elements(0, 3) = 4;
  CHECK_THROWS_AS(format_vtu(wrong, {}, {}), Error);
}

TEST_CASE("a format that is registered is known by its extension, and one that is none is refused") {
  const SurfaceMesh square{(Points3(3, 3) << 0, 0, 0, 1, 0, 0, 0, 1, 0).finished(),
                           (Triangles(1, 3) << 0, 1, 2).finished(),
                           {},
                           {}};
  register_format({.extension = ".made_up",
                   .read_surface = [&](const std::string&, const ReadOptions&) { return square; }});
  CHECK(read_surface("any.MADE_UP").triangles == square.triangles);
  CHECK(read_elements("any.made_up").vertices == square.vertices);
  CHECK_THROWS_WITH_AS(write_surface("any.made_up", square), doctest::Contains("cannot tell the format"),
                       Error);
  const auto refused = [](const char* extension, const char* message) {
    CHECK_THROWS_WITH_AS(
        register_format({.extension = extension,
                         .write_tets = [](const std::string&, const TetMesh&, const WriteOptions&) {}}),
        doctest::Contains(message), Error);
  };
  refused(".made_up", "'.made_up' is taken");
  refused(".obj", "'.obj' is taken");
  refused("", "is no extension");
  refused("obj", "is no extension");
  refused(".Obj", "is no extension");
  refused(".tar.gz", "is no extension");
  CHECK_THROWS_WITH_AS(register_format({.extension = ".empty"}),
                       doctest::Contains("neither reads nor writes"), Error);
}
