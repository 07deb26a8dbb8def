#pragma once

namespace isostretch::sparse::bench {

// Registers MUMPS, multifrontal too, as the solver "mumps". It gets the same order as the others.
void register_mumps();

}  // namespace isostretch::sparse::bench
