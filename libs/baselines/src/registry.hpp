#pragma once

#include "recorder.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace isostretch::baselines {

// One solver: from the instance to positions (empty where it has none). It reports to the recorder, and ends
// there with a status. Exceptions that leave it become the status `failed`, std::bad_alloc `memory_limit`.
using Run = Vector (*)(const Instance&, const Options&, Recorder&);

struct Entry {
  SolverInfo info;
  Run run = nullptr;
};

// Each in its own file, as many entries as it has variants; those of one that was not found when this was
// built say so in `needs`.
std::vector<Entry> own_methods();
std::vector<Entry> relinearized();
std::vector<Entry> determinant_penalty();
std::vector<Entry> locally_injective();
std::vector<Entry> bounded_distortion();
std::vector<Entry> foldover_free();
std::vector<Entry> lifted_content();
std::vector<Entry> sdp_programs();
std::vector<Entry> ipopt_solvers();
std::vector<Entry> nlopt_solvers();

}  // namespace isostretch::baselines
