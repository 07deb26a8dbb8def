#include <isostretch/core/error.hpp>
#include <isostretch/parameterization/options.hpp>

#include <string>

namespace isostretch::parameterization {
namespace {

void require(bool condition, const char* option, const std::string& text) {
  if (!condition) throw OptionError(option, text);
}

void validate_corners(const Options& o) {
  if (o.corners.empty()) return;
  require(o.boundary == Boundary::square, "corners", "only with boundary square");
  require(o.corners.size() == 4, "corners",
          std::to_string(o.corners.size()) + " vertices given, a square has four");
}

void validate_overlap(const Options& o) {
  if (o.overlap != OverlapRule::split) return;
  require(o.cut, "overlap", "split cuts, and the surface may not be cut");
  require(o.pack != Pack::none, "overlap", "split: parts of a chart come apart only when they are packed");
  require(!o.has_pins() && o.aligned.empty(), "overlap",
          "split packs the parts of charts, which moves vertices that are pinned or aligned");
}

void validate_distortion(const Options& o) {
  if (o.max_distortion == 0) return;
  require(o.max_distortion > 1, "max_distortion", "must be a factor above 1, or 0 for none");
  require(o.initial != Initial::input && o.cut, "max_distortion",
          "cuts, and the surface may not be cut, or is laid out already (initial input)");
  require(!o.has_pins() && o.aligned.empty(), "max_distortion",
          "cuts, and may double vertices that are pinned or aligned");
  require(o.boundary == Boundary::free, "max_distortion", "cuts, and needs boundary free");
}

}  // namespace

void Options::validate() const {
  check_ranges(*this);
  validate_corners(*this);
  const bool shaped = boundary == Boundary::circle || boundary == Boundary::square;
  require(!shaped || initial != Initial::input, "boundary",
          "circle, square: the start puts the boundary there, which initial input does not");
  require(uv_units != UvUnits::square || !has_pins(), "uv_units",
          "square: where pins are is given in units of the model, or of total area 1");
  for (const AlignedVertices& line : aligned)
    require(line.vertices.size() >= 2, line.horizontal ? "horizontal" : "vertical",
            "names less than two vertices");
  validate_overlap(*this);
  validate_distortion(*this);
}

bool Options::packs(std::size_t charts) const {
  if (pack != Pack::automatic) return pack == Pack::square;
  if (overlap == OverlapRule::split) return true;
  return initial != Initial::input && (charts > 1 || !has_pins());
}

bool Options::splits_overlap(std::size_t charts) const {
  if (overlap != OverlapRule::automatic) return overlap == OverlapRule::split;
  return cut && aligned.empty() && packs(charts);
}

bool Options::reaches_tips() const {
  return cut && cut_tips > 2 && initial == Initial::tutte && boundary == Boundary::free && !has_pins() &&
         aligned.empty();
}

UvUnits Options::units() const {
  if (uv_units != UvUnits::automatic) return uv_units;
  const bool places = has_pins() || (initial == Initial::input && boundary == Boundary::fixed);
  return places ? UvUnits::model : UvUnits::square;
}

}  // namespace isostretch::parameterization
