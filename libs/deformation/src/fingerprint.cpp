#include <isostretch/core/text.hpp>
#include <isostretch/deformation/fingerprint.hpp>

namespace isostretch::deformation {

void Fingerprint::add_bytes(const void* data, std::size_t count) {
  const auto* byte = static_cast<const unsigned char*>(data);
  for (std::size_t i = 0; i < count; ++i) hash_ = (hash_ ^ byte[i]) * 1099511628211ULL;
}

std::string Fingerprint::text() const {
  return formatted("%016llx", static_cast<unsigned long long>(hash_));
}

}  // namespace isostretch::deformation
