#include "ordering.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/core/timer.hpp>

#include <Eigen/OrderingMethods>

#include <algorithm>
#include <limits>
#include <mutex>
#include <new>
#include <numeric>
#include <string>
#include <utility>

#if defined(ISOSTRETCH_WITH_AMD)
#include <amd.h>
#elif defined(ISOSTRETCH_WITH_CHOLMOD)
#include "cholmod_session.hpp"
#endif
#if defined(ISOSTRETCH_WITH_METIS)
#include <metis.h>
#endif

namespace isostretch::sparse {
namespace {

std::vector<int> natural_ordering(int size) {
  std::vector<int> permutation(size);
  std::iota(permutation.begin(), permutation.end(), 0);
  return permutation;
}

// Triangle meshes have about 4 entries a node in the lower triangle of the graph, tetrahedral ones 7 to 8.
bool dense_as_in_3d(const SymmetricMatrix& graph) {
  return graph.nonzeros() > 5.5 * graph.size;
}

#if defined(ISOSTRETCH_WITH_AMD)

// amd_order() orders the pattern of A + A^T, for which one triangle is enough. Its permutations are those of
// cholmod_amd(), which calls the same code with the same settings.
std::vector<int> minimum_degree(const SymmetricMatrix& graph) {
  std::vector<int> permutation(graph.size);
  if (graph.size == 0) return permutation;  // amd_order() refuses null pointers
  const int status = amd_order(graph.size, graph.column_start.data(), graph.row.data(), permutation.data(),
                               nullptr, nullptr);
  if (status == AMD_OUT_OF_MEMORY) throw std::bad_alloc();
  if (status != AMD_OK)
    throw Error("libamd could not compute the amd ordering, status " + std::to_string(status));
  return permutation;
}

#elif defined(ISOSTRETCH_WITH_CHOLMOD)

std::vector<int> minimum_degree(const SymmetricMatrix& graph) {
  CholmodSession session;
  cholmod_sparse view = CholmodSession::pattern_view(graph);
  std::vector<int> permutation(graph.size);
  const int done = cholmod_amd(&view, nullptr, 0, permutation.data(), session.common());
  if (session.common()->status == CHOLMOD_OUT_OF_MEMORY) throw std::bad_alloc();
  if (!done)
    throw Error("CHOLMOD could not compute the amd ordering, status " +
                std::to_string(session.common()->status));
  return permutation;
}

#else

std::vector<int> minimum_degree(const SymmetricMatrix& graph) {
  using Matrix = Eigen::SparseMatrix<double>;
  const Eigen::Map<const Matrix> lower(graph.size, graph.size, graph.nonzeros(), graph.column_start.data(),
                                       graph.row.data(), graph.value.data());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
  Eigen::AMDOrdering<int>()(Matrix(lower).selfadjointView<Eigen::Lower>(), order);
  return {order.indices().data(), order.indices().data() + graph.size};
}

#endif

#if defined(ISOSTRETCH_WITH_METIS)

// Neighbours of every node, without the node itself.
struct Adjacency {
  std::vector<idx_t> start, neighbour;

