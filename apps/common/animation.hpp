#pragma once

#include "common/deformation_names.hpp"

#include "common/output_folder.hpp"

#include <isostretch/figures/deformation_figure.hpp>

#include <array>
#include <string>
#include <vector>

namespace isostretch::app {

/// The frames of a sequence as they are made, to be looked through in a report and to be played elsewhere.
class Animation {
 public:
  /// `lines` and `up` as in DeformationFigure. The body must live longer.
  Animation(const SolidModel& body, std::vector<std::array<int, 2>> lines, int up = -1);

  void add(int number, double time, const Vector& positions, const StrainField& strain);
  bool empty() const { return states_.empty(); }

  /// Adds NAME.glb to the folder, the surface with every frame as a morph target, four frames a second;
  /// NAME_0003_on.glb where the first frame is not 0 but 3, so that the file of a whole run stays. Returns
  /// what is to be told: which frames those are, or why there is no file; empty where it holds all.
  std::string add_glb(OutputFolder& folder, const std::string& name) const;

  /// Returns a part of a page that plays the frames and lets a reader go through them. It needs nothing from
  /// outside of the page. Of more than `most_shown` frames as many are drawn, evenly spread, first and last
  /// among them, and the caption says so.
  std::string preview() const;

  static constexpr std::size_t most_shown = 25;

 private:
  std::string glb() const;
  std::vector<std::size_t> shown() const;

  const SolidModel& body_;
  std::vector<std::array<int, 2>> lines_;
  int up_;
  std::vector<int> numbers_;
  std::vector<figures::DeformedState> states_;
};

}  // namespace isostretch::app
