#include "formats.hpp"
#include "sample_mesh.hpp"
#include "scratch.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/mesh/generators.hpp>

#include <doctest/doctest.h>

#include <clocale>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <random>
#include <regex>
#include <set>

using namespace isostretch;
using namespace isostretch::mesh;
using namespace isostretch::mesh::test;
namespace fs = std::filesystem;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

bool same_bits(const Points3& a, const Points3& b) {
  return a.rows() == b.rows() &&
         std::memcmp(a.data(), b.data(), static_cast<std::size_t>(a.size()) * sizeof(double)) == 0;
}

template <class Elements>
bool valid(const Points3& vertices, const Elements& elements) {
  return vertices.allFinite() && elements.rows() > 0 && elements.minCoeff() >= 0 &&
         elements.maxCoeff() < vertices.rows();
}

// What reading says: empty when it gave a valid mesh.
std::string message_of(const std::string& name, const std::string& contents, bool tets) {
  try {
    if (tets) {
      const TetMesh mesh = parse_tets(name, contents);
      return valid(mesh.vertices, mesh.tets) ? "" : "an invalid mesh";
    }
    const SurfaceMesh mesh = parse_surface(name, contents);
    return valid(mesh.vertices, mesh.triangles) ? "" : "an invalid mesh";
  } catch (const Error& error) {
    return error.what();
  }
}

// A line, or in a file with binary data a byte; what is left of a text STL may pass for a binary one.
bool names_place(const std::string& message, const Sample& sample) {
  const bool by_line = sample.text && !ends_with(sample.name, ".stl");
  const std::string rest = message.substr(std::min(sample.name.size(), message.size()));
  return message.compare(0, sample.name.size(), sample.name) == 0 &&
         std::regex_search(rest,
                           std::regex(by_line ? "^:[1-9][0-9]*: ." : "^(:[1-9][0-9]*|: byte [0-9]+): ."));
}

std::string extension(const std::string& name) {
  return fs::path(name).extension().string();
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// Every sample with the fault is refused, naming the place and one of the texts.
void refused(const Variation& variation, std::initializer_list<const char*> texts,
             const std::function<bool(const Sample&)>& concerned) {
  int checked = 0;
  for (const Sample& sample : all_samples(variation)) {
    if (!concerned(sample)) continue;
    ++checked;
    const std::string message = message_of(sample.name, sample.contents, sample.tets);
    CAPTURE(sample.name);
    CAPTURE(message);
    CHECK(names_place(message, sample));
    CHECK(std::any_of(texts.begin(), texts.end(), [&](const char* text) { return contains(message, text); }));
  }
  CHECK(checked > 0);
}

bool every(const Sample&) {
  return true;
}
bool indexed(const Sample& sample) {
  return sample.indexed;
}

// Contents of a mesh in every format that is written, with a name that has its extension.
struct Written {
  std::string name;
  std::string contents;
  bool tets = false;
};

std::vector<WriteOptions> all_write_options() {
  std::vector<WriteOptions> all;
  for (const Encoding encoding : {Encoding::text, Encoding::binary})
    for (const MshVersion version : {MshVersion::v2_2, MshVersion::v4_0, MshVersion::v4_1})
      for (const bool base64 : {false, true}) all.push_back({encoding, version, base64});
  return all;
}

std::vector<Written> written(const SurfaceMesh& mesh) {
  std::vector<Written> files = {
      {"w.obj", format_obj(mesh)}, {"w.off", format_off(mesh)}, {"w.mesh", format_medit(mesh)}};
  for (const WriteOptions& options : all_write_options()) {
    files.push_back({"w.ply", format_ply(mesh, options)});
    files.push_back({"w.msh", format_msh(mesh, options)});
    files.push_back({"w.vtk", format_vtk(mesh, options)});
    files.push_back({"w.vtu", format_vtu(mesh, options)});
  }
  return files;
}

std::vector<Written> written(const TetMesh& mesh) {
  std::vector<Written> files = {{"w.mesh", format_medit(mesh), true}};
  for (const WriteOptions& options : all_write_options()) {
    files.push_back({"w.msh", format_msh(mesh, options), true});
    files.push_back({"w.vtk", format_vtk(mesh, options), true});
    files.push_back({"w.vtu", format_vtu(mesh, options), true});
  }
  return files;
}

// Numbers of every size, and those that are printed wrongly most often.
void make_awkward(Points3& points) {
  const double awkward[] = {5e-324,
                            -2.2250738585072011e-308,
                            1e-300,
                            1e300,
                            -0.0,
                            0.1,
                            1.0 / 3,
                            -std::numeric_limits<double>::max(),
                            9007199254740993.0,
                            123456789.0123456789};
  std::mt19937_64 random(1);
  for (Eigen::Index i = 0; i < points.size(); ++i)
    points.data()[i] *= std::ldexp(1.0 + 1e-3 * double(random() % 1000), int(random() % 2000) - 1000);
  std::copy(std::begin(awkward), std::end(awkward), points.data());
}

}  // namespace

