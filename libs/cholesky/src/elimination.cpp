#include "elimination.hpp"

#include "front.hpp"
#include "threads.hpp"

#include <isostretch/core/dispatch.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace isostretch::cholesky {

ISOSTRETCH_DISPATCH(FrontTable, table)

namespace {

// Operations from which a loop is worth sharing among threads.
constexpr double worth_sharing = 2e5;

int block_count(const Front& front) {
  return (front.columns + block_columns - 1) / block_columns;
}

// A parallel region of one thread costs as much as a small front.
template <class Work>
void for_each(int begin, int end, int grain, bool shared, const Work& work) {
  if (shared && end - begin > grain) {
#pragma omp parallel for schedule(dynamic, grain)
    for (int i = begin; i < end; ++i) work(i);
  } else {
    for (int i = begin; i < end; ++i) work(i);
  }
}

// The later rows of a triangle have more columns: these come first.
template <class Work>
void for_chunks(int rows, bool shared, const Work& work) {
  const int count = (rows + chunk_rows - 1) / chunk_rows;
  for_each(0, count, 1, shared, [&](int i) {
    const int begin = (count - 1 - i) * chunk_rows;
    work(begin, std::min(rows, begin + chunk_rows));
  });
}

}  // namespace

Factor::Elimination::Elimination(const Analysis& analysis)
    : analysis_(analysis), structure_(analysis.structure()), schedule_(structure_) {}

const Storage& Factor::Elimination::plan(int threads) {
  if (threads != planned_threads_) {
    planned_threads_ = 0;
    planned_ = Storage(structure_, schedule_, threads);
    planned_threads_ = threads;
  }
  return planned_;
}

std::int64_t Factor::Elimination::bytes(int threads) {
  const std::int64_t values =
      plan(threads).values + overhang + static_cast<std::int64_t>(structure_.row.size());
  return values * static_cast<std::int64_t>(sizeof(double)) +
         static_cast<std::int64_t>(structure_.supernode.size() * sizeof(double*));
}

bool Factor::Elimination::take_memory(int threads) {
  try {
    if (threads != storage_threads_) {
      storage_threads_ = 0;
      storage_ = plan(threads);
      storage_threads_ = threads;
    }
    if (most_bytes > 0 && bytes(threads) > most_bytes) return false;
    update_of_.resize(structure_.supernode.size());
    carried_.resize(structure_.row.size());
    agenda_.reserve(schedule_.unit.size());
  } catch (const std::bad_alloc&) {
    return false;
  }
  return factor_.provide(storage_.values + overhang);
}

FactorizeResult Factor::Elimination::factorize(const double* values) {
  ready = complete_ = false;
  kernels_ = &active_table();
  if (!take_memory(most_threads())) return {FactorizeStatus::out_of_memory, -1};
  values_ = values;
  const FactorizeResult result = eliminate_units(false);
  ready = complete_ = result.status == FactorizeStatus::ok;
  return result;
}

FactorizeResult Factor::Elimination::refactorize(const double* values) {
  if (!complete_) return factorize(values);
  values_ = values;
  const FactorizeResult result = eliminate_units(true);
  ready = result.status == FactorizeStatus::ok;
  return result;
}

// Memory is laid out for the threads that there were when it was taken.
FactorizeResult Factor::Elimination::eliminate_units(bool again) {
  failed_ = analysis_.size();
  agenda_.begin(schedule_, storage_, again);
  const bool parallel = most_threads() > 1;
#pragma omp parallel num_threads(storage_.threads) if (parallel && storage_.threads > 1)
  for (int u; (u = agenda_.take()) >= 0; agenda_.finish(u))
    run(u, factor_.data() + storage_.stack[size(this_thread())], false);
  for (const int u : schedule_.top) {
    const Unit& unit = schedule_.unit[size(u)];
    if (unit.flops > storage_.alone && (unit.changes || !again)) run(u, nullptr, parallel);
  }
  if (failed_ == analysis_.size()) return {};
  return {not_finite_ ? FactorizeStatus::not_finite : FactorizeStatus::not_positive_definite,
          structure_.order[size(failed_)]};
}

