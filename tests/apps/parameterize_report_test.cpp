#include "process.hpp"
#include "scratch.hpp"

#include <isostretch/mesh/generators.hpp>
#include <isostretch/mesh_io/io.hpp>

#include <doctest/doctest.h>

#include <filesystem>
#include <set>
#include <string>
#include <vector>

using namespace isostretch;
using namespace isostretch::test;

namespace {

const std::string awkward = "a<b>&\"c'";

struct Size {
  unsigned width = 0, height = 0;
};

unsigned big_endian(const std::string& bytes, std::size_t at) {
  unsigned value = 0;
  for (std::size_t i = at; i < at + 4; ++i) value = value << 8U | static_cast<unsigned char>(bytes.at(i));
  return value;
}

Size png_size(const std::string& bytes) {
  REQUIRE(bytes.substr(0, 8) == "\x89PNG\r\n\x1a\n");
  CHECK(bytes.substr(bytes.size() - 8, 4) == "IEND");
  return {big_endian(bytes, 16), big_endian(bytes, 20)};
}

bool exists(const Scratch& scratch, const std::string& name) {
  return std::filesystem::exists(scratch.path(name));
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

// Where a tag ends that begins there; angle brackets in quotes are text.
std::size_t end_of_tag(const std::string& html, std::size_t begin) {
  bool quoted = false;
  for (std::size_t i = begin; i < html.size(); ++i) {
    if (html[i] == '"') quoted = !quoted;
    if (html[i] == '>' && !quoted) return i;
  }
  FAIL("a tag does not end");
  return html.size();
}

// Every tag that is opened is closed, in order.
void check_tags(const std::string& html) {
  const std::set<std::string> alone = {"meta", "img"};
  std::vector<std::string> open;
  REQUIRE(html.rfind("<!DOCTYPE html>\n", 0) == 0);
  for (std::size_t at = html.find('<', 1); at != std::string::npos; at = html.find('<', at)) {
    const std::size_t end = end_of_tag(html, at);
    const bool closes = html[at + 1] == '/';
    const std::size_t first = at + (closes ? 2 : 1);
    const std::string name = html.substr(first, std::min(html.find_first_of(" >", first), end) - first);
    REQUIRE_MESSAGE(name.find_first_not_of("abcdefghijklmnopqrstuvwxyz123456") == std::string::npos, name);
    if (closes) {
      REQUIRE_MESSAGE(!open.empty(), name);
      REQUIRE(open.back() == name);
      open.pop_back();
    } else if (alone.count(name) == 0) {
      open.push_back(name);
    }
    at = end;
  }
  CHECK(open.empty());
}

struct Report {
  Outcome run;
  std::string html;
};

Report report(const Scratch& scratch, const mesh::SurfaceMesh& model, const std::string& stem,
              std::vector<std::string> arguments = {}) {
  mesh::write_obj(scratch.path(stem + ".obj"), model);
  arguments.insert(arguments.begin(), {scratch.path(stem + ".obj"), "-o", scratch.path("out"), "-q"});
  Report result{parameterize(arguments), read_file(scratch.path("out/report.html"))};
  check_tags(result.html);
  return result;
}

// Tetrahedra side by side.
mesh::SurfaceMesh many_pieces(int count) {
  mesh::SurfaceMesh pieces;
  pieces.vertices.resize(4 * count, 3);
  pieces.triangles.resize(4 * count, 3);
  for (int i = 0; i < count; ++i) {
    const double x = 2 * i, size = 1 + 0.01 * i;
    pieces.vertices.middleRows(4 * i, 4) << x, 0, 0, x + size, 0, 0, x, size, 0, x, 0, size;
    pieces.triangles.middleRows(4 * i, 4) << 0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3;
    pieces.triangles.middleRows(4 * i, 4).array() += 4 * i;
  }
  return pieces;
}

}  // namespace

TEST_CASE("pictures and a report that needs nothing else are written") {
  const Scratch scratch;
  const Report result = report(scratch, mesh::icosphere(2), awkward);
  CHECK_MESSAGE(result.run.code == 0, result.run.err);
  const Size model = png_size(read_file(scratch.path("out/model.png")));
  CHECK(model.width == 1600);
  CHECK(model.height >= 400);
  CHECK(model.height <= 900);
  CHECK(png_size(read_file(scratch.path("out/layout.png"))).width == 1600);

  const std::string& html = result.html;
  CHECK(count(html, "<img ") == 2);
  CHECK(count(html, "src=\"data:image/png;base64,iVBORw0KGgo") == 2);
  CHECK(count(html, "src=") == 2);
  for (const char* elsewhere : {"://", "href", "<script", "<link", "@import", "url("})
    CHECK_MESSAGE(html.find(elsewhere) == std::string::npos, elsewhere);
  for (const char* word : {"converged", "1 chart; no triangle is turned over; nothing overlaps",
                           "symmetric_dirichlet", "<th>status</th>", "genus", "320"})
    CHECK_MESSAGE(html.find(word) != std::string::npos, word);
  CHECK(html.find("class=\"warnings\"") == std::string::npos);
}

TEST_CASE("names are escaped, and need not be UTF-8") {
  const Scratch scratch;
  const std::string html = report(scratch, mesh::disc(3), awkward).html;
  CHECK(html.find("a<b>") == std::string::npos);
  CHECK(count(html, "a&lt;b&gt;&amp;&quot;c&#39;.obj") >= 3);  // title, heading, options

  const Report other = report(scratch, mesh::disc(3), "\xff\x01");
  CHECK_MESSAGE(other.run.code == 0, other.run.err);
  CHECK(other.html.find("\uFFFD\uFFFD.obj") != std::string::npos);
  CHECK(other.html.find('\xff') == std::string::npos);
}

TEST_CASE("a report warns of what went wrong") {
  const Scratch scratch;
  const std::string html = report(scratch, mesh::procedural_face(8), "face", {"--max-iterations", "1"}).html;
  CHECK(html.find("class=\"verdict bad\"") != std::string::npos);
  CHECK(html.find("did not converge") != std::string::npos);
  const std::string bound =
      report(scratch, mesh::icosphere(2), "ball", {"--max-distortion", "1.01", "--max-cuts", "1"}).html;
  CHECK(bound.find("more than the 1.01 asked for") != std::string::npos);
}

TEST_CASE("charts are listed largest first, and not all of hundreds") {
  const Scratch scratch;
  const Report result = report(scratch, many_pieces(53), "many");
  CHECK_MESSAGE(result.run.code == 0, result.run.err);
  const std::size_t last = result.html.find("<tr><td class=\"number\">52</td>");
  REQUIRE(last != std::string::npos);
  CHECK(last < result.html.find("<tr><td class=\"number\">51</td>"));
  CHECK(result.html.find("<tr><td class=\"number\">2</td>") == std::string::npos);
  CHECK(result.html.find("and 3 more") != std::string::npos);
}

TEST_CASE("models of any size and place are drawn alike") {
  const Scratch scratch;
  mesh::SurfaceMesh ball = mesh::icosphere(2);
  report(scratch, ball, "ball", {"--max-iterations", "0"});
  const Size size = png_size(read_file(scratch.path("out/model.png")));
  for (const double scale : {1e-30, 1e30}) {
    ball.vertices = scale * mesh::icosphere(2).vertices;
    report(scratch, ball, "ball", {"--max-iterations", "0"});
    CHECK(png_size(read_file(scratch.path("out/model.png"))).height == size.height);
  }
}

TEST_CASE("without pictures there is no report either") {
  const Scratch scratch;
  mesh::write_obj(scratch.path("disc.obj"), mesh::disc(3));
  CHECK(parameterize({scratch.path("disc.obj"), "-o", scratch.path("out"), "-q", "--no-picture"}).code == 0);
  CHECK(exists(scratch, "out/disc_uv.obj"));
  for (const char* name : {"out/report.html", "out/model.png", "out/layout.png", "out/disc_uv.glb"})
    CHECK_MESSAGE(!exists(scratch, name), name);
}

TEST_CASE("glTF has the layout and a checkerboard that repeats") {
  const Scratch scratch;
  mesh::write_obj(scratch.path("ball.obj"), mesh::icosphere(2));
  CHECK(parameterize({scratch.path("ball.obj"), "-o", scratch.path("out"), "-q", "--no-picture", "--glb"})
            .code == 0);
  const std::string glb = read_file(scratch.path("out/ball_uv.glb"));
  REQUIRE(glb.substr(0, 4) == "glTF");
  const auto little_endian = [&](std::size_t at) {
    return big_endian({glb[at + 3], glb[at + 2], glb[at + 1], glb[at]}, 0);
  };
  CHECK(little_endian(8) == glb.size());
  const std::size_t length = little_endian(12);
  const auto json = nlohmann::json::parse(glb.substr(20, length));
  CHECK(json["meshes"][0]["primitives"][0]["attributes"].contains("TEXCOORD_0"));
  CHECK(json["materials"][0]["pbrMetallicRoughness"].contains("baseColorTexture"));
  for (const auto& sampler : json["samplers"]) CHECK(sampler.value("wrapS", 10497) == 10497);

  const auto& view = json["bufferViews"][json["images"][0]["bufferView"].get<std::size_t>()];
  const std::size_t start = 20 + length + 8 + view["byteOffset"].get<std::size_t>();
  const Size texture = png_size(glb.substr(start, view["byteLength"].get<std::size_t>()));
  CHECK(texture.width == 1024);
  CHECK(texture.height == 1024);
}
