#include <isostretch/core/arena.hpp>
#include <isostretch/core/error.hpp>

#include <new>
#include <string>

namespace isostretch {
namespace {

constexpr std::size_t alignment = 64;

std::size_t round_up(std::size_t bytes) {
  return (bytes + alignment - 1) / alignment * alignment;
}

}  // namespace

void Arena::Free::operator()(std::byte* memory) const noexcept {
  ::operator delete[](memory, std::align_val_t{alignment});
}

Arena::Arena(std::size_t bytes) : capacity_(round_up(bytes)) {
  if (capacity_ > 0)
    memory_.reset(static_cast<std::byte*>(::operator new[](capacity_, std::align_val_t{alignment})));
}

Arena::~Arena() = default;
Arena::Arena(Arena&&) noexcept = default;
Arena& Arena::operator=(Arena&&) noexcept = default;

double* Arena::doubles(std::size_t count) {
  const std::size_t bytes = round_up(count * sizeof(double));
  if (bytes > capacity_ - used_)
    throw Error("arena of " + std::to_string(capacity_) + " bytes cannot hold " +
                std::to_string(used_ + bytes));
  std::byte* block = memory_.get() + used_;
  used_ += bytes;
  return reinterpret_cast<double*>(block);
}

}  // namespace isostretch