TEST_CASE("every format: a good file in every variant is read") {
  for (const Sample& sample : all_samples()) {
    CAPTURE(sample.name);
    CAPTURE(message_of(sample.name, sample.contents, sample.tets));
    if (sample.tets) {
      const TetMesh mesh = parse_tets(sample.name, sample.contents);
      CHECK(mesh.vertices == sample_tets().vertices);
      CHECK(mesh.tets == sample_tets().tets);
    } else {
      const SurfaceMesh mesh = parse_surface(sample.name, sample.contents);
      CHECK(mesh.vertices == sample_surface().vertices);
      CHECK(mesh.triangles == sample_surface().triangles);
      CHECK_FALSE(mesh.has_uv());
    }
  }
}

TEST_CASE("every format: faults are refused and their place is named") {
  for (const double value : {std::numeric_limits<double>::quiet_NaN(), infinity, -infinity}) {
    CAPTURE(value);
    refused({.coordinate = value}, {"not finite"}, every);
  }
  for (const int corner : {99, -7, std::numeric_limits<int>::max() - 20}) {
    CAPTURE(corner);
    refused({.corner = corner},
            {"out of range", "is not in the file", "reaches before the first", "counts from 1"}, indexed);
  }
  refused({.without_elements = true}, {"no faces", "no triangles", "no tetrahedra"}, every);
}

TEST_CASE("every format: absurd counts are refused before memory is taken for them") {
  const auto has_counts = [](const Sample& sample) { return sample.counted && sample.indexed; };
  for (const std::int64_t count : {4000000000, 2147483647L, 1000L, -2L}) {
    CAPTURE(count);
    const auto texts = {"more than the file can hold", "is negative", "is too large",
                        "is not a number of items",    " bytes for ", "$EndElements expected"};
    refused({.vertices = count}, texts, has_counts);
    refused({.elements = count}, texts, has_counts);
  }
  refused({.elements = 1000}, {"1000 triangles of 50 bytes: 100 bytes follow"},
          [](const Sample& sample) { return sample.name == "s_binary.stl"; });
}

TEST_CASE("every format: a file cut off anywhere is an error or a valid mesh") {
  for (const Sample& sample : all_samples())
    for (std::size_t length = 0; length < sample.contents.size(); ++length) {
      const std::string message = message_of(sample.name, sample.contents.substr(0, length), sample.tets);
      CAPTURE(sample.name);
      CAPTURE(length);
      CAPTURE(message);
      CHECK((message.empty() || names_place(message, sample)));
    }
  std::vector<Written> files = written(procedural_face(8));
  for (const Written& file : written(tet_bar(3, 4, 5))) files.push_back(file);
  for (const Written& file : files)
    for (std::size_t percent = 0; percent < 100; ++percent) {
      const std::string message =
          message_of(file.name, file.contents.substr(0, file.contents.size() * percent / 100), file.tets);
      CAPTURE(file.name);
      CAPTURE(percent);
      CHECK(message != "an invalid mesh");
    }
}