// A unit is left out only where a pivot before all of its own has failed: then the first that fails is found
// whatever the threads do.
void Factor::Elimination::run(int u, double* stack, bool shared) {
  const Unit& unit = schedule_.unit[size(u)];
  double* update = factor_.data() + storage_.update[size(u)];
  if (failed_ < structure_.supernode[size(unit.begin)].first) return;
  if (unit.is_top)
    eliminate(unit.root, update, shared);
  else
    subtree(unit, update, stack);
}

// Update matrices lie on the stack one after the other, those of the children of a supernode on top. Its own
// is made above them and takes their place.
void Factor::Elimination::subtree(const Unit& part, double* update, double* stack) {
  double* top = stack;
  for (int s = part.begin; s <= part.root; ++s) {
    const Supernode& node = structure_.supernode[size(s)];
    double* bottom = top;
    if (structure_.supernode[size(s) + 1].child > node.child)
      bottom = update_of_[size(structure_.child[size(node.child)])];
    double* made = s == part.root ? update : top;
    if (!eliminate(s, made, false)) return;
    if (s == part.root) return;
    if (made != bottom) std::memmove(bottom, made, size(update_values(node)) * sizeof(double));
    update_of_[size(s)] = bottom;
    top = bottom + update_values(node);
  }
}

Front Factor::Elimination::columns_of(int s) const {
  const Supernode& node = structure_.supernode[size(s)];
  return {factor_.data() + node.values, size(node.leading), node.rows, node.columns};
}

Front Factor::Elimination::update_of(int s, double* values) const {
  const int rows = structure_.supernode[size(s)].update_rows();
  return {values, size(padded(rows)), rows, rows};
}

bool Factor::Elimination::eliminate(int s, double* update, bool together) {
  const Place place = {columns_of(s), update_of(s, update)};
  const bool shared = together && double(place.front.rows) * place.front.rows > worth_sharing / 8;
  assemble(s, place, shared);
  if (!factorize_columns(s, place, shared)) return false;
  if (place.update.rows > 0) {
    make_update(place, shared);
    const Supernode& node = structure_.supernode[size(s)];
    for (std::int64_t k = node.child; k < structure_.supernode[size(s) + 1].child; ++k)
      add_update_of(structure_.child[size(k)], place, true, shared);
  }
  update_of_[size(s)] = update;
  return true;
}

void Factor::Elimination::assemble(int s, const Place& place, bool shared) {
  const Supernode& node = structure_.supernode[size(s)];
  const Front& front = place.front;
  for_each(0, block_count(front), 1, shared, [&](int i) {
    const Front block = block_of(front, i * block_columns);
    std::memset(block.values, 0, size(block.columns) * block.leading * sizeof(double));
  });
  for (std::int64_t k = node.entry; k < structure_.supernode[size(s) + 1].entry; ++k) {
    const EntryPlace& entry = structure_.entry[size(k)];
    front.values[entry.offset] += values_[entry.entry];
  }
  for (std::int64_t k = node.child; k < structure_.supernode[size(s) + 1].child; ++k)
    add_update_of(structure_.child[size(k)], place, false, shared);
}

// The columns of the child's update matrix that belong to the columns of the front, or those that belong to
// its update matrix.
void Factor::Elimination::add_update_of(int c, const Place& place, bool to_update, bool shared) {
  constexpr int grain = 16;
  const Supernode& child = structure_.supernode[size(c)];
  const int rows = child.update_rows(), columns = place.front.columns;
  const int* where = structure_.place_in_parent.data() + child.row;
  const int middle = static_cast<int>(std::lower_bound(where, where + rows, columns) - where);
  const int begin = to_update ? middle : 0, end = to_update ? rows : middle;
  const Run* run = structure_.run.data() + child.run;
  const int runs = static_cast<int>(structure_.supernode[size(c) + 1].run - child.run);
  const auto add = [&](int from, int to) {
    kernels_->add(update_of(c, update_of_[size(c)]), run, runs, from, to,
                  to_update ? place.update : place.front, to_update ? columns : 0);
  };
  if (!shared) return add(begin, end);
  for_each(0, (end - begin + grain - 1) / grain, 1, shared,
           [&](int i) { add(begin + i * grain, std::min(end, begin + (i + 1) * grain)); });
}

