#pragma once

#include <stdexcept>
#include <string>

namespace isostretch {

// Misuse of an interface and unreadable input. The message names the file, line, element, index or option at
// fault and is meant to be shown to a user as it stands. The outcome of an iterative method is never an
// Error: it is a status in the method's Summary.
class Error : public std::runtime_error {
 public:
  explicit Error(const std::string& message);
  ~Error() override;
};

}  // namespace isostretch
