#include "similarity.hpp"

namespace isostretch::parameterization {
namespace {

Eigen::Vector2d mean(const std::vector<Eigen::Vector2d>& points) {
  Eigen::Vector2d sum(0, 0);
  for (const auto& p : points) sum += p;
  return sum / static_cast<double>(points.size());
}

}  // namespace

Similarity best_similarity(const std::vector<Eigen::Vector2d>& from, const std::vector<Eigen::Vector2d>& to) {
  const Eigen::Vector2d center_from = mean(from), center_to = mean(to);
  double cosine = 0, sine = 0, spread_from = 0, spread_to = 0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    const Eigen::Vector2d p = from[i] - center_from, q = to[i] - center_to;
    cosine += p.dot(q);
    sine += p.x() * q.y() - p.y() * q.x();
    spread_from += p.squaredNorm();
    spread_to += q.squaredNorm();
  }
  Similarity similarity;
  const double strength = cosine * cosine + sine * sine;
  if (strength > 1e-24 * spread_from * spread_to) {
    similarity.scale_rotation << cosine, -sine, sine, cosine;
    similarity.scale_rotation /= spread_from;
  }
  similarity.shift = center_to - similarity.scale_rotation * center_from;
  return similarity;
}

}  // namespace isostretch::parameterization
