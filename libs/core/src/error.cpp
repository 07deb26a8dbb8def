#include <isostretch/core/error.hpp>

namespace isostretch {

// Out of line, so that the type information exists once and is caught across shared libraries.
Error::Error(const std::string& message) : std::runtime_error(message) {}
Error::Error(ErrorKind kind, const std::string& message) : std::runtime_error(message), kind_(kind) {}
Error::~Error() = default;

}  // namespace isostretch