TEST_CASE("every format: changed bytes are an error or a valid mesh") {
  std::mt19937 random(7);
  for (const Sample& sample : all_samples())
    for (int trial = 0; trial < 400; ++trial) {
      std::string contents = sample.contents;
      for (unsigned changes = 1 + random() % 3; changes > 0; --changes)
        contents[random() % contents.size()] =
            static_cast<char>(random() % 4 > 0 ? ' ' + random() % 95 : random());
      const std::string message = message_of(sample.name, contents, sample.tets);
      CAPTURE(sample.name);
      CAPTURE(contents);
      CHECK(message != "an invalid mesh");
    }
}

TEST_CASE("every format: empty files, garbage and other formats are refused") {
  std::mt19937 random(3);
  std::string noise(1000, '\0');
  for (char& c : noise) c = static_cast<char>(random());
  std::vector<Sample> others = all_samples();
  for (const char* start : {"", "\n", " ", "solid", "<", "$", "ply", "OFF", "v"})
    others.push_back({start, start});
  for (const std::string& garbage : {std::string(200, '\0'), std::string(200, '\xff'), noise})
    others.push_back({"garbage", garbage});
  for (Sample sample : all_samples()) {
    sample.text = false;  // what is not text may be named by byte
    for (const Sample& other : others) {
      if (extension(other.name) == extension(sample.name)) continue;
      const std::string message = message_of(sample.name, other.contents, sample.tets);
      CAPTURE(sample.name);
      CAPTURE(other.name);
      CAPTURE(message);
      CHECK(names_place(message, sample));
    }
  }
}

TEST_CASE("every format: what cannot be opened, and what has no known extension") {
  const Scratch folder;
  for (const Sample& sample : all_samples()) {
    CAPTURE(sample.name);
    const auto read = [&](const std::string& path) {
      sample.tets ? void(read_tets(path)) : void(read_surface(path));
    };
    CHECK_THROWS_WITH_AS(read(folder.file("none_" + sample.name)),
                         doctest::Contains("cannot read: No such file"), Error);
    fs::create_directory(folder.file("folder_" + sample.name));
    CHECK_THROWS_WITH_AS(read(folder.file("folder_" + sample.name)),
                         doctest::Contains("cannot read: Is a directory"), Error);
    read(folder.with(sample.name, sample.contents));
    const std::string cut =
        folder.with("cut_" + sample.name, sample.contents.substr(0, sample.contents.size() / 4));
    CHECK_THROWS_WITH_AS(read(cut), doctest::Contains((cut + ":").c_str()), Error);
  }
  CHECK_THROWS_WITH_AS(read_surface("a.xyz"),
                       "a.xyz: cannot tell the format: the name ends in none of .obj, .off, .ply, .stl, "
                       ".msh, .mesh, .vtk, .vtu",
                       Error);
  CHECK_THROWS_WITH_AS(
      read_tets("a.obj"),
      "a.obj: cannot tell the format: the name ends in none of .msh, .mesh, .vtk, .vtu, .node, .ele", Error);
  CHECK_THROWS_WITH_AS(write_surface("a.stl", square()),
                       doctest::Contains("ends in none of .obj, .off, .ply"), Error);
  CHECK_THROWS_WITH_AS(write_tets("a", sample_tets()), doctest::Contains("a: cannot tell the format"), Error);
}

TEST_CASE("every format: writing and reading gives the same bits") {
  SurfaceMesh mesh = procedural_face(9);
  make_awkward(mesh.vertices);
  for (const Written& file : written(mesh)) {
    CAPTURE(file.name);
    CAPTURE(file.contents.substr(0, 60));
    const SurfaceMesh back = parse_surface(file.name, file.contents);
    CHECK(same_bits(back.vertices, mesh.vertices));
    CHECK(back.triangles == mesh.triangles);
  }
  TetMesh tets = tet_bar(3, 3, 3);
  make_awkward(tets.vertices);
  for (const Written& file : written(tets)) {
    CAPTURE(file.name);
    CAPTURE(file.contents.substr(0, 60));
    const TetMesh back = parse_tets(file.name, file.contents);
    CHECK(same_bits(back.vertices, tets.vertices));
    CHECK(back.tets == tets.tets);
  }
}

