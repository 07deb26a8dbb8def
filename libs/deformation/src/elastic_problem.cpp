#include <isostretch/core/error.hpp>
#include <isostretch/deformation/elastic_problem.hpp>
#include <isostretch/handles/elements.hpp>

#include <algorithm>
#include <cmath>

namespace isostretch::deformation {
namespace {

std::vector<int> selected_elements(const RegionSpec& spec, const SolidModel& body,
                                   const handles::Nodes& nodes) {
  if (spec.select && std::holds_alternative<handles::Group>(*spec.select)) {
    const std::string& name = std::get<handles::Group>(*spec.select).name;
    const auto& group = body.groups[handles::find_group(name, nodes.groups, spec.path + ".select")];
    if (group.elements.empty())
      throw Error(spec.path + ".select: the group '" + name +
                  "' is one of faces, lines or points: no element is in it");
    return group.elements;
  }
  if (spec.select) {
    std::vector<int> chosen =
        handles::elements_within(handles::select(*spec.select, nodes, spec.path + ".select"), body.elements);
    if (chosen.empty()) throw Error(spec.path + ".select: no element has all its vertices in it");
    return chosen;
  }
  if (spec.elements.empty()) throw Error(spec.path + ".elements: the region has no elements");
  const int count = body.elements.element_count();
  for (const int e : spec.elements)
    if (e < 0 || e >= count)
      throw Error(spec.path + ".elements: there is no element " + std::to_string(e) + ", they go from 0 to " +
                  std::to_string(count - 1));
  return spec.elements;
}

// psi'' of stretching one axis of the rest shape.
double stiffness(const energies::AnyEnergy& energy, int dim) {
  constexpr int points = 8;  // the least that every kernel takes
  double sigma[3 * points], psi[points], gradient[3 * points], twist[3 * points], flip[3 * points],
      diagonal[3 * points], coupling[3 * points];
  std::fill(std::begin(sigma), std::end(sigma), 1.0);
  energy.evaluate_derivatives(dim, {points, points, sigma, psi, gradient, twist, flip, diagonal, coupling});
  return diagonal[0];
}

// |P| = |d psi / d sigma| at many points, whose stretches are [point][dim].
std::vector<double> stress_at(const energies::AnyEnergy& energy, int dim,
                              const std::vector<double>& stretches) {
  constexpr std::size_t chunk = 32;
  double sigma[3 * chunk], psi[chunk], gradient[3 * chunk], twist[3 * chunk], flip[3 * chunk],
      diagonal[3 * chunk], coupling[3 * chunk];
  const auto d = static_cast<std::size_t>(dim);
  const std::size_t count = stretches.size() / d;
  std::vector<double> norms(count);
  for (std::size_t start = 0; start < count; start += chunk) {
    const std::size_t here = std::min(chunk, count - start);
    std::fill(std::begin(sigma), std::end(sigma), 1.0);
    for (std::size_t i = 0; i < here; ++i)
      for (std::size_t e = 0; e < d; ++e) sigma[e * chunk + i] = stretches[(start + i) * d + e];
    energy.evaluate_derivatives(dim, {chunk, chunk, sigma, psi, gradient, twist, flip, diagonal, coupling});
    for (std::size_t i = 0; i < here; ++i) {
      double sum = 0;
      for (std::size_t e = 0; e < d; ++e) sum += gradient[e * chunk + i] * gradient[e * chunk + i];
      norms[start + i] = std::isfinite(psi[i]) ? std::sqrt(sum) : HUGE_VAL;
    }
  }
  return norms;
}

}  // namespace

std::vector<Region> regions_of(const SequenceOptions& options, const SolidModel& body) {
  const handles::Nodes nodes = body.selectable();
  std::vector<bool> taken(static_cast<std::size_t>(body.elements.element_count()), false);
  std::vector<Region> regions;
  for (const RegionSpec& spec : options.regions) {
    Region region{spec.name, {}, spec.energy};
    for (const int e : selected_elements(spec, body, nodes))
      if (!taken[static_cast<std::size_t>(e)])
        taken[static_cast<std::size_t>(e)] = true, region.elements.push_back(e);
    if (region.elements.empty()) throw Error(spec.path + ": all its elements are in regions before");
    std::sort(region.elements.begin(), region.elements.end());
    regions.push_back(std::move(region));
  }
  Region rest{regions.empty() ? "all" : "rest", {}, options.energy};
  for (std::size_t e = 0; e < taken.size(); ++e)
    if (!taken[e]) rest.elements.push_back(static_cast<int>(e));
  if (!rest.elements.empty()) regions.push_back(std::move(rest));
  return regions;
}

ElasticProblem::ElasticProblem(const SequenceOptions& options, const SolidModel& body,
                               const HandleSet& handle_set)
    : body_(body),
      handle_set_(handle_set),
      regions_(regions_of(options, body)),
      soft_unit_(stiffness_at_rest() * body.volume() / (body.diagonal() * body.diagonal())),
      objective_(body.dim, static_cast<int>(body.nodes.rows())) {
  for (const Region& region : regions_)
    objective_.add<newton::EnergyTerm>(
        regions_.size() == 1 ? body.elements : handles::restricted(body.elements, region.elements),
        region.energy);
  auto pins = soft_pins(options.script.start);
  if (!pins.empty()) soft_ = &objective_.add<SoftHandles>(body.dim, objective_.node_count(), std::move(pins));
  for (const int node : handle_set.hard_nodes()) objective_.pin(node);
  const std::vector<int> component = handles::component_of_nodes(body.elements);
  for (std::size_t node = 0; node < component.size(); ++node)
    if (component[node] < 0) objective_.pin(static_cast<int>(node));
}

// Averaged by volume.
double ElasticProblem::stiffness_at_rest() const {
  const std::vector<double> volumes = body_.volumes();
  double sum = 0;
  for (const Region& region : regions_) {
    double volume = 0;
    for (const int e : region.elements) volume += volumes[static_cast<std::size_t>(e)];
    sum += volume * stiffness(region.energy, body_.dim);
  }
  return sum / body_.volume();
}

std::vector<newton::SoftPin> ElasticProblem::soft_pins(double time) const {
  std::vector<newton::SoftPin> pins;
  for (const Handle& handle : handle_set_.handles()) {
    if (!handle.soft) continue;
    const double weight = *handle.soft * soft_unit_ / static_cast<double>(handle.nodes.size());
    for (const int node : handle.nodes) {
      const handles::Point target = handle_set_.target(handle, node, time);
      pins.push_back({node, {target.data(), target.data() + body_.dim}, weight});
    }
  }
  return pins;
}

void ElasticProblem::set_time(double time) {
  if (soft_ != nullptr) soft_->move(soft_pins(time));
}

bool ElasticProblem::feasible(const Vector& positions) {
  return std::isfinite(objective_.value(positions).value);
}

double ElasticProblem::soft_energy(const Vector& positions) {
  return soft_ != nullptr ? soft_->value(positions).value : 0;
}

std::vector<double> ElasticProblem::stress_norms(const StrainField& strain) const {
  const auto points = static_cast<std::size_t>(body_.elements.points_per_element);
  const std::size_t per_element = points * static_cast<std::size_t>(body_.dim);
  const std::vector<double> volumes = body_.volumes();
  std::vector<double> result(volumes.size(), 0.0);
  for (const Region& region : regions_) {
    std::vector<double> stretches;
    for (const int e : region.elements) {
      const auto from =
          strain.stretches.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(e) * per_element);
      stretches.insert(stretches.end(), from, from + static_cast<std::ptrdiff_t>(per_element));
    }
    const std::vector<double> norms = stress_at(region.energy, body_.dim, stretches);
    for (std::size_t i = 0; i < norms.size(); ++i) {
      const auto e = static_cast<std::size_t>(region.elements[i / points]);
      result[e] += norms[i] * body_.elements.weights[e * points + i % points] / volumes[e];
    }
  }
  return result;
}

std::vector<double> ElasticProblem::region_numbers() const {
  std::vector<double> numbers(static_cast<std::size_t>(body_.elements.element_count()), 0.0);
  for (std::size_t r = 0; r < regions_.size(); ++r)
    for (const int e : regions_[r].elements) numbers[static_cast<std::size_t>(e)] = static_cast<double>(r);
  return numbers;
}

}  // namespace isostretch::deformation
