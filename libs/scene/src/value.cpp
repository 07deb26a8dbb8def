#include <isostretch/scene/value.hpp>

#include <algorithm>

namespace isostretch::scene {

Value::Value() = default;
Value::Value(bool truth) : data_(truth) {}
Value::Value(int number) : data_(static_cast<double>(number)) {}
Value::Value(double number) : data_(number) {}
Value::Value(const char* text) : data_(std::string(text)) {}
Value::Value(std::string text) : data_(std::move(text)) {}
Value::Value(const Value& other) = default;
Value::Value(Value&& other) noexcept = default;
Value& Value::operator=(const Value& other) = default;
Value& Value::operator=(Value&& other) noexcept = default;
Value::~Value() = default;
Value::Value(std::vector<double> numbers) : data_(List(numbers.begin(), numbers.end())) {}

Value Value::list() {
  return list(List());
}

Value Value::list(List items) {
  Value value;
  value.data_ = std::move(items);
  return value;
}

Value Value::object() {
  return object(Object());
}

Value Value::object(Object members) {
  Value value;
  value.data_ = std::move(members);
  return value;
}

Value Value::object(const std::string& key, Value value) {
  Value object = Value::object();
  object[key] = std::move(value);
  return object;
}

std::size_t Value::size() const {
  return is_list() ? items().size() : is_object() ? members().size() : 0;
}

const Value* Value::find(const std::string& key) const {
  if (!is_object()) return nullptr;
  const auto found =
      std::find_if(members().begin(), members().end(), [&](const Member& one) { return one.key == key; });
  return found == members().end() ? nullptr : &found->value;
}

Value* Value::find(const std::string& key) {
  return const_cast<Value*>(std::as_const(*this).find(key));
}

Value& Value::operator[](const std::string& key) {
  if (is_null()) data_ = Object();
  if (Value* value = find(key)) return *value;
  auto& members = std::get<Object>(data_);
  members.push_back({key, {}});
  return members.back().value;
}

Value Value::take(const std::string& key) {
  Value* value = find(key);
  if (value == nullptr) return {};
  Value taken = std::move(*value);
  std::erase_if(std::get<Object>(data_), [&](const Member& one) { return one.key == key; });
  return taken;
}

void Value::push_back(Value item) {
  if (is_null()) data_ = List();
  items().push_back(std::move(item));
}

// Here, where Member is complete, which comparing a variant of lists of them needs.
bool operator==(const Value& a, const Value& b) {
  return a.data_ == b.data_;
}

}  // namespace isostretch::scene
