#include "constrained_program.hpp"

#include <isostretch/core/index.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <tuple>

namespace isostretch::baselines {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

ConstrainedProgram::ConstrainedProgram(const Instance& instance, const Objective& objective,
                                       const ConstraintFunctions& constraints, Recorder& recorder)
    : instance_(instance),
      objective_(objective),
      constraints_(constraints),
      recorder_(recorder),
      unknowns_(at(constraints.unknowns())),
      first_point_(recorder.points()) {}

void ConstrainedProgram::look_for_shift(double enough, double most) {
  enough_shift_ = enough;
  most_shift_ = most;
}

int ConstrainedProgram::position_count() const {
  return constraints_.unknowns() - constraints_.with_shift();
}

Vector ConstrainedProgram::positions_of(std::span<const double> x) const {
  return Eigen::Map<const Vector>(x.data(), position_count());
}

Vector ConstrainedProgram::positions() const {
  return positions_of(unknowns_);
}

NonlinearProgram::Sizes ConstrainedProgram::sizes() const {
  const int columns = constraints_.columns(), elements = instance_.problem.element_count();
  return {constraints_.unknowns(), constraints_.count(), constraints_.count() * columns,
          elements * (columns * (columns + 1) / 2) + position_count()};
}

void ConstrainedProgram::bounds(std::span<double> lower, std::span<double> upper) const {
  std::fill(lower.begin(), lower.end(), -infinity);
  std::fill(upper.begin(), upper.end(), infinity);
  if (constraints_.with_shift()) upper.back() = most_shift_;
  const int dim = instance_.dim();
  for (const sdp_penalty::Target& target : instance_.problem.targets)
    for (int r = 0; target.hard && r < dim; ++r) {
      const std::size_t dof = at(target.node * dim + r);
      lower[dof] = upper[dof] = target.position[at(r)];
    }
}

void ConstrainedProgram::start(std::span<double> x) const {
  std::copy(unknowns_.begin(), unknowns_.end(), x.begin());
}

double ConstrainedProgram::value(std::span<const double> x) const {
  const double value = objective_.value(positions_of(x));
  return constraints_.with_shift() ? value - x.back() : value;
}

void ConstrainedProgram::gradient(std::span<const double> x, std::span<double> g) const {
  objective_.gradient(positions_of(x), g.first(at(position_count())));
  if (constraints_.with_shift()) g.back() = -1;
}

void ConstrainedProgram::constraints(std::span<const double> x, std::span<double> c) const {
  constraints_.values(x, c);
}

void ConstrainedProgram::jacobian_structure(std::span<int> rows, std::span<int> columns) const {
  std::size_t place = 0;
  for (int row = 0; row < constraints_.count(); ++row)
    for (int column = 0; column < constraints_.columns(); ++column, ++place) {
      rows[place] = row;
      columns[place] = constraints_.unknown(row / constraints_.per_element(), column);
    }
}

void ConstrainedProgram::jacobian(std::span<const double> x, std::span<double> values) const {
  constraints_.jacobian(x, values);
}

// The lower triangle of every element's block, then the diagonal.
void ConstrainedProgram::hessian_structure(std::span<int> rows, std::span<int> columns) const {
  std::size_t place = 0;
  for (int e = 0; e < instance_.problem.element_count(); ++e)
    for (int i = 0; i < constraints_.columns(); ++i)
      for (int j = 0; j <= i; ++j, ++place)
        std::tie(columns[place], rows[place]) =
            std::minmax({constraints_.unknown(e, i), constraints_.unknown(e, j)});
  for (int dof = 0; dof < position_count(); ++dof, ++place) rows[place] = columns[place] = dof;
}

void ConstrainedProgram::hessian(std::span<const double> x, double factor,
                                 std::span<const double> multipliers, std::span<double> values) const {
  const int size = constraints_.columns();
  const std::size_t per_element = at(constraints_.per_element());
  std::vector<double> block(at(size * size));
  std::size_t place = 0;
  for (int e = 0; e < instance_.problem.element_count(); ++e) {
    std::fill(block.begin(), block.end(), 0.0);
    objective_.add_hessian(e, factor, block, size);
    constraints_.add_hessian(e, x, multipliers.subspan(at(e) * per_element, per_element), block);
    for (int i = 0; i < size; ++i)
      for (int j = 0; j <= i; ++j) values[place++] = block[at(i * size + j)];
  }
  for (int dof = 0; dof < position_count(); ++dof)
    values[place++] = factor * objective_.hessian_diagonal(dof);
}

bool ConstrainedProgram::take_iterate(int iteration, std::span<const double> x) {
  last_iteration_ = iteration;
  if (x.empty()) return recorder_.may_go_on();
  std::copy(x.begin(), x.end(), unknowns_.begin());
  return recorder_.record(positions(), first_point_ + iteration) && !has_enough();
}

void ConstrainedProgram::finish(std::span<const double> x) {
  std::copy(x.begin(), x.end(), unknowns_.begin());
}

}  // namespace isostretch::baselines
