#pragma once

// Reader and acceptance rule of the golden data; see README.md here. Test code: needs nlohmann-json, and
// links isostretch_test_support.

#include "paths.hpp"

#include <isostretch/core/error.hpp>

#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <map>
#include <string>
#include <vector>

namespace isostretch::golden {

struct Quantity {
  Eigen::MatrixXd value;  // psi: 1 x 1, grad: n x 1, H and HP: n x n, n = dim^2
  double sensitivity = 0;
};

struct Record {
  std::string energy;                        // our name
  std::map<std::string, double> parameters;  // ours
  bool smooth = false;                       // else only psi is set, without a sensitivity
  bool comparable = false;  // smooth, and F is not within rounding of the border of the domain
  Quantity psi, grad, H, HP;
};

struct Case {
  std::string id, category;
  Eigen::MatrixXd F;
  std::vector<Record> records;
};

inline constexpr double acceptance = 30;

// The C of the acceptance rule that `value` needs. scale: |psi|, |grad|, or |H| for H and HP. Norms without
// overflow: entries reach 1e290.
inline double needed_constant(const Eigen::MatrixXd& value, const Quantity& reference, double scale) {
  const double error = (value - reference.value).reshaped().stableNorm();
  if (error == 0) return 0;
  const double allowed = std::ldexp(scale, -52) + reference.sensitivity;
  return error / allowed;
}

namespace detail {

inline std::map<std::string, double> parameters_of(const nlohmann::json& given, const std::string& energy) {
  std::map<std::string, double> parameters;
  for (const auto& [name, value] : given.items()) parameters[name == "lam" ? "lambda" : name] = value;
  if (energy == "symdir") parameters["weight"] = 0.5;
  return parameters;
}

inline std::string our_name(const std::string& energy) {
  static const std::map<std::string, std::string> names = {
      {"dirichlet", "dirichlet"},        {"arap", "arap"},
      {"corot", "corotational"},         {"symdir", "symmetric_dirichlet"},
      {"sarap", "symmetric_arap"},       {"mips2d", "mips_2d"},
      {"amips3d", "conformal_amips_3d"}, {"mips3d", "mips_3d"},
      {"svk", "st_venant_kirchhoff"},    {"snh", "stable_neo_hookean"},
      {"nh_log", "neo_hookean_log"},     {"fixed_corot", "fixed_corotational"}};
  const auto found = names.find(energy);
  return found == names.end() ? energy : found->second;  // registry_*.json has our names
}

inline Eigen::MatrixXd column(const nlohmann::json& numbers) {
  Eigen::MatrixXd v(static_cast<Eigen::Index>(numbers.size()), 1);
  for (Eigen::Index i = 0; i < v.size(); ++i) v(i) = numbers[static_cast<std::size_t>(i)];
  return v;
}

inline Eigen::MatrixXd symmetric(const nlohmann::json& upper, Eigen::Index n) {
  Eigen::MatrixXd M(n, n);
  std::size_t next = 0;
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = i; j < n; ++j) M(i, j) = M(j, i) = upper.at(next++);
  return M;
}

inline Record record(const std::string& energy, const nlohmann::json& given, const nlohmann::json& parameters,
                     Eigen::Index n) {
  Record r;
  r.energy = our_name(energy);
  r.parameters = parameters_of(parameters, energy);
  r.smooth = given.at("status") == "ok";
  r.psi.value = Eigen::MatrixXd::Constant(1, 1, given.at("psi"));
  if (!r.smooth) return r;
  const auto& sensitivity = given.at("sens");
  r.comparable = sensitivity.is_object();
  const auto sens = [&](const char* what) { return r.comparable ? sensitivity.at(what).get<double>() : 0.0; };
  r.psi.sensitivity = sens("psi");
  r.grad = {column(given.at("grad")), sens("grad")};
  r.H = {symmetric(given.at("H"), n), sens("H")};
  r.HP = {symmetric(given.at("HP"), n), sens("HP")};
  return r;
}

}  // namespace detail

namespace detail {

inline void append(const std::string& set, int dim, std::vector<Case>& cases) {
  const std::string path = tests::source_path("tests/golden/" + set + "_" + std::to_string(dim) + "d.json");
  std::ifstream file(path);
  const auto data = nlohmann::json::parse(file, nullptr, false);
  if (data.is_discarded()) throw Error("cannot read golden data " + path);
  for (const auto& given : data.at("cases")) {
    Case c{given.at("id"), given.at("category"), column(given.at("F")).reshaped(dim, dim), {}};
    for (const auto& [energy, result] : given.at("results").items())
      c.records.push_back(record(energy, result, data.at("meta").at("energies").at(energy), dim * dim));
    cases.push_back(std::move(c));
  }
}

}  // namespace detail

/// Returns all cases of one dimension (2 or 3): those that came with the project, then those of the other
/// energies. Throws Error naming the file that cannot be read.
inline std::vector<Case> read(int dim) {
  std::vector<Case> cases;
  for (const char* set : {"golden", "registry"}) detail::append(set, dim, cases);
  return cases;
}

}  // namespace isostretch::golden
