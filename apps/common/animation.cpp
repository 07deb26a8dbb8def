#include "common/animation.hpp"

#include <isostretch/core/error.hpp>

namespace isostretch::app {

std::string add_glb(OutputFolder& folder, const figures::Animation& animation, const std::string& name) {
  const std::string file = animation.glb_name(name);
  if (file.empty()) return name + ".glb is not written: this run has made no frame";
  try {
    folder.add(file, animation.glb());
  } catch (const Error& error) {
    return file + " is not written: " + error.what();
  }
  return animation.glb_notice(file);
}

}  // namespace isostretch::app
