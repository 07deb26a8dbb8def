#pragma once

#include <algorithm>
#include <exception>
#include <vector>

namespace isostretch::mesh {

// Calls body(begin, end, block) for blocks that make up 0 .. count, by as many threads as OpenMP has. Blocks
// do not depend on the number of threads: what is kept by block and joined in their order does not either.
// The exception of the first block that threw is thrown again.
template <class Body>
void for_blocks(int count, int size, const Body& body) {
  const int blocks = (count + size - 1) / size;
  std::vector<std::exception_ptr> thrown(static_cast<std::size_t>(blocks));
#pragma omp parallel for schedule(dynamic, 1)
  for (int block = 0; block < blocks; ++block) {
    try {
      body(block * size, block + 1 < blocks ? (block + 1) * size : count, block);
    } catch (...) {
      thrown[static_cast<std::size_t>(block)] = std::current_exception();
    }
  }
  for (const std::exception_ptr& exception : thrown)
    if (exception) std::rethrow_exception(exception);
}

}  // namespace isostretch::mesh
