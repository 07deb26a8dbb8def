#include "poses.hpp"

#include "common/body_check.hpp"
#include "common/terminal.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/core/text.hpp>

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

// Frames lie in the plane of the first pose.
void require_same_plane(const Poses& poses, const std::string& first, const std::string& second) {
  const Plane a = poses.first.plane.value_or(Plane()), b = poses.second.plane.value_or(Plane());
  const double tolerance = 1e-6, distance = tolerance * poses.first.diagonal();
  if ((a.u - b.u).norm() > tolerance || (a.v - b.v).norm() > tolerance ||
      (a.origin - b.origin).norm() > distance)
    throw Error(second + " lies in another plane than " + first);
}

void require_pair(const Poses& poses, const std::string& first, const std::string& second) {
  require_same_connectivity(poses, first, second);
  require_same_plane(poses, first, second);
}

}  // namespace

Poses read_poses(const std::filesystem::path& first, const std::filesystem::path& second,
                 const MeshRepair& repair) {
  BodySpec a, b;
  a.repair = b.repair = repair;
  a.file = first;
  b.file = second;
  Poses poses{load_body(a), load_body(b)};
  require_pair(poses, first.string(), second.string());
  return poses;
}

ExitCode check_poses(const std::filesystem::path& first, const std::filesystem::path& second,
                     const MeshRepair& repair) {
  return with_error_kind(ErrorKind::input, [&] {
    BodySpec spec;
    spec.repair = repair;
    spec.file = first;
    BodyCheck a = check_body(spec);
    spec.file = second;
    BodyCheck b = check_body(spec);
    const ExitCode codes[] = {print_check(a), print_check(b)};
    if (codes[0] != ExitCode::success || codes[1] != ExitCode::success) return ExitCode::input;
    try {
      require_pair({std::move(*a.body), std::move(*b.body)}, first.string(), second.string());
    } catch (const Error& error) {
      print(std::string("The poses do not belong together: ") + error.what() + "\n");
      return ExitCode::input;
    }
    print("The poses belong together.\n");
    return ExitCode::success;
  });
}

}  // namespace isostretch::app::interpolate
