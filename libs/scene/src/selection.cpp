#include <isostretch/scene/selection.hpp>

#include "definitions.hpp"

#include <isostretch/core/text.hpp>

#include <limits>

namespace isostretch::scene {
namespace {

constexpr ChoiceNames<int, 3> axis_names{{{"x", 0}, {"y", 1}, {"z", 2}}};
constexpr ChoiceNames<handles::End, 2> end_names{{{"min", handles::End::min}, {"max", handles::End::max}}};

handles::Box read_box(const Node& value, int dim) {
  value.only(keys_of("box"));
  return {value.at("min").point(dim), value.at("max").point(dim)};
}

handles::Sphere read_sphere(const Node& value, int dim) {
  value.only(keys_of("sphere"));
  return {value.at("center").point(dim), value.at("radius").positive()};
}

handles::Slab read_slab(const Node& value, int dim) {
  value.only(keys_of("slab"));
  if (value.has("fraction") == value.has("width")) value.fail("give either fraction or width");
  const Node axis = value.at("axis");
  const int number = axis.choice(axis_names);
  if (number >= dim) axis.fail("there is no z in the plane");
  const bool relative = value.has("fraction");
  return {number, value.at("end").choice(end_names), value.at(relative ? "fraction" : "width").positive(),
          relative};
}

handles::Segment read_segment(const Node& value, int dim) {
  value.only(keys_of("segment"));
  return {value.at("from").point(dim), value.at("to").point(dim), value.at("distance").positive()};
}

handles::Nearest read_nearest(const Node& value, int dim) {
  value.only(keys_of("nearest"));
  const auto count = value.find("count");
  return {value.at("point").point(dim), count ? count->whole(1, std::numeric_limits<int>::max()) : 1};
}

handles::Patch read_patch(const Node& value, int dim) {
  value.only(keys_of("patch"));
  return {value.at("point").point(dim), value.at("distance").positive()};
}

}  // namespace

handles::Selection read_selection(const Node& value, int dim) {
  if (value.value().is_text()) {
    value.require_one_of({"all"});
    return handles::All{};
  }
  const std::vector<std::string> kinds = keys_of("selection");
  if (value.only(kinds).value().size() != 1) value.fail("must have one of the keys " + listed(kinds));
  if (const auto box = value.find("box")) return read_box(*box, dim);
  if (const auto sphere = value.find("sphere")) return read_sphere(*sphere, dim);
  if (const auto segment = value.find("segment")) return read_segment(*segment, dim);
  if (const auto slab = value.find("slab")) return read_slab(*slab, dim);
  if (const auto nearest = value.find("nearest")) return read_nearest(*nearest, dim);
  if (const auto patch = value.find("patch")) return read_patch(*patch, dim);
  if (const auto group = value.find("group"))
    return handles::Group{
        group->value().is_text()
            ? group->text()
            : std::to_string(group->whole(std::numeric_limits<int>::min(), std::numeric_limits<int>::max()))};
  return handles::List{value.at("vertices").whole_numbers()};
}

}  // namespace isostretch::scene
