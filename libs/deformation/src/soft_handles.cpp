#include <isostretch/deformation/soft_handles.hpp>

#include <utility>

namespace isostretch::deformation {

SoftHandles::SoftHandles(int dim, int node_count, std::vector<newton::SoftPin> pins)
    : dim_(dim), node_count_(node_count) {
  move(std::move(pins));
}

void SoftHandles::move(std::vector<newton::SoftPin> pins) {
  term_ = std::make_unique<newton::SoftPinTerm>(dim_, node_count_, std::move(pins));
  if (pattern_ != nullptr) term_->set_pattern(*pattern_);
}

void SoftHandles::set_pattern(const assembly::HessianPattern& pattern) {
  pattern_ = &pattern;
  term_->set_pattern(pattern);
}

}  // namespace isostretch::deformation
