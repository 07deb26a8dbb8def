#pragma once

#include <isostretch/core/choice_names.hpp>
#include <isostretch/core/error.hpp>
#include <isostretch/core/option_fields.hpp>
#include <isostretch/scene/value.hpp>

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace isostretch::scene {

/// A value of a document that knows its path, such as "handles[1].rotate.axis", and names it in every
/// message. All that is asked of a value which it is not throws Error. The document must live longer.
class Node {
 public:
  /// Makes the node of a value, which must live longer, at that path.
  explicit Node(const Value& value, std::string path = {});

  /// Returns the value.
  const Value& value() const { return *value_; }
  /// Returns the path.
  const std::string& path() const { return path_; }
  /// Throws Error: the path and `what`.
  [[noreturn]] void fail(const std::string& what) const;

  /// Returns this object. Throws Error naming a key that is none of these.
  const Node& only(const std::vector<std::string>& keys) const;
  /// Returns whether the value is an object that has the key.
  bool has(const std::string& key) const { return value_->has(key); }
  /// Returns the value of that key of an object, which must be there.
  Node at(const std::string& key) const;
  /// Returns the value of that key, if there is one.
  std::optional<Node> find(const std::string& key) const;

  double number() const;                                ///< a finite number
  double number(const Range& range) const;              ///< a finite number in the range
  double positive() const { return number(above(0)); }  ///< a finite number > 0
  int whole(int lowest, int highest) const;             ///< a whole number from `lowest` to `highest`
  /// Returns the text. Throws Error for another kind of value.
  std::string text() const;
  /// Returns the truth. Throws Error for another kind of value.
  bool truth() const;
  /// Returns the items of a list. Throws Error for another kind of value.
  std::vector<Node> items() const;
  std::vector<double> numbers() const;     ///< a list of finite numbers
  std::vector<int> whole_numbers() const;  ///< a list of whole numbers from 0
  /// Returns a point: `dim` numbers, and zero for the third in the plane.
  Eigen::Vector3d point(int dim) const;

  /// Returns the choice that the text names.
  template <class Choice, std::size_t N>
  Choice choice(const ChoiceNames<Choice, N>& names) const {
    require_one_of(all_names(names));
    return choice_of(names, text());
  }
  /// Throws Error unless the text is one of these.
  void require_one_of(const std::vector<std::string>& names) const;

 private:
  void require_kind(bool is, const std::string& kind) const;

  const Value* value_;
  std::string path_;
};

/// Runs the work; the path of the node is put in front of an Error that leaves it.
template <class Work>
auto naming(const Node& node, Work&& work) {
  try {
    return work();
  } catch (const Error& error) {
    node.fail(error.what());
  }
}

}  // namespace isostretch::scene
