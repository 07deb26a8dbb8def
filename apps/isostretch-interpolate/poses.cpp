#include "poses.hpp"

#include "common/formatted.hpp"

#include <isostretch/core/error.hpp>

#include <algorithm>
#include <string>
#include <utility>

namespace isostretch::app::interpolate {
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

void require_same_connectivity(const Poses& poses, const std::string& first, const std::string& second) {
  const Body &a = poses.first, &b = poses.second;
  require_same(second, first, plural_name(b.shape), plural_name(a.shape));
  require_same(second, first, count_text(b.nodes.rows(), "vertices"), count_text(a.nodes.rows(), "vertices"));
  require_same(second, first, count_text(b.elements.element_count(), plural_name(b.shape)),
               count_text(a.elements.element_count(), plural_name(a.shape)));
  const int e = first_different_element(a.elements, b.elements);
  if (e >= 0) require_same(second, first, b.element_text(e), a.element_text(e));
}

}  // namespace

Poses read_poses(const std::filesystem::path& first, const std::filesystem::path& second) {
  BodySpec a, b;
  a.file = first;
  b.file = second;
  Poses poses{load_body(a), load_body(b)};
  require_same_connectivity(poses, first.string(), second.string());
  return poses;
}

}  // namespace isostretch::app::interpolate
