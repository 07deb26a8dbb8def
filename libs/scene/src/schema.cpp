#include "definitions.hpp"

#include <isostretch/scene/comparison_limits.hpp>
#include <isostretch/scene/option_values.hpp>
#include <isostretch/scene/pipelines.hpp>
#include <isostretch/scene/scene_file.hpp>

namespace isostretch::scene {
namespace {

// The key `name` of the scene is an object of these.
void describe(Value& properties, const char* name, const std::vector<OptionField>& fields) {
  Value help = properties[name]["description"];
  Value schema = options_schema(fields);
  schema["description"] = std::move(help);
  properties[name] = std::move(schema);
}

void describe_parameterization(Value& properties) {
  parameterization::Options options;
  describe(properties, "parameterization", parameterization_fields(options));
  Value& keys = *properties["parameterization"].find("properties");
  const auto list_of = [](const char* definition) {
    Value list = Value::object("type", "array");
    list["items"] = Value::object("$ref", std::string("#/$defs/") + definition);
    return list;
  };
  keys["pins"] = list_of("pin");
  keys["aligned"] = list_of("aligned");
  keys["corners"] = parse_json(R"({
    "description": "Four vertices of the boundary for the corners of the square, in order",
    "type": "array", "items": {"type": "integer", "minimum": 0}, "minItems": 4, "maxItems": 4
  })",
                               "corners");
}

}  // namespace

Value scene_schema() {
  Value shared = definitions();
  Value schema = shared.take("scene");
  Value& properties = *schema.find("properties");
  newton::Options newton;
  deformation::ManipulationOptions manipulation;
  deformation::InterpolationOptions interpolation;
  ComparisonLimits limits;
  describe(properties, "newton", option_fields(newton));
  describe(properties, "manipulation", option_fields(manipulation));
  describe(properties, "interpolation", interpolation_fields(interpolation));
  describe(properties, "limits", option_fields(limits));
  describe_parameterization(properties);
  schema["$defs"] = std::move(shared);
  return schema;
}

std::vector<std::string> scene_keys() {
  return keys_of("scene");
}

}  // namespace isostretch::scene
