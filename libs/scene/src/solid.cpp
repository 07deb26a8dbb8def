#include <isostretch/scene/solid.hpp>

#include "definitions.hpp"

#include <isostretch/core/text.hpp>

#include <limits>

namespace isostretch::scene {
namespace {

using namespace deformation;

constexpr int most = std::numeric_limits<int>::max();
constexpr ChoiceNames<bool, 2> split_names{{{"crossed", true}, {"two", false}}};

BarSpec read_bar(const Node& value) {
  value.only(keys_of("bar"));
  BarSpec bar;
  for (const Node& item : value.at("cells").items()) bar.cells.push_back(item.whole(1, most));
  if (bar.cells.size() != 2 && bar.cells.size() != 3)
    value.at("cells").fail("must be 2 or 3 numbers, not " + std::to_string(bar.cells.size()));
  bar.size.assign(bar.cells.size(), 1.0);
  if (const auto size = value.find("size")) {
    const auto items = size->items();
    if (items.size() != bar.cells.size())
      size->fail("must be as many numbers as cells, " + std::to_string(bar.cells.size()));
    for (std::size_t i = 0; i < items.size(); ++i) bar.size[i] = items[i].positive();
  }
  bar.shape = bar.cells.size() == 2 ? mesh::Shape::triangle : mesh::Shape::tet;
  if (const auto element = value.find("element")) {
    element->require_one_of(shape_names());
    bar.shape = shape_from_name(element->text());
    if (mesh::shape_dim(bar.shape) != static_cast<int>(bar.cells.size()))
      element->fail("'" + element->text() + "' is " + std::to_string(mesh::shape_dim(bar.shape)) +
                    "D, and there are cells in " + std::to_string(bar.cells.size()) + " directions");
  }
  return bar;
}

GridSpec read_grid(const Node& value) {
  value.only(keys_of("grid"));
  GridSpec grid;
  const auto cells = value.at("cells").items();
  if (cells.size() != 2) value.at("cells").fail("must be 2 numbers, not " + std::to_string(cells.size()));
  for (std::size_t i = 0; i < 2; ++i) grid.cells[i] = cells[i].whole(1, most);
  if (const auto size = value.find("size")) {
    const auto items = size->items();
    if (items.size() != 2) size->fail("must be 2 numbers, not " + std::to_string(items.size()));
    for (std::size_t i = 0; i < 2; ++i) grid.size[i] = items[i].positive();
  }
  if (const auto split = value.find("split")) grid.crossed = split->choice(split_names);
  return grid;
}

int read_count(const Node& value, const char* key) {
  return value.only({key}).at(key).whole(1, most);
}

GeneratedSolid read_generated(const Node& mesh) {
  std::vector<std::string> kinds = keys_of("generated");
  std::erase(kinds, "photo_grid");  // which whoever knows the photo reads
  if (mesh.only(kinds).value().size() != 1) mesh.fail("must have one of the keys " + listed(kinds));
  if (const auto bar = mesh.find("bar")) return read_bar(*bar);
  if (const auto grid = mesh.find("grid")) return read_grid(*grid);
  if (const auto disc = mesh.find("disc")) return DiscSpec{read_count(*disc, "rings")};
  if (const auto ball = mesh.find("ball")) return BallSpec{read_count(*ball, "cells")};
  return QuadrupedSpec{read_count(mesh.at("quadruped"), "cells")};
}

}  // namespace

SolidSpec read_solid(const Node& scene, const std::filesystem::path& folder) {
  SolidSpec spec;
  const Node mesh = scene.at("mesh");
  if (mesh.value().is_text())
    spec.file = folder / mesh.text();
  else
    spec.generated = read_generated(mesh);
  if (const auto order = scene.find("order")) spec.order = order->whole(1, 2);
  if (const auto quadrature = scene.find("quadrature")) spec.quadrature = quadrature->whole(1, 5);
  return spec;
}

}  // namespace isostretch::scene
