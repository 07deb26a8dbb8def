#pragma once

#include "common/body.hpp"
#include "common/figures/deformation_figure.hpp"
#include "common/strain.hpp"

#include <array>
#include <string>
#include <vector>

namespace isostretch::app {

/// The frames of a sequence as they are made, to be looked through in a report and to be played elsewhere.
class Animation {
 public:
  /// `lines` and `up` as in DeformationFigure. The body must live longer.
  Animation(const Body& body, std::vector<std::array<int, 2>> lines, int up = -1);

  void add(int number, double time, const Vector& positions, const StrainField& strain);
  bool empty() const { return states_.empty(); }

  /// Returns the surface with every frame as a morph target, four frames a second, as the bytes of a GLB
  /// file.
  std::string glb() const;

  /// Returns a part of a page that plays the frames and lets a reader go through them. It needs nothing from
  /// outside of the page. Of more than `most_shown` frames as many are drawn, evenly spread, first and last
  /// among them, and the caption says so.
  std::string preview() const;

  static constexpr std::size_t most_shown = 25;

 private:
  std::vector<std::size_t> shown() const;

  const Body& body_;
  std::vector<std::array<int, 2>> lines_;
  int up_;
  std::vector<int> numbers_;
  std::vector<figures::DeformedState> states_;
};

}  // namespace isostretch::app
