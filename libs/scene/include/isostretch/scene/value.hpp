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
  using List = std::vector<Value>;
  using Object = std::vector<Member>;

  Value() = default;  ///< null
  Value(bool truth) : data_(truth) {}
  Value(int number) : data_(static_cast<double>(number)) {}
  Value(double number) : data_(number) {}
  Value(const char* text) : data_(std::string(text)) {}
  Value(std::string text) : data_(std::move(text)) {}
  Value(std::vector<double> numbers);
  /// Makes a list of these.
  static Value list(List items = {});
  /// Makes an object of these, each key once.
  static Value object(Object members = {});
  /// Makes an object with one key.
  static Value object(const std::string& key, Value value);

  bool is_null() const { return std::holds_alternative<std::monostate>(data_); }
  bool is_truth() const { return std::holds_alternative<bool>(data_); }
  bool is_number() const { return std::holds_alternative<double>(data_); }
  bool is_text() const { return std::holds_alternative<std::string>(data_); }
  bool is_list() const { return std::holds_alternative<List>(data_); }
  bool is_object() const { return std::holds_alternative<Object>(data_); }

  /// These return what the value is, which must be of that kind.
  bool truth() const { return std::get<bool>(data_); }
  double number() const { return std::get<double>(data_); }
  const std::string& text() const { return std::get<std::string>(data_); }
  const List& items() const { return std::get<List>(data_); }
  List& items() { return std::get<List>(data_); }
  const Object& members() const { return std::get<Object>(data_); }

  /// Returns the number of items of a list, members of an object, and 0 of anything else.
  std::size_t size() const;

  /// Returns the value of that key; null for a value that has none, or is no object.
  const Value* find(const std::string& key) const;
  Value* find(const std::string& key);
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
  void set_origin(std::string path) { origin_ = std::move(path); }

  /// Compares all but origins.
  friend bool operator==(const Value& a, const Value& b) { return a.data_ == b.data_; }

 private:
  std::variant<std::monostate, bool, double, std::string, List, Object> data_;
  std::string origin_;
};

/// A key of an object and its value.
struct Member {
  std::string key;
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
