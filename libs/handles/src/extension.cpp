#include "stiffness.hpp"

#include <isostretch/assembly/operators.hpp>
#include <isostretch/core/error.hpp>
#include <isostretch/handles/elements.hpp>
#include <isostretch/handles/extension.hpp>
#include <isostretch/sparse/solver.hpp>

#include <algorithm>

namespace isostretch::handles {
namespace {

enum class Role { free, given, left };

// What holds a component: nodes of one without a given node, and of none, are left alone.
std::vector<Role> roles_of(const assembly::Elements& elements, const std::vector<int>& given) {
  const std::vector<int> component = component_of_nodes(elements);
  std::vector<bool> held(component.size(), false);
  for (const int node : given) {
    if (node < 0 || node >= elements.node_count)
      throw Error("spread: there is no node " + std::to_string(node) + ", there are " +
                  std::to_string(elements.node_count));
    const int c = component[static_cast<std::size_t>(node)];
    if (c >= 0) held[static_cast<std::size_t>(c)] = true;
  }
  std::vector<Role> roles(component.size(), Role::left);
  for (std::size_t n = 0; n < roles.size(); ++n)
    if (component[n] >= 0 && held[static_cast<std::size_t>(component[n])]) roles[n] = Role::free;
  for (const int node : given) roles[static_cast<std::size_t>(node)] = Role::given;
  return roles;
}

}  // namespace

struct Extension::System {
  int dim = 0;
  std::vector<Role> roles;
  std::vector<int> unknown;  // of every node, -1 where it is not free
  std::vector<int> node;     // of every unknown
  Rows operator_rows;        // K or K M^-1 K
  std::unique_ptr<sparse::Solver> solver;

  void number() {
    unknown.assign(roles.size(), -1);
    for (std::size_t n = 0; n < roles.size(); ++n) {
      if (roles[n] != Role::free) continue;
      unknown[n] = static_cast<int>(node.size());
      node.push_back(static_cast<int>(n));
    }
  }

  sparse::SymmetricMatrix free_part() const {
    sparse::SymmetricMatrix A;
    A.size = static_cast<int>(node.size());
    A.column_start.push_back(0);
    for (int j = 0; j < A.size; ++j) {
      for (const Entry& entry : operator_rows[static_cast<std::size_t>(node[static_cast<std::size_t>(j)])]) {
        const int i = unknown[static_cast<std::size_t>(entry.column)];
        if (i < j) continue;
        A.row.push_back(i);
        A.value.push_back(entry.value);
      }
      A.column_start.push_back(A.nonzeros());
    }
    return A;
  }

  void factorize(const sparse::Options& options) {
    if (node.empty()) return;
    solver = sparse::make_solver(options);
    // The solver would take a biharmonic system in the plane, by its density, for one in space. Where nodes
    // are does not matter to a system with one unknown a node.
    const std::vector<double> anywhere(node.size() * static_cast<std::size_t>(dim), 0.0);
    solver->set_coordinates(anywhere.data(), dim, static_cast<int>(node.size()));
    const sparse::SymmetricMatrix A = free_part();
    solver->analyze(A);
    const sparse::FactorResult result = solver->factorize(A);
    if (!result) throw Error("spread: the system cannot be factorised: " + result.message);
  }
};

sparse::Options factorizing() {
  sparse::Options options;
  options.automatic_max_flops = 1e18;
  return options;
}

Extension::Extension(const assembly::Elements& elements, const std::vector<int>& given, ExtensionKind kind,
                     const sparse::Options& solver)
    : system_(std::make_unique<System>()) {
  elements.validate();
  system_->dim = elements.dim;
  system_->roles = roles_of(elements, given);
  system_->number();
  const Rows stiffness = stiffness_rows(elements);
  system_->operator_rows = kind == ExtensionKind::harmonic
                               ? stiffness
                               : squared(stiffness, assembly::operators::lumped_mass(elements));
  system_->factorize(solver);
}

Extension::~Extension() = default;
Extension::Extension(Extension&&) noexcept = default;
Extension& Extension::operator=(Extension&&) noexcept = default;

Vector Extension::extend(const Vector& displacement) const {
  const System& s = *system_;
  if (displacement.size() != static_cast<Eigen::Index>(s.roles.size()) * s.dim)
    throw Error("spread: " + std::to_string(displacement.size()) + " displacements for " +
                std::to_string(s.roles.size()) + " nodes in " + std::to_string(s.dim) + "D");
  Vector result = Vector::Zero(displacement.size());
  for (std::size_t n = 0; n < s.roles.size(); ++n)
    if (s.roles[n] == Role::given) {
      const auto start = static_cast<Eigen::Index>(n) * s.dim;
      result.segment(start, s.dim) = displacement.segment(start, s.dim);
    }
  const auto unknowns = s.node.size();
  if (unknowns == 0) return result;
  std::vector<double> right(unknowns * static_cast<std::size_t>(s.dim)), solution(right.size());
  for (int axis = 0; axis < s.dim; ++axis)
    for (std::size_t i = 0; i < unknowns; ++i) {
      double sum = 0;  // `result` is zero at what is free
      for (const Entry& entry : s.operator_rows[static_cast<std::size_t>(s.node[i])])
        sum -= entry.value * result[entry.column * s.dim + axis];
      right[static_cast<std::size_t>(axis) * unknowns + i] = sum;
    }
  const sparse::SolveResult outcome = s.solver->solve_columns(right.data(), solution.data(), s.dim);
  if (!outcome) throw Error("spread: the system cannot be solved: " + outcome.message);
  for (int axis = 0; axis < s.dim; ++axis)
    for (std::size_t i = 0; i < unknowns; ++i)
      result[s.node[i] * s.dim + axis] = solution[static_cast<std::size_t>(axis) * unknowns + i];
  return result;
}

}  // namespace isostretch::handles
