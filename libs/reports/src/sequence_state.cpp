#include "sequence_record.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/core/isa.hpp>
#include <isostretch/core/version.hpp>
#include <isostretch/scene/node.hpp>

#include <algorithm>
#include <limits>
#include <set>

namespace isostretch::reports {
namespace {

constexpr int most = std::numeric_limits<int>::max();

using scene::Node;
using scene::Value;

// The order of keys does not matter.
bool same(const Value& a, const Value& b) {
  if (a.is_list() && b.is_list())
    return std::equal(a.items().begin(), a.items().end(), b.items().begin(), b.items().end(), same);
  if (!a.is_object() || !b.is_object()) return a == b;
  return a.size() == b.size() &&
         std::all_of(a.members().begin(), a.members().end(), [&](const scene::Member& member) {
           return b.has(member.key) && same(member.value, *b.find(member.key));
         });
}

void require_same_scene(const Value& before, const Value& now) {
  std::set<std::string> keys;
  for (const Value* scene : {&before, &now})
    for (const scene::Member& member : scene->members()) keys.insert(member.key);
  for (const std::string& key : keys)
    if (!before.has(key) || !now.has(key) || !same(*before.find(key), *now.find(key)))
      throw Error("belongs to another scene: '" + key + "' has changed; run without --restart to begin anew");
}

// The limit of time ends frames, and changes none.
Value without_time_limit(Value scene) {
  if (Value* newton = scene.find("newton")) {
    newton->take("time_limit");
    if (newton->size() == 0) scene.take("newton");
  }
  return scene;
}

void require_same(const Value& value, const SequenceInput& input) {
  const Node state(value);
  if (!state.at("scene").value().is_object()) state.fail("is damaged: scene: must be an object {...}");
  require_same_scene(without_time_limit(state.at("scene").value()), without_time_limit(input.scene));
  if (state.at("body").text() != input.body.fingerprint())
    throw Error("belongs to another mesh; run without --restart to begin anew");
}

bool is_text(const Value* value, std::string_view text) {
  return value != nullptr && value->is_text() && value->text() == text;
}

bool same_version(const Value& value) {
  return is_text(value.find("instruction_set"), isa_name(active_isa())) &&
         is_text(value.find("version"), version_string);
}

// What the reports read of a frame later.
void require_frame(const Node& value, int number, const deformation::SolidModel& body) {
  const int elements = body.elements.element_count();
  value.at("frame").whole(number, number);
  value.at("time").number();
  value.at("file").text();
  value.at("status").text();
  value.at("parts").whole(0, most);
  value.at("min_det_F_element").whole(0, elements - 1);
  value.at("inverted").whole(0, elements);
  for (const char* key : {"reached", "converged"}) value.at(key).truth();
  for (const char* key : {"iterations", "factorizations"}) value.at(key).whole(0, most);
  for (const char* key : {"min_det_F", "max_length_change"})  // null: was not finite
    if (!value.at(key).value().is_null()) value.at(key).number();
  if (const auto seconds = value.find("seconds")) seconds->number();
}

SequenceState state_in(const Node& value, const SequenceInput& input) {
  SequenceState state;
  state.frame = value.at("frame").whole(0, input.script.frames);
  const auto frames = value.at("frames").items();
  if (frames.size() != static_cast<std::size_t>(state.frame) + 1)
    value.at("frames").fail("must be " + std::to_string(state.frame + 1) + ", not " +
                            std::to_string(frames.size()));
  for (std::size_t i = 0; i < frames.size(); ++i) require_frame(frames[i], static_cast<int>(i), input.body);
  const auto positions = value.at("positions").numbers();
  const auto wanted = static_cast<std::size_t>(input.body.dim * input.body.nodes.rows());
  if (positions.size() != wanted)
    value.at("positions")
        .fail("must be " + std::to_string(wanted) + ", not " + std::to_string(positions.size()));
  state.positions = Vector::Map(positions.data(), static_cast<Eigen::Index>(positions.size()));
  return state;
}

}  // namespace

std::string SequenceReport::state_text(int frame, const Vector& positions) const {
  const Json json{{"version", version_string},
                  {"instruction_set", isa_name(active_isa())},
                  {"scene", json_of(record_->input.scene)},
                  {"body", record_->input.body.fingerprint()},
                  {"frame", frame},
                  {"frames", record_->frames},
                  {"trace", record_->trace},
                  {"positions", std::vector<double>(positions.begin(), positions.end())}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

SequenceState SequenceReport::read_state(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file))
    throw Error(file.string() + ": not there, so there is nothing for --restart to go on from");
  const Value value = scene::read_json(file);
  with_error_prefix(file.string(), [&] { require_same(value, record_->input); });
  try {
    SequenceState state = state_in(Node(value), record_->input);
    record_->trace = Node(value).at("trace").text();
    record_->frames = json_of(Node(value).at("frames").value());
    record_->restarted_at = state.frame + 1;
    if (!same_version(value))
      state.warnings.push_back(file.string() +
                               ": was made by another version or at another instruction-set level; "
                               "the frames to come agree with an uninterrupted run to rounding only");
    return state;
  } catch (const Error& error) {
    throw Error(file.string() + " is damaged: " + error.what());
  }
}

}  // namespace isostretch::reports
