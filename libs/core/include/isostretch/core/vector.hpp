#pragma once

#include <Eigen/Core>

namespace isostretch {

/// A vector whose memory may change hands between code compiled for different instruction sets. Eigen's own
/// VectorXd is allocated and read as -march says: made here and resized or freed in code built with
/// -march=native, or the other way round, it corrupts the heap. With DontAlign, memory always comes from
/// malloc. In all other respects this is a plain Eigen vector, and it converts to and from VectorXd by
/// assignment.
using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::DontAlign>;

}  // namespace isostretch
