#include "../src/sdpa_format.hpp"
#include "reference_problems.hpp"

#include <isostretch/baselines/measures.hpp>

#include <doctest/doctest.h>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <set>
#include <sstream>
#include <tuple>

namespace {

using namespace isostretch;

// The file as a program sees it: sum_k v_k A_k - A_0, block by block.
struct SdpaFile {
  explicit SdpaFile(std::istream& in) {
    std::size_t variables = 0, blocks = 0;
    in >> variables >> blocks;
    sizes.resize(blocks);
    cost.resize(variables);
    for (int& size : sizes) in >> size;
    for (double& c : cost) in >> c;
    for (Entry entry; in >> entry.variable >> entry.block >> entry.row >> entry.column >> entry.value;)
      entries.push_back(entry);
    REQUIRE(in.eof());
  }

  std::vector<Eigen::MatrixXd> blocks(const std::vector<double>& v) const {
    std::vector<Eigen::MatrixXd> result;
    for (const int size : sizes) result.push_back(Eigen::MatrixXd::Zero(size, size));
    for (const Entry& entry : entries) {
      const double value =
          entry.variable == 0 ? -entry.value : v[static_cast<std::size_t>(entry.variable) - 1] * entry.value;
      Eigen::MatrixXd& block = result[static_cast<std::size_t>(entry.block) - 1];
      block(entry.row - 1, entry.column - 1) += value;
      if (entry.row != entry.column) block(entry.column - 1, entry.row - 1) += value;
    }
    return result;
  }

  struct Entry {
    int variable = 0, block = 0, row = 0, column = 0;
    double value = 0;
  };
  std::vector<int> sizes;
  std::vector<double> cost;
  std::vector<Entry> entries;
};

// All that a problem may have.
sdp_penalty::Problem rich_problem(const tests::Reference& reference) {
  sdp_penalty::Problem problem = reference.problem;
  problem.margin = 0.01;
  problem.incompressibility = 3;
  problem.alpha = 70;
  for (std::size_t e = 0; e < problem.weights.size(); ++e) problem.weights[e] = 0.5 + 0.1 * double(e % 7);
  for (std::size_t h = 0; h < problem.targets.size(); h += 3) problem.targets[h].hard = true;
  return problem;
}

// Positions that keep hard targets.
Vector some_positions(const sdp_penalty::Problem& problem, const Vector& rest) {
  Vector x = rest;
  for (int i = 0; i < x.size(); ++i) x[i] += 0.05 * std::sin(3.0 * i);
  for (const auto& target : problem.targets)
    for (int r = 0; target.hard && r < problem.dim(); ++r)
      x[target.node * problem.dim() + r] = target.position[static_cast<std::size_t>(r)];
  return x;
}

bool is_hard(const sdp_penalty::Problem& problem, int node) {
  return std::any_of(problem.targets.begin(), problem.targets.end(),
                     [&](const auto& target) { return target.hard && target.node == node; });
}

// v with epigraph variables as low as their blocks allow: where the Schur complement is 0.
std::vector<double> tight(const SdpaFile& file, const sdp_penalty::Problem& problem, const Vector& x) {
  std::vector<double> v;
  for (int i = 0; i < x.size(); ++i)
    if (!is_hard(problem, i / problem.dim())) v.push_back(x[i]);
  const std::size_t unknowns = v.size();
  v.resize(file.cost.size(), 0.0);
  const auto blocks = file.blocks(v);
  for (const auto& entry : file.entries) {
    const auto variable = static_cast<std::size_t>(entry.variable);
    if (variable <= unknowns) continue;
    const Eigen::MatrixXd& block = blocks[static_cast<std::size_t>(entry.block) - 1];
    const int last = entry.row - 1;
    CHECK(entry.value == 1);
    CHECK(block.topLeftCorner(last, last).isIdentity());
    v[variable - 1] = block.col(last).head(last).squaredNorm();
  }
  return v;
}

double least_eigenvalue(const std::vector<Eigen::MatrixXd>& blocks) {
  double least = 1e300;
  for (const Eigen::MatrixXd& block : blocks)
    least = std::min(least, Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(block).eigenvalues()[0]);
  return least;
}

TEST_CASE("The file's objective and blocks are the problem's energy and constraints") {
  int checked = 0;
  for (const tests::Reference& reference : tests::references()) {
    if (reference.problem.element_count() > 200) continue;
    ++checked;
    CAPTURE(reference.name);
    const sdp_penalty::Problem problem = rich_problem(reference);
    const baselines::SemidefiniteProgram program(problem);
    std::stringstream text;
    program.write(text);
    const SdpaFile file(text);
    REQUIRE(static_cast<int>(file.cost.size()) == program.variables());

    const Vector x = some_positions(problem, reference.rest);
    const std::vector<double> v = tight(file, problem, x);
    double objective = 0;
    for (std::size_t k = 0; k < v.size(); ++k) objective += file.cost[k] * v[k];
    const double energy = sdp_penalty::energy(problem, x);
    CHECK(std::abs(objective - energy) <= 1e-13 * energy);

    const double expected = baselines::measure(problem, x).min_eigenvalue - problem.margin;
    REQUIRE(expected < -1e-3);
    CHECK(std::abs(least_eigenvalue(file.blocks(v)) - expected) <= 1e-12);
    CHECK((program.positions(v) - x).lpNorm<Eigen::Infinity>() == 0);
  }
  CHECK(checked == 2);
}

TEST_CASE("A bound on stretch is a block that is singular where the largest singular value meets it") {
  sdp_penalty::Problem problem = tests::references().back().problem;
  REQUIRE(problem.dim() == 2);
  const Vector x = some_positions(problem, tests::references().back().rest);
  double largest = 0;
  for (int e = 0; e < problem.element_count(); ++e) {
    Eigen::Matrix2d F = Eigen::Matrix2d::Zero();
    for (int a = 0; a < 3; ++a) {
      const double* g = problem.elements.gradients.data() + (e * 3 + a) * 2;
      const int node = problem.elements.nodes[static_cast<std::size_t>(e * 3 + a)];
      F += Eigen::Vector2d(x[2 * node], x[2 * node + 1]) * Eigen::RowVector2d(g[0], g[1]);
    }
    largest = std::max(largest, F.jacobiSvd().singularValues()[0]);
  }
  problem.largest_stretch = largest;
  std::stringstream text;
  baselines::SemidefiniteProgram(problem).write(text);
  const SdpaFile file(text);
  std::vector<Eigen::MatrixXd> blocks = file.blocks(tight(file, problem, x));
  std::erase_if(blocks, [](const auto& block) { return block.rows() != 4; });
  REQUIRE(static_cast<int>(blocks.size()) == problem.element_count());
  CHECK(std::abs(least_eigenvalue(blocks)) <= 1e-12);
}

TEST_CASE("No entry of the file stands there twice, and all are in the upper triangle and in order") {
  std::stringstream text;
  baselines::SemidefiniteProgram(rich_problem(tests::references().front())).write(text);
  std::tuple<int, int, int, int> before{};
  for (const auto& entry : SdpaFile(text).entries) {
    CHECK(entry.row <= entry.column);
    const std::tuple now(entry.variable, entry.block, entry.row, entry.column);
    CHECK(before < now);
    before = now;
  }
}

}  // namespace
