#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

namespace isostretch {

/// The category of an Error, for whoever decides what to do about it; apps make their exit codes of it.
enum class ErrorKind {
  input,     ///< Data cannot be read or used: a file, a mesh, a scene.
  misuse,    ///< An option or a call makes no sense.
  resource,  ///< A file cannot be written, or a program cannot be run.
  stopped,   ///< A user or a limit stopped the work before there was any result.
  unsolved   ///< A method failed before there was any result.
};

/// An exception for misuse of an interface, for unreadable input, and for work that leaves no result at all.
/// The message names the file, line, element, index or option at fault and can be shown to a user as it
/// stands. The outcome of an iterative method that has positions to show is never an Error: it is a status in
/// the summary of the method.
class Error : public std::runtime_error {
 public:
  /// Makes an error whose kind is left to be said by with_error_kind() further up.
  explicit Error(const std::string& message);
  /// Makes an error of the given kind.
  Error(ErrorKind kind, const std::string& message);
  ~Error() override;

  /// Returns the kind, ErrorKind::input if none was given.
  ErrorKind kind() const noexcept { return kind_.value_or(ErrorKind::input); }
  /// Returns whether a kind was given.
  bool has_kind() const noexcept { return kind_.has_value(); }

 private:
  std::optional<ErrorKind> kind_;
};

/// An Error about an option that makes no sense, by itself or for this input. what() is "option: text".
class OptionError : public Error {
 public:
  /// Makes an error about the member `option` of an options struct; `text` says what is wrong with its value.
  OptionError(const std::string& option, const std::string& text, ErrorKind kind = ErrorKind::misuse);
  ~OptionError() override;

  /// Returns the name of the member of the options struct, such as soft_pins.
  const std::string& option() const noexcept { return option_; }
  /// Returns what is wrong with the value of the option.
  const std::string& text() const noexcept { return text_; }

 private:
  std::string option_, text_;
};

/// Runs the work and returns its result. An Error without a kind that leaves the work gets the given one, and
/// an error of the file system becomes an Error of that kind.
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

/// Runs the work and returns its result. An Error without a kind that leaves the work gets the text and ": "
/// in front of its message, such as the name of the file that it is about.
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