// The triangle on the diagonal is one thread's; rows below it have nothing to do with each other.
bool Factor::Elimination::factorize_columns(int s, const Place& place, bool shared) {
  const Front& front = place.front;
  double inverse[block_columns];
  for (int first = 0; first < front.columns; first += block_columns) {
    const Front block = block_of(front, first);
    if (!factorize_triangle(structure_.supernode[size(s)].first + first, block, inverse)) return false;
    const int left = block.rows - block.columns;
    const double work = double(left) * block.columns * block.columns;
    for_chunks(left, shared && work > worth_sharing, [&](int begin, int end) {
      for (int column = 0; column < block.columns; column += kernels_->panel)
        kernels_->below(block, column, std::min(kernels_->panel, block.columns - column), inverse + column,
                        block.columns + begin, block.columns + end);
    });
    if (first + block_columns >= front.columns) break;
    for_chunks(left, shared, [&](int begin, int end) {
      for (int next = first + block_columns; next < front.columns; next += block_columns)
        subtract_product(block, next - first, block_of(front, next), begin - (next - first - block_columns),
                         end - (next - first - block_columns), true);
    });
  }
  return true;
}

bool Factor::Elimination::factorize_triangle(int position, const Front& block, double* inverse) {
  const int panel = kernels_->panel;
  for (int first = 0; first < block.columns; first += panel, inverse += panel) {
    const int count = std::min(panel, block.columns - first);
    const int done = kernels_->diagonal(block, first, count, inverse);
    if (done < count) {
      note_failure(position + first + done, inverse[done]);
      return false;
    }
    if (first + count < block.columns)
      kernels_->below(block, first, count, inverse, first + count, block.columns);
  }
  return true;
}

// Rows begin ... end - 1 of a block of columns, which are the rows of the front from `row` of `of` on.
void Factor::Elimination::subtract_product(const Front& of, int row, const Front& from, int begin, int end,
                                           bool add) const {
  if (end > 0)
    kernels_->update(of.values + row, of.leading, of.columns, from.values, from.leading, from.columns,
                     std::max(begin, 0), end, add);
}

void Factor::Elimination::make_update(const Place& place, bool shared) {
  const Front &front = place.front, &update = place.update;
  for_chunks(update.rows, shared, [&](int begin, int end) {
    for (int first = 0; first < front.columns; first += block_columns)
      for (int to = 0; to < update.columns; to += block_columns)
        subtract_product(block_of(front, first), front.columns - first + to, block_of(update, to), begin - to,
                         end - to, first > 0);
  });
}

void Factor::Elimination::note_failure(int position, double pivot) {
  const std::lock_guard lock(failing_);
  if (position >= failed_) return;
  failed_ = position;
  not_finite_ = !std::isfinite(pivot);
}

void Factor::Elimination::solve(const double* b, double* x, int columns) {
  const std::size_t n = size(analysis_.size());
  if (columns == 1) {
    std::vector<double> positions(n);
    for (std::size_t p = 0; p < n; ++p) positions[p] = b[structure_.order[p]];
    solve_one(positions.data());
    for (std::size_t p = 0; p < n; ++p) x[structure_.order[p]] = positions[p];
    return;
  }
  const int groups = (columns + wide - 1) / wide, threads = std::min(groups, most_threads());
  const std::size_t each = (n + size(schedule_.most_rows)) * wide;
  std::vector<double> space(each * size(threads));
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads) if (threads > 1)
  for (int group = 0; group < groups; ++group) {
    double* own = space.data() + each * size(this_thread());
    const std::size_t first = size(group) * wide * n;
    solve_wide(b + first, x + first, std::min(wide, columns - group * wide), own, own + n * wide);
  }
}

