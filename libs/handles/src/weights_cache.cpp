#include <isostretch/core/atomic_file.hpp>
#include <isostretch/core/error.hpp>
#include <isostretch/handles/weights_cache.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace isostretch::handles {
namespace {

// With it changes whatever is stored or how it is computed.
constexpr std::string_view magic = "isostretch weights 2\n";
constexpr std::uint64_t byte_order = 0x0102030405060708;

// 128 bits in two streams of multiplications by odd constants.
class Fingerprint {
 public:
  void add(std::string_view bytes) {
    add_word(bytes.size());
    for (; !bytes.empty(); bytes.remove_prefix(std::min<std::size_t>(8, bytes.size()))) {
      std::uint64_t word = 0;
      std::memcpy(&word, bytes.data(), std::min<std::size_t>(8, bytes.size()));
      add_word(word);
    }
  }
  template <class T>
  void add(const std::vector<T>& values) {
    add(std::string_view(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)));
  }

  const std::array<std::uint64_t, 2>& value() const { return value_; }

 private:
  void add_word(std::uint64_t word) {
    value_[0] = (value_[0] ^ word) * 0x9e3779b97f4a7c15;
    value_[0] ^= value_[0] >> 32;
    value_[1] = (value_[1] + word) * 0xd6e8feb86659fd93;
    value_[1] ^= value_[1] >> 29;
  }

  std::array<std::uint64_t, 2> value_{0x243f6a8885a308d3, 0x13198a2e03707344};
};

std::array<std::uint64_t, 2> key_of(const assembly::Elements& elements,
                                    const std::vector<std::vector<int>>& handles,
                                    const WeightOptions& options) {
  Fingerprint key;
  key.add(magic);
  key.add(std::vector<int>{elements.dim, elements.nodes_per_element, elements.points_per_element,
                           elements.node_count, static_cast<int>(handles.size())});
  key.add(elements.nodes);
  key.add(elements.gradients);
  key.add(elements.weights);
  for (std::vector<int> nodes : handles) {
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    key.add(nodes);
  }
  key.add(std::vector<double>{options.tolerance});
  return key.value();
}

std::uint64_t checksum(std::string_view bytes) {
  Fingerprint sum;
  sum.add(bytes);
  return sum.value()[0];
}

template <class T>
void put(std::string& to, const T& value) {
  to.append(reinterpret_cast<const char*>(&value), sizeof value);
}

template <class T>
bool take(std::string_view& from, T& value) {
  if (from.size() < sizeof value) return false;
  std::memcpy(&value, from.data(), sizeof value);
  from.remove_prefix(sizeof value);
  return true;
}

template <class T>
bool take(std::string_view& from, std::vector<T>& values, std::uint64_t count) {
  if (count > from.size() / sizeof(T)) return false;
  values.resize(static_cast<std::size_t>(count));
  if (count > 0) std::memcpy(values.data(), from.data(), values.size() * sizeof(T));
  from.remove_prefix(values.size() * sizeof(T));
  return true;
}

void put(std::string& to, const WeightReport& r) {
  for (const int number : {r.iterations, r.factorizations, int{r.descended}, r.at_zero, r.at_one})
    put(to, number);
  put(to, r.kkt_residual);
}

bool take(std::string_view& from, WeightReport& r) {
  int descended = 0;
  const bool all = take(from, r.iterations) && take(from, r.factorizations) && take(from, descended) &&
                   take(from, r.at_zero) && take(from, r.at_one) && take(from, r.kkt_residual);
  r.descended = descended != 0;
  return all;
}

std::string text_of(const HandleWeights& weights, const std::array<std::uint64_t, 2>& key) {
  std::string text(magic);
  for (const std::uint64_t word : {byte_order, key[0], key[1], std::uint64_t{weights.values.size()},
                                   std::uint64_t{weights.unreached.size()}})
    put(text, word);
  for (const WeightReport& report : weights.reports) put(text, report);
  for (const int node : weights.unreached) put(text, node);
  for (const double value : weights.values) put(text, value);
  put(text, checksum(text));
  return text;
}

bool is_weight(double value) {
  return value >= 0 && value <= 1;
}

// Nothing if there is anything wrong with it.
std::optional<HandleWeights> weights_from(std::string_view text, const std::array<std::uint64_t, 2>& key,
                                          std::size_t nodes, std::size_t handles) {
  std::uint64_t sum = 0;
  if (text.size() < magic.size() + sizeof sum) return std::nullopt;
  std::string_view end = text.substr(text.size() - sizeof sum);
  take(end, sum);
  text.remove_suffix(sizeof sum);
  if (checksum(text) != sum || text.substr(0, magic.size()) != magic) return std::nullopt;
  text.remove_prefix(magic.size());
  std::array<std::uint64_t, 5> head{};
  for (std::uint64_t& word : head)
    if (!take(text, word)) return std::nullopt;
  if (head[0] != byte_order || head[1] != key[0] || head[2] != key[1] || head[3] != nodes * handles)
    return std::nullopt;
  HandleWeights weights;
  weights.handles = static_cast<int>(handles);
  weights.reports.resize(handles);
  for (WeightReport& report : weights.reports)
    if (!take(text, report)) return std::nullopt;
  if (!take(text, weights.unreached, head[4]) || !take(text, weights.values, head[3]) || !text.empty() ||
      !std::all_of(weights.values.begin(), weights.values.end(), is_weight))
    return std::nullopt;
  return weights;
}

std::string contents(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

std::string file_name(const std::array<std::uint64_t, 2>& key) {
  std::string name = "weights-";
  for (const std::uint64_t word : key)
    for (int shift = 60; shift >= 0; shift -= 4) name += "0123456789abcdef"[word >> shift & 15];
  return name + ".bin";
}

}  // namespace

CachedWeights cached_weights(const std::filesystem::path& folder, const assembly::Elements& elements,
                             const std::vector<std::vector<int>>& handles, const WeightOptions& options) {
  elements.validate();
  options.validate();
  const auto key = key_of(elements, handles, options);
  CachedWeights result;
  result.file = folder / file_name(key);
  if (auto found = weights_from(contents(result.file), key, static_cast<std::size_t>(elements.node_count),
                                handles.size())) {
    result.weights = std::move(*found);
    result.hit = true;
    return result;
  }
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  if (failure || !std::filesystem::is_directory(folder))
    throw Error(folder.string() + ": cannot keep weights there: " +
                (failure ? failure.message() : std::string("not a directory")));
  AtomicFile file(result.file.string());  // before the work: it may fail
  result.weights = bounded_biharmonic_weights(elements, handles, options);
  file.write(text_of(result.weights, key));
  file.commit();
  return result;
}

}  // namespace isostretch::handles
