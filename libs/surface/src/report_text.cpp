#include <isostretch/surface/check.hpp>

#include <algorithm>
#include <charconv>
#include <string>

namespace isostretch::mesh {
namespace {

constexpr std::size_t components_listed = 20;

std::string plural(long count, const char* what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

std::string number(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value, std::chars_format::general, 6).ptr};
}

std::string line(const ComponentFacts& facts) {
  return "  from triangle " + std::to_string(facts.first_triangle) + ": " +
         plural(facts.triangles, "triangle") + ", area " + number(facts.area) + ", " +
         plural(facts.boundary_loops, "boundary loop") + ", Euler characteristic " +
         std::to_string(facts.euler_characteristic) + ", " +
         (facts.genus >= 0 ? "genus " + std::to_string(facts.genus) : "no genus: " + facts.why_no_genus) +
         "\n";
}

std::string component_lines(const MeshDiagnostics& report) {
  std::string text;
  const auto& all = report.component_facts;
  for (std::size_t i = 0; i < std::min(all.size(), components_listed); ++i) text += line(all[i]);
  if (all.size() > components_listed)
    text += "  and " + plural(static_cast<long>(all.size() - components_listed), "component") + " more\n";
  return text;
}

std::string defect_lines(const MeshDiagnostics& report, DefectKind kind) {
  const long count = report.count(kind);
  if (count == 0) return {};
  std::string text = std::string(defect_kind_name(kind)) + ": " + std::to_string(count) + "\n";
  long listed = 0;
  for (const Defect& defect : report.defects)
    if (defect.kind == kind) {
      text += "  " + defect.text + "\n";
      ++listed;
    }
  if (listed < count) text += "  and " + std::to_string(count - listed) + " more\n";
  return text;
}

}  // namespace

std::string to_text(const MeshDiagnostics& report) {
  std::string text;
  if (report.indices_valid) text += plural(report.components, "component") + "\n" + component_lines(report);
  for (int kind = 0; kind < defect_kind_count; ++kind)
    text += defect_lines(report, static_cast<DefectKind>(kind));
  if (report.defects.empty()) text += "nothing wrong found\n";
  return text;
}

}  // namespace isostretch::mesh