  explicit Adjacency(const SymmetricMatrix& lower) : start(static_cast<std::size_t>(lower.size) + 1, 0) {
    const auto for_each_edge = [&](const auto& visit) {
      for (int j = 0; j < lower.size; ++j)
        for (int k = lower.column_start[j]; k < lower.column_start[j + 1]; ++k)
          if (lower.row[k] != j) visit(j, lower.row[k]);
    };
    if (2.0 * lower.nonzeros() > static_cast<double>(std::numeric_limits<idx_t>::max()))
      throw Error(ErrorKind::resource, "the metis ordering: the graph has more edges than METIS can count");
    for_each_edge([&](int a, int b) { ++start[a + 1], ++start[b + 1]; });
    std::partial_sum(start.begin(), start.end(), start.begin());
    neighbour.resize(static_cast<std::size_t>(start.back()));
    std::vector<idx_t> place(start.begin(), start.end() - 1);
    for_each_edge([&](int a, int b) {
      neighbour[place[a]++] = b;
      neighbour[place[b]++] = a;
    });
  }
};

// METIS draws from rand() of the C library, which threads share: one at a time, or orders differ from run to
// run.
std::vector<int> nested_dissection(const SymmetricMatrix& graph) {
  Adjacency adjacency(graph);
  if (adjacency.neighbour.empty()) return natural_ordering(graph.size);
  idx_t nodes = graph.size, options[METIS_NOPTIONS];
  METIS_SetDefaultOptions(options);
  std::vector<idx_t> permutation(graph.size), inverse(graph.size);
  static std::mutex random_numbers;
  const std::lock_guard lock(random_numbers);
  const int status = METIS_NodeND(&nodes, adjacency.start.data(), adjacency.neighbour.data(), nullptr,
                                  options, permutation.data(), inverse.data());
  if (status == METIS_ERROR_MEMORY) throw std::bad_alloc();
  if (status != METIS_OK)
    throw Error("METIS could not compute an ordering, status " + std::to_string(status));
  return {permutation.begin(), permutation.end()};
}

// Measured (docs/benchmarks/cholesky.md). In 3D nested dissection saves up to half of every factorization. In
// 2D its own time is that of 70 factorizations saved at 50 000 nodes, of 20 to 30 at 180 000, and of 10 at
// 500 000.
Ordering choose(const SymmetricMatrix& graph) {
  constexpr int worth_in_space = 1000, worth_in_plane = 300'000;
  return graph.size >= (dense_as_in_3d(graph) ? worth_in_space : worth_in_plane) ? Ordering::metis
                                                                                 : Ordering::amd;
}

#else

std::vector<int> nested_dissection(const SymmetricMatrix&) {
  throw Error("the metis ordering needs METIS, which is not compiled in");
}

Ordering choose(const SymmetricMatrix&) {
  return Ordering::amd;
}

#endif

std::vector<int> expand(const std::vector<int>& groups, const std::vector<int>& first) {
  std::vector<int> permutation;
  permutation.reserve(first.back());
  for (const int g : groups)
    for (int unknown = first[g]; unknown < first[g + 1]; ++unknown) permutation.push_back(unknown);
  return permutation;
}

// The nodes where `chosen` is `which`, ascending, and the graph of them.
struct Subgraph {
  std::vector<int> node;
  SymmetricMatrix matrix;

