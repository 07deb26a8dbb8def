#include "conditional.hpp"
#include "process.hpp"
#include "scratch.hpp"

#include <isostretch/fem/element_arrays.hpp>
#include <isostretch/mesh/generators.hpp>
#include <isostretch/mesh_io/io.hpp>
#include <isostretch/surface/orientation.hpp>

#include <doctest/doctest.h>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <cmath>
#include <string>

using namespace isostretch;
using namespace isostretch::test;
using doctest::Approx;
using isostretch::tests::outside_data;
using isostretch::tests::outside_path;

namespace {

// A face of area 9, so that normalising and undoing it shows.
std::string write_face(const Scratch& scratch, int rings = 10) {
  mesh::SurfaceMesh face = mesh::procedural_face(rings);
  face.vertices *= 3 / std::sqrt(mesh::total_area(face));
  mesh::write_obj(scratch.path("face.obj"), face);
  return scratch.path("face.obj");
}

// sum A (|J|^2 + |J^-1|^2) / sum A, from the written file alone and without the libraries that wrote it.
double symmetric_dirichlet(const mesh::SurfaceMesh& mesh) {
  double energy = 0, total = 0;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const Eigen::Vector3d p = mesh.vertices.row(mesh.triangles(t, 0));
    const Eigen::Vector3d a = mesh.vertices.row(mesh.triangles(t, 1)).transpose() - p;
    const Eigen::Vector3d b = mesh.vertices.row(mesh.triangles(t, 2)).transpose() - p;
    const Eigen::Vector3d e = a.normalized(), f = a.cross(b).normalized().cross(e);
    Eigen::Matrix2d rest, flat;
    rest << a.dot(e), b.dot(e), a.dot(f), b.dot(f);
    const Eigen::RowVector2d q = mesh.uv.row(mesh.uv_triangles(t, 0));
    flat << (mesh.uv.row(mesh.uv_triangles(t, 1)) - q).transpose(),
        (mesh.uv.row(mesh.uv_triangles(t, 2)) - q).transpose();
    const Eigen::Matrix2d jacobian = flat * rest.inverse();
    const double area = 0.5 * rest.determinant();
    energy += area * (jacobian.squaredNorm() + jacobian.inverse().squaredNorm());
    total += area;
  }
  return energy / total;
}

}  // namespace

