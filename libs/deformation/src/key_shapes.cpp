#include <isostretch/core/error.hpp>
#include <isostretch/core/text.hpp>
#include <isostretch/deformation/key_shapes.hpp>

#include <algorithm>
#include <string>
#include <utility>

namespace isostretch::deformation {
namespace {

constexpr const char* demand = "; both poses must have the same vertices and elements in the same order";

void require_same(const std::string& second, const std::string& first, const std::string& has,
                  const std::string& wanted) {
  if (has != wanted) throw Error(second + " has " + has + ", but " + first + " has " + wanted + demand);
}

std::string count_text(long long count, const std::string& what) {
  return with_thousands(count) + " " + what;
}

// -1: none.
int first_different_element(const assembly::Elements& a, const assembly::Elements& b) {
  const auto at = std::mismatch(a.nodes.begin(), a.nodes.end(), b.nodes.begin()).first;
  return at == a.nodes.end() ? -1 : static_cast<int>((at - a.nodes.begin()) / a.nodes_per_element);
}

void require_same_connectivity(const KeyShapes& key_shapes, const std::string& first,
                               const std::string& second) {
  const SolidModel &a = key_shapes.first, &b = key_shapes.second;
  require_same(second, first, plural_name(b.shape), plural_name(a.shape));
  require_same(second, first, count_text(b.nodes.rows(), "vertices"), count_text(a.nodes.rows(), "vertices"));
  require_same(second, first, count_text(b.elements.element_count(), plural_name(b.shape)),
               count_text(a.elements.element_count(), plural_name(a.shape)));
  const int e = first_different_element(a.elements, b.elements);
  if (e >= 0) require_same(second, first, b.element_text(e), a.element_text(e));
}

// Frames lie in the plane of the first key shape.
void require_same_plane(const KeyShapes& key_shapes, const std::string& first, const std::string& second) {
  const Plane a = key_shapes.first.plane.value_or(Plane()), b = key_shapes.second.plane.value_or(Plane());
  const double tolerance = 1e-6, distance = tolerance * key_shapes.first.diagonal();
  if ((a.u - b.u).norm() > tolerance || (a.v - b.v).norm() > tolerance ||
      (a.origin - b.origin).norm() > distance)
    throw Error(second + " lies in another plane than " + first);
}

}  // namespace

void require_pair(const KeyShapes& key_shapes, const std::string& first, const std::string& second) {
  require_same_connectivity(key_shapes, first, second);
  require_same_plane(key_shapes, first, second);
}

KeyShapes read_key_shapes(const std::filesystem::path& first, const std::filesystem::path& second,
                          const MeshRepair& repair) {
  SolidSpec a, b;
  a.repair = b.repair = repair;
  a.file = first;
  b.file = second;
  KeyShapes key_shapes{load_solid(a), load_solid(b)};
  require_pair(key_shapes, first.string(), second.string());
  return key_shapes;
}

}  // namespace isostretch::deformation
