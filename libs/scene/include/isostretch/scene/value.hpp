#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace isostretch::scene {

class Value;
struct Member;

/// A value of a JSON document: null, true or false, a number, a text, a list, or an object whose keys keep
/// their order.
class Value {
 public:
  /// The items of a list.
  using List = std::vector<Value>;
  /// The members of an object.
  using Object = std::vector<Member>;

  // Nothing that makes, copies or destroys a value is defined here: a member of an object is not complete
  // yet.

  /// Makes null.
  Value();
  /// Makes true or false.
  Value(bool truth);
  /// Makes a number.
  Value(int number);
  /// Makes a number.
  Value(double number);
  /// Makes a text.
  Value(const char* text);
  /// Makes a text.
  Value(std::string text);
  /// Makes a list of numbers.
  Value(std::vector<double> numbers);
  /// Copies a value with all that is in it.
  Value(const Value& other);
  /// Takes another value's content, and leaves it something that can be destroyed or assigned to.
  Value(Value&& other) noexcept;
  /// Copies a value with all that is in it.
  Value& operator=(const Value& other);
  /// Takes another value's content, and leaves it something that can be destroyed or assigned to.
  Value& operator=(Value&& other) noexcept;
  /// Destroys the value and all that is in it.
  ~Value();
  /// Makes a list of nothing.
  static Value list();
  /// Makes a list of these.
  static Value list(List items);
  /// Makes an object without keys.
  static Value object();
  /// Makes an object of these, each key once.
  static Value object(Object members);
  /// Makes an object with one key.
  static Value object(const std::string& key, Value value);

  /// Returns whether the value is null.
  bool is_null() const { return std::holds_alternative<std::monostate>(data_); }
  /// Returns whether the value is true or false.
  bool is_truth() const { return std::holds_alternative<bool>(data_); }
  /// Returns whether the value is a number.
  bool is_number() const { return std::holds_alternative<double>(data_); }
  /// Returns whether the value is a text.
  bool is_text() const { return std::holds_alternative<std::string>(data_); }
  /// Returns whether the value is a list.
  bool is_list() const { return std::holds_alternative<List>(data_); }
  /// Returns whether the value is an object.
  bool is_object() const { return std::holds_alternative<Object>(data_); }

  /// Returns the truth that the value is, which must be one.
  bool truth() const { return std::get<bool>(data_); }
  /// Returns the number that the value is, which must be one.
  double number() const { return std::get<double>(data_); }
  /// Returns the text that the value is, which must be one.
  const std::string& text() const { return std::get<std::string>(data_); }
  /// Returns the items of the list that the value is, which must be one.
  const List& items() const { return std::get<List>(data_); }
  /// Returns the items of the list that the value is, which must be one, to be changed.
  List& items() { return std::get<List>(data_); }
  /// Returns the members of the object that the value is, which must be one.
  const Object& members() const { return std::get<Object>(data_); }

  /// Returns the number of items of a list, members of an object, and 0 of anything else.
  std::size_t size() const;

  /// Returns the value of that key; null for a value that has none, or is no object.
  const Value* find(const std::string& key) const;
  /// Returns the value of that key, to be changed; null for a value that has none, or is no object.
  Value* find(const std::string& key);
  /// Returns whether the value is an object that has the key.
  bool has(const std::string& key) const { return find(key) != nullptr; }
  /// Returns the value of that key, which is added as null where there is none. The value must be an object,
  /// or null, which becomes one.
  Value& operator[](const std::string& key);
  /// Takes the key and its value away and returns the value; null where there is none.
  Value take(const std::string& key);
  /// Adds an item to a list, or to null, which becomes one.
  void push_back(Value item);

  /// Returns the path that messages give this value where it is not that of its place, because it has been
  /// moved since a user wrote it; empty otherwise.
  const std::string& origin() const { return origin_; }
  /// Sets the path that messages give this value.
  void set_origin(std::string path) { origin_ = std::move(path); }

  /// Compares all but origins.
  friend bool operator==(const Value& a, const Value& b);

 private:
  std::variant<std::monostate, bool, double, std::string, List, Object> data_;
  std::string origin_;
};

/// A key of an object and its value.
struct Member {
  /// The key.
  std::string key;
  /// Its value.
  Value value;

  friend bool operator==(const Member&, const Member&) = default;
};

/// Returns the document in a JSON text, in which comments may stand. Throws Error with `name` in front, and
/// line and column or the path, for wrong grammar, a key given twice, numbers that no double can hold, and
/// lists and objects more than 64 deep.
Value parse_json(const std::string& text, const std::string& name);
/// Returns the document in a file, see parse_json(). Throws Error naming the file where it cannot be read.
Value read_json(const std::filesystem::path& file);
/// Returns the value as a JSON text: in one line with a negative `indent`. Numbers are written so that they
/// read back bit for bit; those that are not finite as null.
std::string to_json(const Value& value, int indent = -1);

}  // namespace isostretch::scene
