#include "supernode_list.hpp"

#include "json_line.hpp"

#include "../src/ordering.hpp"

#include <isostretch/cholesky/analysis.hpp>

namespace isostretch::sparse::bench {

std::vector<std::string> supernode_list(const SymmetricMatrix& A, Ordering ordering) {
  Statistics statistics;
  const std::vector<int> order = KeptOrdering().compute(A, ordering, {}, statistics);
  const cholesky::Analysis analysis({A.size, A.column_start.data(), A.row.data()}, order);
  const cholesky::Structure& structure = analysis.structure();
  std::vector<std::string> lines;
  for (int s = 0; s < structure.count(); ++s) {
    const cholesky::Supernode& node = structure.supernode[static_cast<std::size_t>(s)];
    JsonLine line;
    line.add("parent", node.parent);
    line.add("columns", node.columns);
    line.add("rows", node.rows);
    line.add("subtree_operations", node.subtree_flops);
    lines.push_back(line.text());
  }
  return lines;
}

}  // namespace isostretch::sparse::bench
