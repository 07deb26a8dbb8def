#pragma once

#include <isostretch/core/output_folder.hpp>
#include <isostretch/deformation/solid_model.hpp>
#include <isostretch/deformation/strain.hpp>
#include <isostretch/figures/deformation_figure.hpp>

#include <array>
#include <string>
#include <vector>

namespace isostretch::figures {

/// The frames of a sequence as they are made, to be looked through in a page and to be played elsewhere.
class Animation {
 public:
  /// Begins without frames; `lines` and `up` are those of a DeformationFigure. The body must live longer.
  Animation(const deformation::SolidModel& body, std::vector<std::array<int, 2>> lines, int up = -1);

  /// Adds a frame.
  void add(int number, double time, const Vector& positions, const deformation::StrainField& strain);
  /// Returns whether there is no frame.
  bool empty() const { return states_.empty(); }

  /// Returns the surface as binary glTF with every frame as a morph target, four frames a second. Throws
  /// Error for coordinates that do not fit into floats.
  std::string glb() const;
  /// Returns the name of the file for glb(): NAME.glb, or NAME_0003_on.glb where the first frame is not 0 but
  /// 3, so that the file of a whole run stays; empty where there is no frame but the one that a run went on
  /// from.
  std::string glb_name(const std::string& name) const;
  /// Returns which frames the file of that name holds; empty where these are all.
  std::string glb_notice(const std::string& file) const;

  /// Returns a part of a page that plays the frames and lets a reader go through them. It needs nothing from
  /// outside of the page. Of more than `most_shown` frames as many are drawn, evenly spread, first and last
  /// among them, and the caption says so.
  std::string preview() const;

  /// Number of frames that preview() draws at most.
  static constexpr std::size_t most_shown = 25;

 private:
  bool is_whole() const { return !numbers_.empty() && numbers_.front() == 0; }
  std::vector<std::size_t> shown() const;

  const deformation::SolidModel& body_;
  std::vector<std::array<int, 2>> lines_;
  int up_;
  std::vector<int> numbers_;
  std::vector<DeformedState> states_;
};

/// Adds NAME.glb to the folder, the frames as morph targets. Returns what is to be told: which frames those
/// are, or why there is no file; empty where it holds all.
std::string add_glb(OutputFolder& folder, const Animation& animation, const std::string& name);

}  // namespace isostretch::figures
