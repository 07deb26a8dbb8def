#include <isostretch/figures/handle_preview.hpp>

#include <isostretch/core/text.hpp>
#include <isostretch/figures/handle_figure.hpp>
#include <isostretch/figures/solid_figure.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace isostretch::figures {
namespace {

using deformation::Handle;
using deformation::SolidModel;
using Preview = HandlePreview;

// What is said of a handle.
struct Facts {
  Eigen::Vector3d from = Eigen::Vector3d::Zero(), to = from;  // means
  double farthest = 0;
  double degrees = 0;
};

Eigen::Vector3d at_rest(const Preview& p, int node) {
  return p.body.nodes.row(node);
}

Eigen::Vector3d at_time(const Preview& p, const Handle& handle, int node) {
  return p.handle_set.target(handle, node, p.time);
}

Facts facts_of(const Preview& p, const Handle& handle) {
  Facts facts;
  const auto count = static_cast<double>(handle.nodes.size());
  for (const int node : handle.nodes) {
    const Eigen::Vector3d from = at_rest(p, node), to = at_time(p, handle, node);
    facts.from += from / count;
    facts.to += to / count;
    facts.farthest = std::max(facts.farthest, (to - from).norm());
  }
  facts.degrees = handle.motion.axis_angle(p.time).degrees;
  return facts;
}

bool moves(const Preview& p, const Facts& facts) {
  return facts.farthest > 1e-9 * p.body.diagonal();
}

// ---- the table ----

std::string point_text(const Eigen::Vector3d& point, int dim) {
  // Round-off is no coordinate, and there is no minus zero.
  const auto text = [](double x) { return formatted("%.4g", std::abs(x) < 1e-12 ? 0.0 : x); };
  std::string result = "(";
  for (int i = 0; i < dim; ++i) result.append(i > 0 ? ", " : "").append(text(point[i]));
  return result + ")";
}

std::string kind_text(const Handle& handle) {
  return handle.soft ? *handle.soft == 1 ? "soft" : formatted("soft %g", *handle.soft) : "hard";
}

using Row = std::array<std::string, 7>;

// Of UTF-8, which has bytes more where letters are not ASCII.
std::size_t letters(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

Row row_of(const Preview& p, const Handle& handle) {
  const Facts facts = facts_of(p, handle);
  const bool goes = moves(p, facts);
  return {handle.name,
          kind_text(handle),
          with_thousands(std::ssize(handle.nodes)),
          point_text(facts.from, p.body.dim),
          goes ? point_text(facts.to, p.body.dim) : "stays",
          goes ? formatted("%.4g", facts.farthest) : "-",
          facts.degrees != 0 ? formatted("%g deg", facts.degrees) : "-"};
}

// ---- the picture ----

// The handle of every node, or -1.
std::vector<int> owners(const Preview& p) {
  std::vector<int> owner(static_cast<std::size_t>(p.body.nodes.rows()), -1);
  for (std::size_t h = 0; h < p.handle_set.handles().size(); ++h)
    for (const int node : p.handle_set.handles()[h].nodes)
      owner[static_cast<std::size_t>(node)] = static_cast<int>(h);
  return owner;
}

std::vector<Color> triangle_colors(const Preview& p) {
  constexpr Color bare{0.87, 0.87, 0.85};
  const std::vector<int> owner = owners(p);
  const auto& surface = p.body.surface;
  const auto owner_of = [&](int vertex) {
    return owner[static_cast<std::size_t>(surface.original_vertex[static_cast<std::size_t>(vertex)])];
  };
  std::vector<Color> colors;
  for (Eigen::Index t = 0; t < surface.mesh.triangles.rows(); ++t) {
    const int a = owner_of(surface.mesh.triangles(t, 0));
    const bool whole =
        a >= 0 && owner_of(surface.mesh.triangles(t, 1)) == a && owner_of(surface.mesh.triangles(t, 2)) == a;
    colors.push_back(whole ? handle_color(static_cast<std::size_t>(a)) : bare);
  }
  return colors;
}

std::vector<int> spread(const std::vector<int>& nodes, std::size_t most) {
  const std::size_t step = std::max<std::size_t>(1, (nodes.size() + most - 1) / most);
  std::vector<int> result;
  for (std::size_t i = 0; i < nodes.size(); i += step) result.push_back(nodes[i]);
  return result;
}

std::vector<bool> nodes_on_surface(const SolidModel& body) {
  std::vector<bool> on_surface(static_cast<std::size_t>(body.nodes.rows()), false);
  for (const int node : body.surface.original_vertex) on_surface[static_cast<std::size_t>(node)] = true;
  return on_surface;
}

std::vector<int> seen_nodes(const Handle& handle, const std::vector<bool>& on_surface) {
  std::vector<int> seen;
  for (const int node : handle.nodes)
    if (on_surface[static_cast<std::size_t>(node)]) seen.push_back(node);
  return seen;
}

HandleLegend legend_of(const Preview& p, const Handle& handle, bool inside) {
  const Facts facts = facts_of(p, handle);
  std::string text = kind_text(handle) + ", " + with_thousands(std::ssize(handle.nodes)) +
                     (handle.nodes.size() == 1 ? " node" : " nodes") + (inside ? " inside" : "");
  if (!moves(p, facts)) return {handle.name, text + ", stays"};
  if (facts.degrees != 0) text += formatted(", turns %g°", facts.degrees);
  return {handle.name, text + formatted(", goes %.2g", facts.farthest)};
}

Color darker(Color color) {
  return {0.55 * color.r, 0.55 * color.g, 0.55 * color.b};
}

std::vector<Marker> markers_of(const Preview& p) {
  constexpr std::size_t most_dots = 200, most_arrows = 8;
  const std::vector<bool> on_surface = nodes_on_surface(p.body);
  std::vector<Marker> dots, arrows;
  for (std::size_t h = 0; h < p.handle_set.handles().size(); ++h) {
    const Handle& handle = p.handle_set.handles()[h];
    const Color color = darker(handle_color(h));
    const std::vector<int> seen = seen_nodes(handle, on_surface), &nodes = seen.empty() ? handle.nodes : seen;
    const bool alone = handle.nodes.size() == 1;  // what shows its colour then is the dot
    for (const int node : spread(nodes, most_dots)) {
      const Eigen::RowVector3d at = at_rest(p, node).transpose();
      dots.push_back({Marker::Kind::dot, at, at, alone ? handle_color(h) : color, alone ? 7.0 : 3.0, true});
    }
    if (!moves(p, facts_of(p, handle))) continue;
    for (const int node : spread(nodes, most_arrows))
      arrows.push_back(
          {Marker::Kind::arrow, at_rest(p, node).transpose(), at_time(p, handle, node).transpose(), color});
  }
  dots.insert(dots.end(), arrows.begin(), arrows.end());
  return dots;
}

}  // namespace

std::string preview_table(const HandlePreview& preview) {
  std::vector<Row> rows{{"handle", "kind", "nodes", "centre", "goes to", "farthest", "turns"}};
  for (const Handle& handle : preview.handle_set.handles()) rows.push_back(row_of(preview, handle));
  std::array<std::size_t, 7> widths{};
  for (const Row& row : rows)
    for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], letters(row[c]));
  std::string text;
  for (const Row& row : rows) {
    std::string line;
    for (std::size_t c = 0; c < row.size(); ++c)
      line += row[c] + std::string(c + 1 < row.size() ? widths[c] + 2 - letters(row[c]) : 0, ' ');
    text += line + "\n";
  }
  return text;
}

std::string draw_preview(const HandlePreview& p) {
  const SolidModel& body = p.body;
  const std::vector<double> unchanged(static_cast<std::size_t>(body.elements.element_count()), 1.0);
  HandleFigure figure{
      {.title = body.name + ": handles",
       .subtitle = with_thousands(body.elements.element_count()) + " " +
                   deformation::plural_name(body.shape) +
                   "   ·   at rest   ·   arrows: to where nodes are to be at the end   ·   rings: behind or "
                   "inside the body",
       .states = {{"", surface_points(body, body.nodes), unchanged, {}, markers_of(p), triangle_colors(p)}},
       .triangles = body.surface.mesh.triangles,
       .element = body.surface.element,
       .volumes = body.volumes(),
       .lines = figure_lines(p.handle_set, body),
       .flat = body.dim == 2,
       .up = p.up},
      {}};
  const std::vector<bool> on_surface = nodes_on_surface(body);
  for (const Handle& handle : p.handle_set.handles())
    figure.legend.push_back(legend_of(p, handle, seen_nodes(handle, on_surface).empty()));
  return draw_handles(figure);
}

}  // namespace isostretch::figures
