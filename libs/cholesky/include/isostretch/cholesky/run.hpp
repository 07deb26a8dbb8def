#pragma once

namespace isostretch::cholesky {

/// Rows of an update matrix that follow each other in the front of the parent, too.
struct Run {
  int row = 0;     ///< The first of them, in the update matrix.
  int place = 0;   ///< Row of the front of the parent that the first of them is.
  int length = 0;  ///< Number of rows.
};

}  // namespace isostretch::cholesky
