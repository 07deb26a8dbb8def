#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

namespace isostretch {

/// What went wrong, for whoever decides what to do about an Error; apps make their exit codes of it.
enum class ErrorKind {
  input,     ///< data that cannot be read or used: a file, a mesh, a scene
  misuse,    ///< an option or a call that makes no sense
  resource,  ///< a file that cannot be written, a program that cannot be run
  stopped,   ///< stopped, by a user or a limit, before there was any result
  unsolved   ///< a method failed before there was any result
};

/// Misuse of an interface, unreadable input, and what leaves no result at all. The message names the file,
/// line, element, index or option at fault and is meant to be shown to a user as it stands. The outcome of an
/// iterative method that has positions to show is never an Error: it is a status in the method's summary.
class Error : public std::runtime_error {
 public:
  explicit Error(const std::string& message);
  Error(ErrorKind kind, const std::string& message);
  ~Error() override;

  /// Returns the kind; input, where nobody has said one.
  ErrorKind kind() const noexcept { return kind_.value_or(ErrorKind::input); }
  /// Returns whether somebody has said what kind it is.
  bool has_kind() const noexcept { return kind_.has_value(); }

 private:
  std::optional<ErrorKind> kind_;
};

/// An option that makes no sense, alone or for this input. what() is "option: text".
class OptionError : public Error {
 public:
  OptionError(const std::string& option, const std::string& text, ErrorKind kind = ErrorKind::misuse);
  ~OptionError() override;

  /// Returns the name of the member of the options, such as soft_pins.
  const std::string& option() const noexcept { return option_; }
  /// Returns what is wrong with it.
  const std::string& text() const noexcept { return text_; }

 private:
  std::string option_, text_;
};

/// Runs the work; an Error without a kind that leaves it gets this one, and so does an error of the file
/// system.
template <class Work>
auto with_error_kind(ErrorKind kind, Work&& work) {
  try {
    return std::forward<Work>(work)();
  } catch (const Error& error) {
    if (error.has_kind()) throw;
    throw Error(kind, error.what());
  } catch (const std::system_error& error) {
    throw Error(kind, error.what());
  }
}

/// Runs the work; an Error without a kind that leaves it gets the text and ": " in front, such as the name of
/// the file it is about.
template <class Work>
auto with_error_prefix(const std::string& text, Work&& work) {
  try {
    return std::forward<Work>(work)();
  } catch (const Error& error) {
    if (error.has_kind()) throw;
    throw Error(text + ": " + error.what());
  }
}

}  // namespace isostretch