TEST_CASE("a face is flattened and everything is written") {
  const Scratch scratch;
  const std::string model = write_face(scratch);
  const Outcome run = parameterize({model, "--energy", "symmetric_dirichlet", "--out", scratch.path("out/")});
  CHECK_MESSAGE(run.code == 0, run.err);
  CHECK(run.err.empty());
  CHECK(run.out.find("converged") != std::string::npos);
  CHECK(scratch.contents() == std::vector<std::string>{"face.obj", "out", "out/face_uv.obj", "out/layout.png",
                                                       "out/model.png", "out/report.html", "out/summary.json",
                                                       "out/trace.csv"});
  const auto summary = read_json(scratch.path("out/summary.json"));
  const mesh::SurfaceMesh input = mesh::read_obj(model),
                          result = mesh::read_obj(scratch.path("out/face_uv.obj"));

  SUBCASE("the summary says all that is promised") {
    CHECK(summary["status"] == "converged_scaled_gradient");
    CHECK(summary["message"].is_string());
    for (const char* key : {"iterations", "factorizations", "failed_factorizations", "flipped", "threads"})
      CHECK_MESSAGE(summary[key].is_number_integer(), key);
    for (const char* key : {"energy", "initial_energy", "gradient_inf_norm", "soft_pin_energy"})
      CHECK_MESSAGE(summary[key].is_number(), key);
    double phases = 0;
    for (const char* key :
         {"read", "initial", "setup", "assembly", "factorization", "solve", "line_search", "write"}) {
      CHECK_MESSAGE(summary["seconds"][key].get<double>() >= 0, key);
      phases += summary["seconds"][key].get<double>();
    }
    CHECK(phases <= summary["seconds"]["total"].get<double>() * 1.001);
    CHECK(summary["energy_name"] == "symmetric_dirichlet");
    CHECK(summary["energy_parameters"]["weight"] == 1.0);
    CHECK(summary["mesh"]["vertices"] == input.vertices.rows());
    CHECK(summary["mesh"]["triangles"] == input.triangles.rows());
    CHECK(summary["mesh"]["area"].get<double>() == Approx(9));
    CHECK(summary["options"]["newton"]["projection"] == "adaptive");
    CHECK(summary["distortion"]["min_sigma"].get<double>() > 0);
    CHECK(summary["distortion"]["max_sigma"].get<double>() >=
          summary["distortion"]["mean_sigma"].get<double>());
    CHECK(summary["version"].is_string());
    CHECK(summary["instruction_set"].is_string());
    CHECK(summary["solver"].is_string());
  }
  SUBCASE("the layout has the input's geometry, no flips, and the energy and units stated") {
    CHECK(result.vertices == input.vertices);
    CHECK(result.triangles == input.triangles);
    CHECK(summary["flipped"] == 0);
    CHECK(mesh::count_flipped(result.uv, result.uv_triangles) == 0);
    const double unit = summary["layout"]["uv_per_length"];
    CHECK(result.uv.minCoeff() > 0);
    CHECK(result.uv.maxCoeff() < 1);
    mesh::SurfaceMesh in_model_units = result;
    in_model_units.uv /= unit;
    CHECK(summary["energy"].get<double>() == Approx(symmetric_dirichlet(in_model_units)).epsilon(1e-10));
    CHECK(summary["energy"].get<double>() < summary["initial_energy"].get<double>());
    const double area = mesh::orientation(result.uv, result.uv_triangles).total_area / (unit * unit);
    CHECK(area == Approx(9 * summary["distortion"]["mean_area_ratio"].get<double>()).epsilon(1e-10));
  }
  SUBCASE("the trace has a row for the start and one per iteration") {
    const std::string trace = read_file(scratch.path("out/trace.csv"));
    CHECK(trace.rfind("iteration,seconds,energy,gradient_inf_norm,", 0) == 0);
    CHECK(std::count(trace.begin(), trace.end(), '\n') == summary["iterations"].get<int>() + 2);
  }
  SUBCASE("the picture is a PNG of 1600 x 900") {
    const std::string png = read_file(scratch.path("out/layout.png"));
    CHECK(png.substr(1, 3) == "PNG");
    CHECK(png.substr(16, 8) == std::string("\0\0\x06\x40\0\0\x03\x84", 8));
  }
  SUBCASE("the result is a start that has converged already") {
    const Outcome again = parameterize({scratch.path("out/face_uv.obj"), "--initial", "input", "--out",
                                        scratch.path("again"), "--gradient-tolerance", "1e-3"});
    CHECK_MESSAGE(again.code == 0, again.err);
    const auto second = read_json(scratch.path("again/summary.json"));
    CHECK(second["iterations"] == 0);
    CHECK(second["energy"].get<double>() == Approx(summary["energy"].get<double>()).epsilon(1e-9));
  }
}

TEST_CASE("uv in units of the model, of total area 1 and of the unit square differ by a factor") {
  const Scratch scratch;
  const std::string model = write_face(scratch, 4);
  const auto uv_in = [&](const std::string& units, const std::vector<std::string>& more) {
    std::vector<std::string> command = {
        model, "-o", scratch.path(units), "--no-picture", "--max-iterations", "3", "--uv-units", units};
    command.insert(command.end(), more.begin(), more.end());
    CHECK(parameterize(command).code == 5);
    return mesh::read_obj(scratch.path(units + "/face_uv.obj")).uv;
  };
  const auto unit_of = [&](const std::string& units) {
    return read_json(scratch.path(units + "/summary.json"))["layout"]["uv_per_length"].get<double>();
  };
  for (const std::vector<std::string>& more :
       {std::vector<std::string>{}, {"--pack", "none"}, {"--margin", "0"}}) {
    const mesh::Points2 lengths = uv_in("model", more), area = uv_in("area", more),
                        square = uv_in("square", more);
    CHECK((lengths - 3 * area).cwiseAbs().maxCoeff() < 1e-12);
    CHECK(unit_of("model") == Approx(1));
    CHECK(unit_of("area") == Approx(1.0 / 3));
    const Eigen::RowVector2d shift = square.row(0) - unit_of("square") * lengths.row(0);
    CHECK(((square - unit_of("square") * lengths).rowwise() - shift).cwiseAbs().maxCoeff() < 1e-12);
    const double margin = more.size() == 2 && more[0] == "--margin" ? 0 : 1.0 / 256;
    CHECK(square.minCoeff() >= margin - 1e-12);
    CHECK(square.maxCoeff() <= 1 - margin + 1e-12);
    CHECK(square.maxCoeff() > 0.97);
  }
  CHECK(parameterize({model, "-o", scratch.path("no"), "--uv-units", "square", "--pin", "0:0,0"}).code == 2);
}

TEST_CASE("one thread and two write the same bytes") {
  const Scratch scratch;
  const std::string model = write_face(scratch, 30);
  CHECK(parameterize({model, "-o", scratch.path("one"), "--threads", "1", "--no-picture"}).code == 0);
  CHECK(parameterize({model, "-o", scratch.path("two"), "--threads", "2", "--no-picture"}).code == 0);
  CHECK(read_json(scratch.path("one/summary.json"))["threads"] == 1);
  CHECK(read_file(scratch.path("one/face_uv.obj")) == read_file(scratch.path("two/face_uv.obj")));
}

