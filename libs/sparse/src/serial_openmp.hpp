#pragma once

namespace isostretch::sparse {

// While it lives, parallel regions of OpenMP that this thread meets run serially. CHOLMOD 5 opens several of
// them per supernode with a thread count fixed at its compilation (four); on matrices of meshes waiting for
// those threads takes longer than the factorization itself (README.md). BLAS threads are not affected. Where
// no OpenMP runtime is loaded it does nothing.
class SerialOpenMP {
 public:
  SerialOpenMP();
  ~SerialOpenMP();
  SerialOpenMP(const SerialOpenMP&) = delete;
  SerialOpenMP& operator=(const SerialOpenMP&) = delete;

 private:
  int previous_levels_ = 0;
};

}  // namespace isostretch::sparse
