#include <isostretch/core/error.hpp>

namespace isostretch {

// Out of line, so that the type information exists once and is caught across shared libraries.
Error::Error(const std::string& message) : std::runtime_error(message) {}
Error::Error(ErrorKind kind, const std::string& message) : std::runtime_error(message), kind_(kind) {}
Error::~Error() = default;

OptionError::OptionError(const std::string& option, const std::string& text, ErrorKind kind)
    : Error(kind, option + ": " + text), option_(option), text_(text) {}
OptionError::~OptionError() = default;

}  // namespace isostretch
