// Memory that cannot be had, at every place where some is taken.
#include "matrices.hpp"

#include <isostretch/cholesky/factor.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <new>
#include <vector>

namespace {

// Allocations until one fails, of the whole program; negative: none does. What failed is counted.
std::atomic<int> until_failure{-1}, failures{0};

bool fails() {
  if (until_failure.load() < 0 || until_failure.fetch_sub(1) > 0) return false;
  until_failure = -1;
  ++failures;
  return true;
}

void* taken(std::size_t bytes) {
  return fails() ? nullptr : std::malloc(bytes > 0 ? bytes : 1);
}

void* taken(std::size_t bytes, std::align_val_t alignment) {
  const auto to = static_cast<std::size_t>(alignment);
  return fails() ? nullptr : std::aligned_alloc(to, (std::max<std::size_t>(bytes, 1) + to - 1) / to * to);
}

void* or_throw(void* memory) {
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

}  // namespace

void* operator new(std::size_t bytes) {
  return or_throw(taken(bytes));
}
void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept {
  return taken(bytes);
}
void* operator new(std::size_t bytes, std::align_val_t alignment) {
  return or_throw(taken(bytes, alignment));
}
void* operator new(std::size_t bytes, std::align_val_t alignment, const std::nothrow_t&) noexcept {
  return taken(bytes, alignment);
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  std::free(memory);
}

using namespace isostretch::cholesky;
using namespace isostretch::cholesky::test;

TEST_CASE("memory: an analysis that gets none throws, and leaves nothing behind") {
  const Matrix A = grid(12, 12, 1);
  const Analysis whole(A.pattern());
  int tried = 0, thrown = 0;
  for (bool done = false; !done; ++tried) {
    const int before = failures;
    until_failure = tried;
    try {
      const Analysis analysis(A.pattern());
      // Sorting does without the memory that it would like to have.
      until_failure = -1;
      CHECK(analysis.factor_nonzeros() == whole.factor_nonzeros());
      done = failures == before;
    } catch (const std::bad_alloc&) {
      ++thrown;
    }
    until_failure = -1;
  }
  CHECK(thrown > 20);
}

TEST_CASE("memory: a factorization that gets none says so, and succeeds when there is some") {
  const Matrix A = grid(12, 12, 1);
  const Analysis analysis(A.pattern());
  int tried = 0;
  for (bool done = false; !done; ++tried) {
    Factor factor(analysis);
    until_failure = tried;
    const FactorizeResult first = factor.factorize(A.value.data());
    until_failure = -1;
    done = static_cast<bool>(first);
    if (!done) CHECK(first.status == FactorizeStatus::out_of_memory);
    CHECK(factor.is_ready() == done);
    REQUIRE(factor.factorize(A.value.data()));
  }
  CHECK(tried > 4);
}

TEST_CASE("memory: a solve that gets none throws, and the factor stays; a refactorization takes none") {
  const Matrix A = grid(12, 12, 1);
  const Analysis analysis(A.pattern());
  Factor factor(analysis);
  REQUIRE(factor.factorize(A.value.data()));
  const int before = failures;
  until_failure = 0;
  CHECK(factor.factorize(A.value.data()));
  CHECK(failures == before);
  until_failure = -1;

  for (const int columns : {1, 3, 20}) {
    const std::vector<double> b(static_cast<std::size_t>(A.size * columns), 1.0);
    std::vector<double> x(b.size());
    int tried = 0;
    for (bool done = false; !done; ++tried) {
      until_failure = tried;
      try {
        factor.solve(b.data(), x.data(), columns);
        done = true;
      } catch (const std::bad_alloc&) {
      }
      until_failure = -1;
      REQUIRE(factor.is_ready());
    }
    CHECK(tried > 1);
    CHECK(x.front() > 0);
  }
}