// Space for all threads is taken before they begin: nothing may be thrown among them.
void Factor::Elimination::solve_one(double* x) {
  const int count = static_cast<int>(schedule_.subtree.size());
  const bool shared = count > 1 && structure_.values > 100'000;
  const std::size_t each = size(padded(schedule_.most_rows));
  std::vector<double> space(each * size(shared ? most_threads() : 1), 0.0);
  const auto in_subtrees = [&](const auto& visit) {
    for_each(0, count, 1, shared, [&](int i) {
      visit(schedule_.unit[size(schedule_.subtree[size(i)])],
            space.data() + each * size(shared ? this_thread() : 0));
    });
  };
  in_subtrees([&](const Unit& part, double* t) {
    for (int s = part.begin; s <= part.root; ++s) forward(s, x, t);
  });
  for (const int u : schedule_.top) forward(schedule_.unit[size(u)].root, x, space.data());
  for (auto u = schedule_.top.rbegin(); u != schedule_.top.rend(); ++u)
    backward(schedule_.unit[size(*u)].root, x, space.data());
  in_subtrees([&](const Unit& part, double* t) {
    for (int s = part.root; s >= part.begin; --s) backward(s, x, t);
  });
}

void Factor::Elimination::forward(int s, double* x, double* t) {
  const Supernode& node = structure_.supernode[size(s)];
  std::copy_n(x + node.first, node.columns, t);
  std::fill_n(t + node.columns, node.update_rows(), 0.0);
  for (std::int64_t k = node.child; k < structure_.supernode[size(s) + 1].child; ++k) {
    const Supernode& child = structure_.supernode[size(structure_.child[size(k)])];
    const int* where = structure_.place_in_parent.data() + child.row;
    const double* carried = carried_.data() + child.row;
    for (int i = 0; i < child.update_rows(); ++i) t[where[i]] += carried[i];
  }
  const Front front = columns_of(s);
  for (int i = 0; i < block_count(front); ++i)
    kernels_->forward(block_of(front, i * block_columns), t + i * block_columns);
  std::copy_n(t, node.columns, x + node.first);
  std::copy_n(t + node.columns, node.update_rows(), carried_.data() + node.row);
}

void Factor::Elimination::backward(int s, double* x, double* t) const {
  const Supernode& node = structure_.supernode[size(s)];
  std::copy_n(x + node.first, node.columns, t);
  for (int i = 0; i < node.update_rows(); ++i) t[node.columns + i] = x[structure_.row[size(node.row + i)]];
  const Front front = columns_of(s);
  for (int i = block_count(front) - 1; i >= 0; --i)
    kernels_->backward(block_of(front, i * block_columns), t + i * block_columns);
  std::copy_n(t, node.columns, x + node.first);
}

void Factor::Elimination::solve_wide(const double* b, double* x, int columns, double* own, double* t) const {
  const std::size_t n = size(analysis_.size());
  for (std::size_t p = 0; p < n; ++p)
    for (int r = 0; r < wide; ++r)
      own[p * wide + size(r)] = r < columns ? b[size(r) * n + size(structure_.order[p])] : 0.0;
  const auto move = [&](const Supernode& node, bool to_front, bool rest) {
    double* columns_of = own + size(node.first) * wide;
    const std::size_t bytes = wide * sizeof(double);
    std::memcpy(to_front ? t : columns_of, to_front ? columns_of : t, size(node.columns) * bytes);
    for (int i = 0; rest && i < node.update_rows(); ++i) {
      double *row = own + size(structure_.row[size(node.row + i)]) * wide,
             *at = t + size(node.columns + i) * wide;
      std::memcpy(to_front ? at : row, to_front ? row : at, bytes);
    }
  };
  for (int s = 0; s < structure_.count(); ++s) {
    move(structure_.supernode[size(s)], true, true);
    const Front front = columns_of(s);
    for (int i = 0; i < block_count(front); ++i)
      kernels_->forward_wide(block_of(front, i * block_columns), t + i * block_columns * wide);
    move(structure_.supernode[size(s)], false, true);
  }
  for (int s = structure_.count() - 1; s >= 0; --s) {
    move(structure_.supernode[size(s)], true, true);
    const Front front = columns_of(s);
    for (int i = block_count(front) - 1; i >= 0; --i)
      kernels_->backward_wide(block_of(front, i * block_columns), t + i * block_columns * wide);
    move(structure_.supernode[size(s)], false, false);
  }
  for (std::size_t p = 0; p < n; ++p)
    for (int r = 0; r < columns; ++r) x[size(r) * n + size(structure_.order[p])] = own[p * wide + size(r)];
}

}  // namespace isostretch::cholesky
