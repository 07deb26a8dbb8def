#pragma once

#include "agenda.hpp"
#include "buffer.hpp"
#include "front_table.hpp"
#include "schedule.hpp"
#include "storage.hpp"

#include <isostretch/cholesky/factor.hpp>

#include <atomic>
#include <mutex>
#include <vector>

namespace isostretch::cholesky {

inline std::size_t size(std::int64_t number) {
  return static_cast<std::size_t>(number);
}

// The factor and what making it takes.
class Factor::Elimination {
 public:
  explicit Elimination(const Analysis& analysis);

  std::int64_t bytes(int threads);
  FactorizeResult factorize(const double* values);
  FactorizeResult refactorize(const double* values);
  void schur_complement(double* values) const;
  void solve(const double* b, double* x, int columns);

  std::int64_t most_bytes = 0;
  bool ready = false;

 private:
  // Of one supernode: its own columns and its update matrix.
  struct Place {
    Front front, update;
  };
  Front columns_of(int s) const;
  Front update_of(int s, double* values) const;

  const Storage& plan(int threads);
  bool take_memory(int threads);
  FactorizeResult eliminate_units(bool again);
  void run(int unit, double* stack, bool shared);
  void subtree(const Unit& part, double* update, double* stack);
  bool eliminate(int s, double* update, bool together);
  void assemble(int s, const Place& place, bool together);
  bool factorize_columns(int s, const Place& place, bool together);
  bool factorize_triangle(int position, const Front& block, double* inverse);
  void subtract_product(const Front& of, int row, const Front& from, int begin, int end, bool add) const;
  void make_update(const Place& place, bool together);
  void add_update_of(int child, const Place& place, bool to_update, bool together);
  void note_failure(int position, double pivot);

  void solve_one(double* x);
  void forward(int s, double* x, double* t);
  void backward(int s, double* x, double* t) const;
  void solve_wide(const double* b, double* x, int columns, double* wide_x, double* t) const;

  const Analysis& analysis_;
  const Structure& structure_;
  Schedule schedule_;
  // Plans for so many threads: the one in use, and the last one that was asked for.
  Storage storage_, planned_;
  int storage_threads_ = 0, planned_threads_ = 0;
  Agenda agenda_;
  const FrontTable* kernels_ = nullptr;
  const double* values_ = nullptr;  // of A, while it is factorised
  bool complete_ = false;           // what a refactorization does not do again is there
  Buffer factor_;                   // and update matrices
  std::vector<double*> update_of_;  // of every supernode, while its parent has not taken it
  std::vector<double> carried_;     // of every row below a diagonal block: what the forward solve hands on
  std::atomic<int> failed_{0};      // position of the first pivot that fails; beyond the last: none
  bool not_finite_ = false;
  std::mutex failing_;
};

}  // namespace isostretch::cholesky
