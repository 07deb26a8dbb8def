#include "sdpa_format.hpp"

#include "corners.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <ostream>
#include <string>
#include <tuple>
#include <utility>

namespace isostretch::baselines {
namespace {

// Every double as the shortest text that reads back as itself.
void append(std::string& line, double value) {
  std::array<char, 32> text;
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value);
  line.append(text.data(), end);
}

}  // namespace

SemidefiniteProgram::Units SemidefiniteProgram::units_of(const sdp_penalty::Problem& problem,
                                                         const Vector& x) {
  // Accuracy is asked for relative to 1 + the optimum, so that energies are not scaled up to 1 at most, and
  // lengths not at all where they are moderate.
  constexpr double moderate = 1e3, largest_energy = 1e5;
  double extent = x.size() > 0 ? x.cwiseAbs().maxCoeff() : 0.0;
  for (const sdp_penalty::Target& target : problem.targets)
    for (const double coordinate : target.position) extent = std::max(extent, std::abs(coordinate));
  Units units;
  if (extent > 0 && (extent > moderate || extent < 1 / moderate)) units.length = extent;
  units.energy = std::max(1.0, sdp_penalty::energy(problem, x) / largest_energy);
  return units;
}

SemidefiniteProgram::SemidefiniteProgram(const sdp_penalty::Problem& problem, const Units& units)
    : units_(units) {
  number_unknowns(problem);
  for (int e = 0; e < problem.element_count(); ++e) {
    add_constraint(problem, e);
    add_elastic_term(problem, e);
    if (problem.incompressibility > 0) add_volume_term(problem, e);
    if (problem.bounds_stretch()) add_stretch_bound(problem, e);
  }
  for (const sdp_penalty::Target& target : problem.targets)
    if (!target.hard && problem.alpha > 0) add_target(problem, target);
  sort_entries();
}

// Readers differ in what order they expect; all of them take this one. What hard targets add up to is one
// constant.
void SemidefiniteProgram::sort_entries() {
  const auto place = [](const Entry& entry) {
    return std::tie(entry.variable, entry.block, entry.row, entry.column);
  };
  std::sort(entries_.begin(), entries_.end(),
            [&](const Entry& a, const Entry& b) { return place(a) < place(b); });
  std::vector<Entry> merged;
  for (const Entry& entry : entries_)
    if (!merged.empty() && place(merged.back()) == place(entry))
      merged.back().value += entry.value;
    else
      merged.push_back(entry);
  std::erase_if(merged, [](const Entry& entry) { return entry.value == 0; });
  entries_ = std::move(merged);
}

void SemidefiniteProgram::number_unknowns(const sdp_penalty::Problem& problem) {
  const auto dim = static_cast<std::size_t>(problem.dim());
  unknown_of_dof_.assign(static_cast<std::size_t>(problem.node_count()) * dim, 0);
  held_.assign(unknown_of_dof_.size(), 0.0);
  for (const sdp_penalty::Target& target : problem.targets)
    for (std::size_t r = 0; target.hard && r < dim; ++r) {
      const std::size_t dof = static_cast<std::size_t>(target.node) * dim + r;
      unknown_of_dof_[dof] = -1;
      held_[dof] = target.position[r];
    }
  for (int& unknown : unknown_of_dof_)
    if (unknown >= 0) unknown = unknowns_++;
  variables_ = unknowns_;
}

int SemidefiniteProgram::add_block(int size) {
  block_sizes_.push_back(size);
  return static_cast<int>(block_sizes_.size()) - 1;
}

// [[I, .], [., t]] with a new variable t.
int SemidefiniteProgram::add_epigraph_block(int rows) {
  const int block = add_block(rows + 1);
  for (int r = 0; r < rows; ++r) add_constant(block, r, r, 1);
  entries_.push_back({variables_++, block, rows, rows, 1});
  return block;
}

void SemidefiniteProgram::add_constant(int block, int row, int column, double value) {
  entries_.push_back({-1, block, row, column, value});
}

void SemidefiniteProgram::add_term(int block, int row, int column, int dof, double factor) {
  const int unknown = unknown_of_dof_[static_cast<std::size_t>(dof)];
  if (unknown < 0) return add_constant(block, row, column, factor * held_[static_cast<std::size_t>(dof)]);
  entries_.push_back({unknown, block, row, column, factor * units_.length});
}

