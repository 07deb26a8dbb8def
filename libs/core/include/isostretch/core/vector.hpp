#pragma once

#include <Eigen/Core>

namespace isostretch {

// A vector whose memory may change hands between code compiled with different instruction sets. Eigen's own
// VectorXd is allocated and read as -march says: made here and resized or freed in code built with
// -march=native, or the other way round, it corrupts the heap. DontAlign takes memory from malloc always.
// Otherwise it is a plain Eigen vector, and converts to and from VectorXd by assignment.
using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::DontAlign>;

}  // namespace isostretch
