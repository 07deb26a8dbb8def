// What the summaries of this library have in common. The JSON library stays within its sources.
#pragma once

#include <isostretch/core/option_fields.hpp>
#include <isostretch/energies/any_energy.hpp>
#include <isostretch/newton/summary.hpp>
#include <isostretch/scene/value.hpp>

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace isostretch::reports {

using Json = nlohmann::ordered_json;

// status, message, iterations, factorizations, ... of a solve; numbers that are not finite become null.
Json json_of(const newton::Summary& summary);
Json json_of(const newton::Seconds& seconds);
Json json_of(const scene::Value& value);
// The parameters of an energy by name.
Json parameters_of(const energies::AnyEnergy& energy);

// Of a file that somebody opens. A path that is not UTF-8 must not keep the results from being written.
std::string file_text(const Json& json);

// As the printf pattern says; a dash for any other value.
std::string number(const Json& value, const char* pattern);

// Rows of a trace with a column more, that of the frame; with the head if asked.
std::string trace_rows(const newton::Summary& summary, int frame, bool head);

}  // namespace isostretch::reports