void SemidefiniteProgram::add_constraint(const sdp_penalty::Problem& problem, int element) {
  const Corners corners(problem, element);
  const int dim = corners.dim, block = add_block(dim);
  for (int i = 0; i < dim; ++i) {
    add_constant(block, i, i, -problem.margin);
    for (int j = i; j < dim; ++j)
      for (int a = 0; a <= dim; ++a)
        for (int r = 0; r < dim; ++r)
          add_term(block, i, j, corners.dof(a, r), corners.constraint_coefficient(i, j, a, r));
  }
}

void SemidefiniteProgram::add_elastic_term(const sdp_penalty::Problem& problem, int element) {
  const Corners corners(problem, element);
  const int dim = corners.dim, last = dim * dim, block = add_epigraph_block(last);
  const double root = std::sqrt(problem.weights[static_cast<std::size_t>(element)] / units_.energy);
  for (int r = 0; r < dim; ++r)
    for (int c = 0; c < dim; ++c) {
      add_constant(block, r * dim + c, last, -root * corners.R(r, c));
      for (int a = 0; a <= dim; ++a)
        add_term(block, r * dim + c, last, corners.dof(a, r), root * corners.g(a, c));
    }
}

void SemidefiniteProgram::add_volume_term(const sdp_penalty::Problem& problem, int element) {
  const Corners corners(problem, element);
  const int dim = corners.dim, block = add_epigraph_block(1);
  const double root = std::sqrt(problem.incompressibility / 2 / units_.energy);
  add_constant(block, 0, 1, -root * dim);
  for (int a = 0; a <= dim; ++a)
    for (int r = 0; r < dim; ++r)
      add_term(block, 0, 1, corners.dof(a, r), root * corners.rotated_gradient(a, r));
}

// Singular values are those of F_i, whose entries have fewer terms than those of R_i^T F_i.
void SemidefiniteProgram::add_stretch_bound(const sdp_penalty::Problem& problem, int element) {
  const Corners corners(problem, element);
  const int dim = corners.dim, block = add_block(2 * dim);
  for (int i = 0; i < 2 * dim; ++i) add_constant(block, i, i, problem.largest_stretch);
  for (int r = 0; r < dim; ++r)
    for (int c = 0; c < dim; ++c)
      for (int a = 0; a <= dim; ++a) add_term(block, r, dim + c, corners.dof(a, r), corners.g(a, c));
}

void SemidefiniteProgram::add_target(const sdp_penalty::Problem& problem, const sdp_penalty::Target& target) {
  const int dim = problem.dim(), block = add_epigraph_block(dim);
  const double root = std::sqrt(problem.alpha / units_.energy);
  for (int r = 0; r < dim; ++r) {
    add_constant(block, r, dim, -root * target.position[static_cast<std::size_t>(r)]);
    add_term(block, r, dim, target.node * dim + r, root);
  }
}

void SemidefiniteProgram::write(std::ostream& out) const {
  out << variables_ << '\n' << block_sizes_.size() << '\n';
  for (const int size : block_sizes_) out << size << ' ';
  out << '\n';
  for (int v = 0; v < variables_; ++v) out << (v < unknowns_ ? "0 " : "1 ");
  out << '\n';
  std::string line;
  for (const Entry& entry : entries_) {
    const bool constant = entry.variable < 0;
    line = std::to_string(entry.variable + 1) + ' ' + std::to_string(entry.block + 1) + ' ' +
           std::to_string(entry.row + 1) + ' ' + std::to_string(entry.column + 1) + ' ';
    append(line, constant ? -entry.value : entry.value);
    out << line << '\n';
  }
}

Vector SemidefiniteProgram::positions(const std::vector<double>& v) const {
  Vector x(static_cast<Eigen::Index>(unknown_of_dof_.size()));
  for (std::size_t dof = 0; dof < unknown_of_dof_.size(); ++dof) {
    const int unknown = unknown_of_dof_[dof];
    x[static_cast<Eigen::Index>(dof)] =
        unknown < 0 ? held_[dof] : units_.length * v[static_cast<std::size_t>(unknown)];
  }
  return x;
}

}  // namespace isostretch::baselines