  Subgraph(const SymmetricMatrix& graph, const std::vector<bool>& chosen, bool which) {
    std::vector<int> number(graph.size, -1);
    for (int g = 0; g < graph.size; ++g)
      if (chosen[g] == which) {
        number[g] = static_cast<int>(node.size());
        node.push_back(g);
      }
    matrix.size = static_cast<int>(node.size());
    matrix.column_start.push_back(0);
    for (const int g : node) {
      for (int k = graph.column_start[g]; k < graph.column_start[g + 1]; ++k)
        if (number[graph.row[k]] >= 0) matrix.row.push_back(number[graph.row[k]]);
      matrix.column_start.push_back(matrix.nonzeros());
    }
    matrix.value.assign(matrix.row.size(), 0.0);
  }
};

std::vector<int> order_nodes(const SymmetricMatrix& graph, Ordering ordering) {
  if (graph.size == 0) return {};
  return ordering == Ordering::metis ? nested_dissection(graph) : minimum_degree(graph);
}

// The groups with unknowns that come last are left out of the graph that is ordered: what they are coupled to
// fills their rows in any order.
std::vector<int> order_before(const SymmetricMatrix& graph, const std::vector<bool>& is_last,
                              Ordering ordering) {
  std::vector<int> order;
  for (const bool last : {false, true}) {
    const Subgraph part(graph, is_last, last);
    for (const int k : order_nodes(part.matrix, ordering)) order.push_back(part.node[k]);
  }
  return order;
}

// Which groups have unknowns among these.
std::vector<bool> groups_of(const std::vector<int>& unknowns, const std::vector<int>& first) {
  std::vector<bool> chosen(first.size() - 1, false);
  for (const int unknown : unknowns)
    chosen[std::upper_bound(first.begin(), first.end(), unknown) - first.begin() - 1] = true;
  return chosen;
}

// Moves these unknowns to the end.
void move_to_end(std::vector<int>& order, const std::vector<int>& last) {
  std::vector<bool> is_last(order.size(), false);
  for (const int unknown : last) is_last[unknown] = true;
  const auto end = std::remove_if(order.begin(), order.end(), [&](int unknown) { return is_last[unknown]; });
  std::copy(last.begin(), last.end(), end);
}

}  // namespace

GroupGraph group_graph(const SymmetricMatrix& A) {
  GroupGraph graph;
  std::vector<int> group_of(A.size);
  for (int j = 0; j < A.size; ++j) {
    if (j == 0 || A.group.empty() || A.group[j] != A.group[j - 1]) graph.first.push_back(j);
    group_of[j] = static_cast<int>(graph.first.size()) - 1;
  }
  SymmetricMatrix& G = graph.matrix;
  G.size = static_cast<int>(graph.first.size());
  graph.first.push_back(A.size);
  G.column_start.push_back(0);
  std::vector<int> seen(G.size, -1);
  for (int g = 0; g < G.size; ++g) {
    for (int k = A.column_start[graph.first[g]]; k < A.column_start[graph.first[g + 1]]; ++k) {
      const int neighbour = group_of[A.row[k]];
      if (seen[neighbour] == g) continue;
      seen[neighbour] = g;
      G.row.push_back(neighbour);
    }
    std::sort(G.row.begin() + G.column_start.back(), G.row.end());
    G.column_start.push_back(G.nonzeros());
  }
  G.value.assign(G.row.size(), 0.0);
  return graph;
}

bool is_of_3d_kind(const SymmetricMatrix& A) {
  return dense_as_in_3d(group_graph(A).matrix);
}

std::vector<int> KeptOrdering::compute(const SymmetricMatrix& A, Ordering wanted,
                                       const std::vector<int>& last, Statistics& statistics) {
  const ScopedTimer timer(statistics.ordering_seconds);
  ++statistics.orderings;
  used_ = wanted;
  last_ = last;
  std::vector<int> order;
  if (wanted == Ordering::natural) {
    order = natural_ordering(A.size);
  } else {
    GroupGraph graph = group_graph(A);
    if (wanted == Ordering::automatic) used_ = choose(graph.matrix);
    groups_ = last.empty() ? order_nodes(graph.matrix, used_)
                           : order_before(graph.matrix, groups_of(last, graph.first), used_);
    column_start_ = std::move(graph.matrix.column_start);
    row_ = std::move(graph.matrix.row);
    order = expand(groups_, graph.first);
  }
  statistics.ordering = used_;
  move_to_end(order, last_);
  return order;
}

std::vector<int> KeptOrdering::adapt(const SymmetricMatrix& A) const {
  std::vector<int> order = used_ == Ordering::natural ? natural_ordering(A.size) : adapted(A);
  move_to_end(order, last_);
  return order;
}

std::vector<int> KeptOrdering::adapted(const SymmetricMatrix& A) const {
  const GroupGraph graph = group_graph(A);
  const SymmetricMatrix& G = graph.matrix;
  std::vector<bool> moved(groups_.size(), false);
  for (int g = 0; g < G.size; ++g)
    for (int k = G.column_start[g], known = column_start_[g]; k < G.column_start[g + 1]; ++k) {
      while (known < column_start_[g + 1] && row_[known] < G.row[k]) ++known;
      const bool is_new = known == column_start_[g + 1] || row_[known] != G.row[k];
      if (is_new && !moved[g] && !moved[G.row[k]]) moved[g] = true;
    }
  std::vector<int> groups = groups_;
  std::stable_partition(groups.begin(), groups.end(), [&](int g) { return !moved[g]; });
  return expand(groups, graph.first);
}

}  // namespace isostretch::sparse
