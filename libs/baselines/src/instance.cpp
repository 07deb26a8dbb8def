#include <isostretch/assembly/deformation_operator.hpp>
#include <isostretch/baselines/instance.hpp>
#include <isostretch/core/error.hpp>

#include <string>

namespace isostretch::baselines {

void Instance::validate() const {
  problem.validate();
  if (rest.size() != dim() * problem.node_count())
    throw Error("instance: rest has " + std::to_string(rest.size()) + " entries, must have " +
                std::to_string(dim() * problem.node_count()));
  if (!rest.allFinite()) throw Error("instance: a position at rest is not finite");
  const std::vector<double> det = assembly::determinants(problem.elements, rest.data());
  for (std::size_t e = 0; e < det.size(); ++e)
    if (!(det[e] > 0)) throw Error("instance: element " + std::to_string(e) + " is inverted or flat at rest");
}

}  // namespace isostretch::baselines
