// Direct solvers on matrices of meshes, one line of JSON for every solver, ordering and number of threads;
// the peaks of the machine to compare them with; the supernodes of a matrix.
//
//   isostretch_factorization_bench triangles=20000
//       [solver=multifrontal,cholmod_supernodal] [ordering=amd,metis] [threads=1,2] [level=v3] [last=60]
//       [repetitions=9] [seconds=10]
//   isostretch_factorization_bench machine
//   isostretch_factorization_bench supernodes triangles=2000 [ordering=metis]
//
// Matrices: triangles=<about so many>, tetrahedra=<about so many>, file=<Matrix Market, symmetric>. Solvers
// are those of `sparse`, and mumps where it was found. `last` unknowns are eliminated last and factorised
// again without the others. The peak of the memory is that of the process up to then: for a figure of its own
// a solver needs a process of its own, as tools/factorizations gives it.
#include "bench_matrices.hpp"
#include "factorization_run.hpp"
#include "json_line.hpp"
#include "machine_peaks.hpp"
#include "supernode_list.hpp"

#if defined(ISOSTRETCH_BENCH_MUMPS)
#include "mumps_solver.hpp"
#endif

#include <isostretch/core/error.hpp>
#include <isostretch/core/isa.hpp>
#include <isostretch/core/numbers.hpp>

#include <cstdio>
#include <exception>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace isostretch;
using namespace isostretch::sparse;

struct Arguments {
  SymmetricMatrix matrix;
  std::string name;
  std::vector<Backend> solvers{Backend::multifrontal};
  std::vector<Ordering> orderings{Ordering::metis};
  std::vector<int> threads{1};
  bench::Run run;
};

int count_from(const std::string& text) {
  const auto count = whole_number(text);
  if (!count || *count < 1) throw Error("'" + text + "' is not a positive whole number");
  return *count;
}

double seconds_from(const std::string& text) {
  const auto seconds = finite_number(text);
  if (!seconds || *seconds < 0) throw Error("'" + text + "' is not a number of seconds");
  return *seconds;
}

template <class Read>
auto each(const std::string& list, const Read& read) {
  std::vector<decltype(read(list))> values;
  for (const std::string& text : split(list, ',')) values.push_back(read(text));
  return values;
}

void take(Arguments& arguments, const std::string& name, const std::string& value) {
  if (name == "triangles")
    arguments.matrix = bench::grid_of_triangles(count_from(value));
  else if (name == "tetrahedra")
    arguments.matrix = bench::cube_of_tetrahedra(count_from(value));
  else if (name == "file")
    arguments.matrix = bench::read_matrix_market(value);
  else if (name == "solver")
    arguments.solvers = each(value, [](const std::string& text) { return backend_from_name(text); });
  else if (name == "ordering")
    arguments.orderings = each(value, [](const std::string& text) { return ordering_from_name(text); });
  else if (name == "threads")
    arguments.threads = each(value, count_from);
  else if (name == "level")
    set_isa(isa_from_name(value));
  else if (name == "repetitions")
    arguments.run.repetitions = count_from(value);
  else if (name == "last")
    arguments.run.last = count_from(value);
  else if (name == "seconds")
    arguments.run.seconds = seconds_from(value);
  else
    throw Error("unknown option '" + name + "'");
}

Arguments read(const std::vector<std::string>& words) {
  Arguments arguments;
  for (const std::string& word : words) {
    const std::size_t equals = word.find('=');
    if (equals == std::string::npos) throw Error("'" + word + "' is not name=value");
    const std::string name = word.substr(0, equals);
    take(arguments, name, word.substr(equals + 1));
    if (name == "triangles" || name == "tetrahedra" || name == "file") arguments.name = word;
  }
  if (arguments.matrix.size == 0) throw Error("no matrix: triangles=, tetrahedra= or file= names one");
  return arguments;
}

void print(const std::string& line) {
  std::printf("%s\n", line.c_str());
  std::fflush(stdout);  // whoever waits sees every line as it is made
}

void measure_all(Arguments arguments) {
  for (const Ordering ordering : arguments.orderings)
    for (const Backend solver : arguments.solvers)
      for (const int threads : arguments.threads) {
        arguments.run.options.backend = solver;
        arguments.run.options.ordering = ordering;
        arguments.run.threads = threads;
        print(bench::measure(arguments.matrix, arguments.name, arguments.run));
      }
}

std::string solver_list() {
  std::vector<std::string> names;
  for (const Backend solver : available_backends()) names.emplace_back(backend_name(solver));
  bench::JsonLine line;
  line.add("solvers", listed(names));
  return line.text();
}

void run(std::vector<std::string> words) {
  const std::string mode = words.empty() ? "" : words.front();
  if (mode == "machine") {
    print(solver_list());
    for (const std::string& line : bench::machine_peaks()) print(line);
  } else if (mode == "supernodes") {
    words.erase(words.begin());
    const Arguments arguments = read(words);
    for (const std::string& line : bench::supernode_list(arguments.matrix, arguments.orderings.front()))
      print(line);
  } else {
    measure_all(read(words));
  }
}

}  // namespace

int main(int argc, char** argv) {
  try {
#if defined(ISOSTRETCH_BENCH_MUMPS)
    bench::register_mumps();
#endif
    run({argv + 1, argv + argc});
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
