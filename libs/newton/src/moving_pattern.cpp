#include "moving_pattern.hpp"

#include <algorithm>
#include <utility>

namespace isostretch::newton {

MovingPattern::MovingPattern(const assembly::HessianPattern& fixed, std::vector<Term*> terms)
    : terms_(std::move(terms)) {
  for (const Term* term : terms_) versions_.push_back(term->stencil_version());
  make(fixed);
}

bool MovingPattern::follow(const assembly::HessianPattern& fixed) {
  bool moved = false;
  for (std::size_t i = 0; i < terms_.size(); ++i)
    if (const int version = terms_[i]->stencil_version(); version != versions_[i]) {
      versions_[i] = version;
      moved = true;
    }
  if (moved) make(fixed);
  return moved;
}

void MovingPattern::make(const assembly::HessianPattern& fixed) {
  assembly::PatternBuilder builder(fixed.unknowns().node_count());
  for (const Term* term : terms_) term->add_stencil(builder);
  pattern_ = std::make_unique<assembly::HessianPattern>(fixed.unknowns(), std::move(builder));
  for (Term* term : terms_) term->set_pattern(*pattern_);
  merge(fixed.zero_matrix(), pattern_->zero_matrix());
}

void MovingPattern::merge(const sparse::SymmetricMatrix& fixed, const sparse::SymmetricMatrix& moving) {
  const std::size_t fixed_count = fixed.row.size(), moving_count = moving.row.size();
  matrix_.size = fixed.size;
  matrix_.group = fixed.group;
  matrix_.column_start.assign(1, 0);
  matrix_.row.clear();
  matrix_.row.reserve(fixed_count + moving_count);
  place_of_fixed_.resize(fixed_count);
  place_of_moving_.resize(moving_count);
  std::size_t f = 0, m = 0;
  for (std::size_t j = 1; j <= static_cast<std::size_t>(fixed.size); ++j) {
    const auto fixed_end = static_cast<std::size_t>(fixed.column_start[j]),
               moving_end = static_cast<std::size_t>(moving.column_start[j]);
    while (f < fixed_end || m < moving_end) {
      const bool from_fixed = f < fixed_end && (m == moving_end || fixed.row[f] <= moving.row[m]),
                 from_moving = m < moving_end && (f == fixed_end || moving.row[m] <= fixed.row[f]);
      const int place = matrix_.nonzeros();
      matrix_.row.push_back(from_fixed ? fixed.row[f] : moving.row[m]);
      if (from_fixed) place_of_fixed_[f++] = place;
      if (from_moving) place_of_moving_[m++] = place;
    }
    matrix_.column_start.push_back(matrix_.nonzeros());
  }
  matrix_.value.assign(matrix_.row.size(), 0.0);
  fixed_values_.assign(fixed_count, 0.0);
  moving_values_.assign(moving_count, 0.0);
}

void MovingPattern::add_hessians(std::vector<double>& values) {
  std::fill(moving_values_.begin(), moving_values_.end(), 0.0);
  for (const Term* term : terms_) term->add_hessian(moving_values_.data());
  std::fill(values.begin(), values.end(), 0.0);
  for (std::size_t k = 0; k < fixed_values_.size(); ++k)
    values[static_cast<std::size_t>(place_of_fixed_[k])] += fixed_values_[k];
  for (std::size_t k = 0; k < moving_values_.size(); ++k)
    values[static_cast<std::size_t>(place_of_moving_[k])] += moving_values_[k];
}

}  // namespace isostretch::newton
