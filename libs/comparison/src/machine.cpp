#include "json.hpp"

#include <isostretch/comparison/machine.hpp>
#include <isostretch/core/isa.hpp>
#include <isostretch/core/version.hpp>

#include <chrono>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <string>
#include <thread>

#include <sys/utsname.h>
#include <unistd.h>

namespace isostretch::comparison {
namespace {

std::string processor() {
  std::ifstream lines("/proc/cpuinfo");
  for (std::string line; std::getline(lines, line);) {
    const std::size_t colon = line.find(": ");
    if (line.rfind("model name", 0) == 0 && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown";
}

double megabytes_of_memory() {
  return static_cast<double>(::sysconf(_SC_PHYS_PAGES)) * static_cast<double>(::sysconf(_SC_PAGESIZE)) /
         (1024 * 1024);
}

std::string system_name() {
  utsname names{};
  if (::uname(&names) != 0) return "unknown";
  return std::string(names.sysname) + ' ' + names.release + ' ' + names.machine;
}

std::string compiler() {
#ifdef __clang__
  return __VERSION__;
#else
  return "g++ " __VERSION__;
#endif
}

Json environment() {
  Json set = Json::object();
  for (const char* name : {"OMP_NUM_THREADS", "OMP_WAIT_POLICY", "OPENBLAS_NUM_THREADS", "ISOSTRETCH_ISA"})
    if (const char* value = std::getenv(name)) set[name] = value;
  return set;
}

}  // namespace

Record machine_record(int threads) {
  return record_of({{"processor", processor()},
                    {"cores", std::thread::hardware_concurrency()},
                    {"memory_megabytes", megabytes_of_memory()},
                    {"system", system_name()},
                    {"compiler", compiler()},
                    {"flags", ISOSTRETCH_BUILD_FLAGS},
                    {"version", version_string},
                    {"instruction_set", isa_name(active_isa())},
                    {"threads", threads},
                    {"environment", environment()}});
}

std::string date_text() {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::tm parts{};
  ::gmtime_r(&now, &parts);
  char text[32];
  return {text, std::strftime(text, sizeof text, "%Y-%m-%d %H:%M:%S UTC", &parts)};
}

}  // namespace isostretch::comparison
