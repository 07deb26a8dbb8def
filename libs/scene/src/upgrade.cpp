// Scenes were made before they had a version: each app then had keys of its own, and "solver" meant three
// things.
#include <isostretch/scene/scene_file.hpp>

#include <isostretch/core/error.hpp>
#include <isostretch/core/text.hpp>

#include <algorithm>
#include <array>

namespace isostretch::scene {
namespace {

struct Move {
  const char* from;
  const char* to;
};

// Of comparisons, which have "problems".
constexpr std::array<Move, 4> comparison_moves{{{"gradient_tolerance", "limits.gradient_tolerance"},
                                                {"max_iterations", "limits.max_iterations"},
                                                {"time_limit", "limits.time_limit"},
                                                {"memory_limit", "limits.memory_limit"}}};

constexpr std::array<Move, 13> body_moves{{{"guess", "initial_guess"},
                                           {"alpha", "manipulation.alpha"},
                                           {"weights", "manipulation.element_weights"},
                                           {"units", "manipulation.length_unit"},
                                           {"incompressibility", "manipulation.incompressibility"},
                                           {"margin", "manipulation.margin"},
                                           {"rotations", "manipulation.rotations"},
                                           {"blend", "manipulation.blend"},
                                           {"method", "manipulation.method"},
                                           {"gap", "manipulation.gap_tolerance"},
                                           {"max_iterations", "manipulation.max_iterations"},
                                           {"largest_stretch", "manipulation.largest_stretch"},
                                           {"relinearize", "manipulation.relinearize"}}};

constexpr std::array<Move, 3> linear_solver_moves{{{"backend", "linear_solver.backend"},
                                                   {"ordering", "linear_solver.ordering"},
                                                   {"preconditioner", "linear_solver.preconditioner"}}};

class Upgrade {
 public:
  explicit Upgrade(Value& scene) : scene_(scene) {}

  std::vector<RenamedKey> run() {
    const bool is_comparison = scene_.has("problems");
    if (is_comparison)
      move_all(comparison_moves);
    else
      move_all(body_moves);
    rename_method();
    move_penalty();
    move_solver();
    if (is_comparison) move_guesses();
    return std::move(moved_);
  }

 private:
  template <std::size_t N>
  void move_all(const std::array<Move, N>& moves) {
    for (const Move& move : moves) shift(scene_, move.from, move.to);
  }

  // Within `owner`, whose own path is `prefix`.
  void shift(Value& owner, const std::string& from, const std::string& to, const std::string& prefix = {},
             const std::string& new_prefix = {}) {
    if (!owner.has(from)) return;
    Value value = owner.take(from);
    value.set_origin(prefix + from);
    Value* place = &owner;
    const std::size_t dot = to.find('.');
    if (dot != std::string::npos) {
      place = &owner[to.substr(0, dot)];
      if (place->is_null()) *place = Value::object();
      if (!place->is_object()) throw Error(prefix + from + ": is now '" + to + "', where something else is");
    }
    const std::string key = dot == std::string::npos ? to : to.substr(dot + 1);
    if (place->has(key)) throw Error(prefix + from + ": is now '" + to + "', which is given, too");
    (*place)[key] = std::move(value);
    moved_.push_back({prefix + from, new_prefix + to});
  }

  void rename_method() {
    Value* group = scene_.find("manipulation");
    Value* method = group == nullptr ? nullptr : group->find("method");
    if (method == nullptr || *method != Value("skinning")) return;
    *method = "unconstrained";
    moved_.push_back({"skinning", "unconstrained"});
  }

  // It was a name, and is an object of options.
  void move_penalty() {
    Value* penalty = scene_.find("penalty");
    if (penalty == nullptr) return;
    Value name = scene_.take("penalty");
    name.set_origin("penalty");
    Value options = Value::object("penalty", std::move(name));
    options.set_origin("penalty");
    scene_["manipulation"]["penalty"] = std::move(options);
    moved_.push_back({"penalty", "manipulation.penalty.penalty"});
  }

  // It was the name of a rival, or an object of options of Newton's method.
  void move_solver() {
    Value* solver = scene_.find("solver");
    if (solver == nullptr) return;
    if (!solver->is_object()) return shift(scene_, "solver", "rival");
    for (const Move& move : linear_solver_moves) shift(*solver, move.from, move.to, "solver.", "newton.");
    shift(scene_, "solver", "newton");
  }

  void move_guesses() {
    Value* problems = scene_.find("problems");
    if (!problems->is_list()) return;
    std::size_t number = 0;
    for (Value& problem : problems->items()) {
      const std::string prefix = "problems[" + std::to_string(number++) + "].";
      if (problem.is_object()) shift(problem, "guess", "initial_guess", prefix, prefix);
    }
  }

  Value& scene_;
  std::vector<RenamedKey> moved_;
};

// What an older key is called now; empty when there was none of that name.
std::string new_name(const std::string& key) {
  for (const Move& move : comparison_moves)
    if (key == move.from && key != std::string("max_iterations")) return move.to;
  for (const Move& move : body_moves)
    if (key == move.from) return move.to;
  if (key == "penalty") return "manipulation.penalty.penalty";
  if (key == "solver") return "newton (an object) or rival (a name)";
  return {};
}

}  // namespace

std::vector<RenamedKey> upgrade(Value& scene) {
  if (!scene.is_object()) return {};
  if (const Value* version = scene.find("schema")) {
    if (*version != Value(schema_version))
      throw Error("schema: must be " + std::to_string(schema_version) + ", the only one there is, not " +
                  to_json(*version));
    return {};
  }
  return Upgrade(scene).run();
}

std::string renamed_text(const std::vector<RenamedKey>& keys) {
  if (keys.empty()) return {};
  std::vector<std::string> texts;
  for (const RenamedKey& key : keys) texts.push_back("'" + key.from + "' is now '" + key.to + "'");
  return "the scene has no \"schema\": 1, and is read as an older one: " + listed(texts);
}

void check_keys(const Value& scene) {
  if (!scene.is_object()) throw Error("must be an object {...}");
  const std::vector<std::string> keys = scene_keys();
  for (const Member& member : scene.members()) {
    if (std::find(keys.begin(), keys.end(), member.key) != keys.end()) continue;
    const std::string now = new_name(member.key);
    throw Error("unknown key '" + member.key + "'; " +
                (now.empty() ? "there are " + listed(keys) : "it is called " + now + " since schema 1"));
  }
}

}  // namespace isostretch::scene
