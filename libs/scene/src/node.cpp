#include <isostretch/scene/node.hpp>

#include <isostretch/core/text.hpp>

#include <algorithm>
#include <cmath>

namespace isostretch::scene {
namespace {

// Of any value in a few words.
std::string described(const Value& value) {
  if (value.is_object()) return "an object of " + std::to_string(value.size());
  if (value.is_list()) return "a list of " + std::to_string(value.size());
  return to_json(value).substr(0, 60);
}

}  // namespace

Node::Node(const Value& value, std::string path)
    : value_(&value), path_(value.origin().empty() ? std::move(path) : value.origin()) {}

void Node::fail(const std::string& what) const {
  throw Error(path_.empty() ? what : path_ + ": " + what);
}

void Node::require_kind(bool is, const std::string& kind) const {
  if (!is) fail("must be " + kind + ", not " + described(*value_));
}

const Node& Node::only(const std::vector<std::string>& keys) const {
  require_kind(value_->is_object(), "an object {...}");
  for (const Member& member : value_->members())
    if (std::find(keys.begin(), keys.end(), member.key) == keys.end())
      fail("unknown key '" + member.key + "'; there are " + listed(keys));
  return *this;
}

Node Node::at(const std::string& key) const {
  require_kind(value_->is_object(), "an object {...}");
  const Value* value = value_->find(key);
  if (value == nullptr) fail("the key '" + key + "' is missing");
  return Node(*value, path_.empty() ? key : path_ + "." + key);
}

std::optional<Node> Node::find(const std::string& key) const {
  return has(key) ? std::optional(at(key)) : std::nullopt;
}

double Node::number() const {
  return number(finite(Range{}));
}

double Node::number(const Range& range) const {
  require_kind(value_->is_number() && std::isfinite(value_->number()) && range.contains(value_->number()),
               range.in_words(false));
  return value_->number();
}

int Node::whole(int lowest, int highest) const {
  const bool is = value_->is_number() && value_->number() == std::floor(value_->number()) &&
                  value_->number() >= lowest && value_->number() <= highest;
  require_kind(is, "a whole number from " + std::to_string(lowest) + " to " + std::to_string(highest));
  return static_cast<int>(value_->number());
}

std::string Node::text() const {
  require_kind(value_->is_text(), "a text");
  return value_->text();
}

bool Node::truth() const {
  require_kind(value_->is_truth(), "true or false");
  return value_->truth();
}

std::vector<Node> Node::items() const {
  require_kind(value_->is_list(), "a list [...]");
  std::vector<Node> nodes;
  const Value::List& items = value_->items();
  for (std::size_t i = 0; i < items.size(); ++i)
    nodes.emplace_back(items[i], std::string(path_).append("[").append(std::to_string(i)).append("]"));
  return nodes;
}

std::vector<double> Node::numbers() const {
  std::vector<double> values;
  for (const Node& item : items()) values.push_back(item.number());
  return values;
}

std::vector<int> Node::whole_numbers() const {
  std::vector<int> values;
  for (const Node& item : items()) values.push_back(item.whole(0, 2'147'483'647));
  return values;
}

Eigen::Vector3d Node::point(int dim) const {
  const std::vector<double> values = numbers();
  if (static_cast<int>(values.size()) != dim)
    fail("must be " + std::to_string(dim) + " numbers, not " + std::to_string(values.size()));
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  std::copy(values.begin(), values.end(), point.data());
  return point;
}

void Node::require_one_of(const std::vector<std::string>& names) const {
  if (std::find(names.begin(), names.end(), text()) == names.end())
    fail("unknown '" + text() + "'; there are " + listed(names));
}

}  // namespace isostretch::scene