TEST_CASE("every format: files by extension, in any case") {
  const Scratch folder;
  const SurfaceMesh mesh = procedural_face(4);
  for (const char* name : {"a.obj", "a.OFF", "a.ply", "a.Msh", "a.mesh", "a.vtk", "a.VTU"}) {
    CAPTURE(name);
    write_surface(folder.file(name), mesh);
    const SurfaceMesh back = read_surface(folder.file(name));
    CHECK(same_bits(back.vertices, mesh.vertices));
    CHECK(back.triangles == mesh.triangles);
  }
  const TetMesh tets = tet_bar(2, 2, 2);
  for (const char* name : {"b.msh", "b.mesh", "b.vtk", "b.vtu"}) {
    CAPTURE(name);
    write_tets(folder.file(name), tets);
    const TetMesh back = read_tets(folder.file(name));
    CHECK(same_bits(back.vertices, tets.vertices));
    CHECK(back.tets == tets.tets);
  }
}

TEST_CASE("every format: what cannot be written is refused and leaves nothing behind") {
  const Scratch folder;
  for (const char* name : {"a.obj", "a.off", "a.ply", "a.msh", "a.mesh", "a.vtk", "a.vtu", "a.glb"}) {
    CAPTURE(name);
    const auto fails = [&](const SurfaceMesh& mesh, const char* message) {
      CHECK_THROWS_WITH_AS(write_surface(folder.file(name), mesh), doctest::Contains(message), Error);
    };
    SurfaceMesh mesh = square();
    mesh.vertices(2, 1) = infinity;
    fails(mesh, "vertex 2 has a coordinate that is not finite");
    mesh = square();
    mesh.triangles(1, 2) = 4;
    fails(mesh, "triangle 1 (vertices 0 2 4): index out of range, there are 4 points");
    fails(SurfaceMesh(), "the mesh has no triangles");
    CHECK_THROWS_WITH_AS(write_surface(folder.file(std::string("no/such/") + name), square()),
                         doctest::Contains("cannot write"), Error);
  }
  for (const char* name : {"a.msh", "a.mesh", "a.vtk", "a.vtu"}) {
    CAPTURE(name);
    const auto fails = [&](const TetMesh& mesh, const char* message) {
      CHECK_THROWS_WITH_AS(write_tets(folder.file(name), mesh), doctest::Contains(message), Error);
    };
    TetMesh mesh = sample_tets();
    mesh.vertices(3, 0) = std::numeric_limits<double>::quiet_NaN();
    fails(mesh, "vertex 3 has a coordinate that is not finite");
    mesh = sample_tets();
    mesh.tets(1, 0) = -1;
    fails(mesh, "tet 1 (vertices -1 2 3 4): index out of range, there are 5 points");
    fails(TetMesh(), "the mesh has no tetrahedra");
  }
  CHECK(folder.empty());
}

TEST_CASE("every format: surfaces and tetrahedra are told apart") {
  std::set<std::string> checked;
  for (const Sample& sample : all_samples()) {
    const std::string kind = extension(sample.name);
    if (kind != ".msh" && kind != ".mesh" && kind != ".vtk" && kind != ".vtu") continue;
    checked.insert(kind + (sample.tets ? " of tetrahedra" : ""));
    CAPTURE(sample.name);
    CHECK(contains(message_of(sample.name, sample.contents, !sample.tets),
                   sample.tets ? "no triangles: a mesh of 2 tetrahedra, to be read as such"
                               : "no tetrahedra: a surface of 2 faces, to be read as such"));
  }
  CHECK(checked.size() == 8);
}

TEST_CASE("every format: reading and writing do not depend on the locale") {
  const char* comma = std::setlocale(LC_ALL, "de_DE.UTF-8");
  if (!comma) MESSAGE("locale de_DE.UTF-8 is not installed: tested under the plain one");
  for (const Sample& sample : all_samples())
    CHECK(message_of(sample.name, sample.contents, sample.tets) == "");
  for (const Written& file : written(procedural_face(3)))
    CHECK(message_of(file.name, file.contents, false) == "");
  std::setlocale(LC_ALL, "C");
}