TEST_CASE("quiet prints nothing at all") {
  const Scratch scratch;
  mesh::write_obj(scratch.path("ball.obj"), mesh::icosphere(2));  // closed: there would be a notice
  const Outcome run = parameterize({scratch.path("ball.obj"), "-o", scratch.path("out"), "--quiet"});
  CHECK(run.code == 0);
  CHECK(run.out.empty());
  CHECK(run.err.empty());
}

TEST_CASE("a closed surface is cut open with a notice") {
  const Scratch scratch;
  mesh::write_obj(scratch.path("ball.obj"), mesh::icosphere(2));
  const Outcome run = parameterize({scratch.path("ball.obj"), "-o", scratch.path("out"), "--no-picture"});
  CHECK_MESSAGE(run.code == 0, run.err);
  CHECK(run.err.find("cut open: ") != std::string::npos);
  const auto summary = read_json(scratch.path("out/summary.json"));
  const auto result = mesh::read_obj(scratch.path("out/ball_uv.obj"));
  CHECK(summary["layout"]["cut_edges"].get<int>() >= 3);
  CHECK(result.uv.rows() == result.vertices.rows() + summary["layout"]["cut_edges"].get<int>() - 1);
  CHECK(result.vertices == mesh::icosphere(2).vertices);
  CHECK(mesh::count_flipped(result.uv, result.uv_triangles) == 0);

  SUBCASE("and the seam is understood when the result is the next start") {
    const Outcome again =
        parameterize({scratch.path("out/ball_uv.obj"), "--initial", "input", "-o", scratch.path("again"),
                      "--no-picture", "--gradient-tolerance", "1e-3"});
    CHECK_MESSAGE(again.code == 0, again.err);
    const auto second = read_json(scratch.path("again/summary.json"));
    CHECK(second["iterations"] == 0);
    CHECK(second["energy"].get<double>() == Approx(summary["energy"].get<double>()).epsilon(1e-9));
  }
}

TEST_CASE("energies of every kind find their minimum on a flat disc") {
  const Scratch scratch;
  mesh::write_obj(scratch.path("disc.obj"), mesh::disc(6));
  const std::pair<const char*, double> minima[] = {
      {"symmetric_dirichlet", 4}, {"mips_2d", 2}, {"arap", 0}, {"symmetric_arap", 0}};
  for (const auto& entry : minima) {
    const char* const energy = entry.first;  // clang 14 captures no structured binding in doctest's macros
    const double minimum = entry.second;
    const Outcome run =
        parameterize({scratch.path("disc.obj"), "-e", energy, "-o", scratch.path(energy), "--no-picture"});
    CHECK_MESSAGE(run.code == 0, energy << ": " << run.err);
    const auto summary = read_json(scratch.path(std::string(energy) + "/summary.json"));
    CHECK(summary["energy"].get<double>() == Approx(minimum).epsilon(1e-8));
    CHECK(summary["flipped"] == 0);
  }
}

TEST_CASE("parameters reach the energy") {
  const Scratch scratch;
  const std::string model = write_face(scratch, 4);
  CHECK(parameterize({model, "-o", scratch.path("one"), "--no-picture"}).code == 0);
  CHECK(parameterize({model, "-o", scratch.path("half"), "--no-picture", "--param", "weight=0.5"}).code == 0);
  const auto one = read_json(scratch.path("one/summary.json")),
             half = read_json(scratch.path("half/summary.json"));
  CHECK(half["energy_parameters"]["weight"] == 0.5);
  CHECK(half["energy"].get<double>() == Approx(0.5 * one["energy"].get<double>()).epsilon(1e-9));
}

TEST_CASE("a published disk converges as published" * outside_data({"meshes/disks/lilium_6k.obj"})) {
  const std::string model = outside_path("meshes/disks/lilium_6k.obj");
  const Scratch scratch;
  const Outcome run = parameterize({model, "-o", scratch.path("out"), "--gradient-tolerance", "1e-4"});
  CHECK_MESSAGE(run.code == 0, run.err);
  const auto summary = read_json(scratch.path("out/summary.json"));
  CHECK(summary["status"] == "converged_gradient");
  CHECK(summary["iterations"].get<int>() <= 7);
  CHECK(summary["gradient_inf_norm"].get<double>() <= 1e-4);
  CHECK(summary["energy"].get<double>() == Approx(4.0233722459).epsilon(1e-6));
  CHECK(summary["flipped"] == 0);
}
