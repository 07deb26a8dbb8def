#pragma once

#include <isostretch/scene/value.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace isostretch::scene {

/// The version of the schema that scenes have now, "schema" in them.
inline constexpr int schema_version = 1;

/// Returns the JSON Schema (2020-12) of scenes, which are the same for all apps: what each key may be, its
/// default and what it does.
Value scene_schema();

/// Returns the keys that a scene may have.
std::vector<std::string> scene_keys();

/// A key that upgrade() has moved.
struct RenamedKey {
  /// The path before, such as "units".
  std::string from;
  /// The path now, such as "manipulation.length_unit".
  std::string to;
};

/// Gives a scene without "schema" the form of the present schema: keys of scenes made before there was one
/// are moved to where they are now, and messages go on to call them by the path they were written at. Returns
/// what was moved. Throws Error naming the key for another version than the present one, and for a value that
/// is in the way of one that is moved.
std::vector<RenamedKey> upgrade(Value& scene);

/// Returns what a user is told about keys that were moved; empty where none were.
std::string renamed_text(const std::vector<RenamedKey>& keys);

/// Throws Error naming the first key of a scene that the schema does not have, and saying what a key of older
/// scenes is called now.
void check_keys(const Value& scene);

}  // namespace isostretch::scene
