// General programs for semidefinite programs, each run as a process of its own: CSDP, SDPA, DSDP.
#include "registry.hpp"
#include "sdp_answer.hpp"
#include "sdpa_format.hpp"
#include "temporary_folder.hpp"

#include <isostretch/baselines/process.hpp>
#include <isostretch/core/error.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace isostretch::baselines {
namespace {

using Phase = Recorder::Phase;

// Names in the folder where a program runs: short ones, for dsdp5 writes nothing at all under a long name.
constexpr const char* problem_file = "p.dat-s";
constexpr const char* answer_file = "p.out";

// A program, and how one talks to it.
struct Program {
  std::string_view name, title, source;
  const char* command;
  const char* package;  // in Debian
  std::vector<std::string> (*arguments)(const Options&);
  // Name and text of the file that it has its parameters from, if any.
  const char* parameter_file;
  std::string (*parameters)(const Options&, double largest_optimum);
  SdpAnswer (*read)(const std::string& output, const std::string& answer);
};

std::string number(double value) {
  std::ostringstream text;
  text.precision(17);
  text << value;
  return text.str();
}

int iterations_or(const Options& options, int own) {
  return options.limits.iterations > 0 ? options.limits.iterations : own;
}

// The tolerance is about the gap. Positions that are feasible just to that would look better than the
// optimum: feasibility is never asked for less strictly than each program does by itself.
std::string csdp_parameters(const Options& options, double) {
  const std::string feasibility = number(std::min(options.tolerance, 1e-8));
  return "axtol=" + feasibility + "\natytol=" + feasibility + "\nobjtol=" + number(options.tolerance) +
         "\npinftol=1.0e8\ndinftol=1.0e8\nmaxiter=" + std::to_string(iterations_or(options, 100)) +
         "\nminstepfrac=0.90\nmaxstepfrac=0.97\nminstepp=1.0e-8\nminstepd=1.0e-8\nusexzgap=1\ntweakgap=0"
         "\naffine=0\nprintlevel=1\nperturbobj=1\nfastmode=0\n";
}

// One value a line in an order that SDPA knows. By itself it prints x to four digits. It takes an optimum
// beyond its two bounds for one of a problem that is unbounded or infeasible, and finds infeasible ones no
// other way.
std::string sdpa_parameters(const Options& options, double largest_optimum) {
  const std::string bound = number(std::max(1e5, largest_optimum));
  return std::to_string(iterations_or(options, 100)) + " maxIteration\n" + number(options.tolerance) +
         " epsilonStar\n1.0E2 lambdaStar\n2.0 omegaStar\n-" + bound + " lowerBound\n" + bound +
         " upperBound\n0.1 betaStar\n0.2 betaBar\n0.9 gammaStar\n" +
         number(std::min(options.tolerance, 1e-7)) +
         " epsilonDash\n%+.16e xPrint\nNOPRINT XPrint\nNOPRINT YPrint\n%+.16e infPrint\n";
}

std::vector<std::string> dsdp_arguments(const Options& options) {
  return {problem_file,
          "-save",
          answer_file,
          "-gaptol",
          number(options.tolerance),
          "-maxit",
          std::to_string(iterations_or(options, 200))};
}

constexpr Program csdp = {"csdp",
                          "CSDP",
                          "Borchers 1999: primal-dual interior point, dense Schur complement",
                          "csdp",
                          "coinor-csdp",
                          [](const Options&) -> std::vector<std::string> {
                            return {problem_file, answer_file};
                          },
                          "param.csdp",
                          csdp_parameters,
                          read_csdp};

constexpr Program sdpa = {
    "sdpa",
    "SDPA",
    "Yamashita, Fujisawa, Kojima 2003: primal-dual interior point, sparse Schur complement",
    "sdpa",
    "sdpa",
    [](const Options&) -> std::vector<std::string> {
      return {"-ds", problem_file, "-o", answer_file, "-p", "param.sdpa"};
    },
    "param.sdpa",
    sdpa_parameters,
    read_sdpa};

constexpr Program dsdp = {"dsdp",  "DSDP",  "Benson, Ye, Zhang 2000: dual scaling",
                          "dsdp5", "dsdp",  dsdp_arguments,
                          nullptr, nullptr, read_dsdp};

void write_file(const std::filesystem::path& file, const auto& write) {
  std::ofstream out(file);
  write(out);
  if (!out.flush()) throw Error("cannot write " + file.string());
}

std::string file_text(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

ProcessResult run_program(const Program& program, const std::filesystem::path& folder, const Options& options,
                          Recorder& recorder) {
  Command command;
  command.program = program.command;
  command.arguments = program.arguments(options);
  command.folder = folder;
  ProcessLimits limits;
  limits.megabytes = options.limits.megabytes;
  // The run's time, of which modelling has taken its share, is the recorder's to watch.
  return run_process(command, limits, [&] { return recorder.may_go_on(); });
}

// What the process itself says of a program that left no verdict.
void end_without_verdict(const ProcessResult& process, Recorder& recorder) {
  const std::string line = last_line(process.errors.empty() ? process.output : process.errors);
  const std::string said = line.empty() ? "" : ": " + line;
  if (speaks_of_memory(process.output) || speaks_of_memory(process.errors))
    recorder.end(Status::memory_limit, "no more memory" + said);
  else if (line.find("too large") != std::string::npos)  // CSDP, which counts with 32 bits
    recorder.end(Status::not_applicable, line);
  else if (process.crashed())
    recorder.end(Status::crashed, "ended by signal " + std::to_string(process.signal) + said);
  else if (!process.ended_well())
    recorder.end(Status::failed, "exit code " + std::to_string(process.exit_code) + said);
  else
    recorder.end(Status::unreadable, "its output has no verdict" + said);
}

bool is_answer(const std::vector<double>& v, int variables) {
  return static_cast<int>(v.size()) == variables &&
         std::all_of(v.begin(), v.end(), [](double value) { return std::isfinite(value); });
}

Vector read_answer(const Program& program, const SemidefiniteProgram& problem, const ProcessResult& process,
                   const std::string& text, Recorder& recorder) {
  SdpAnswer answer = program.read(process.output, text);
  recorder.result().iterations = answer.iterations;
  const bool complete = is_answer(answer.v, problem.variables());
  if (process.crashed() || answer.status == Status::not_run)
    end_without_verdict(process, recorder);
  else if (answer.status == Status::converged && !complete)
    recorder.end(Status::unreadable, "it converged, but its answer has " + std::to_string(answer.v.size()) +
                                         " numbers of " + std::to_string(problem.variables()) +
                                         ", or some that are not finite");
  else
    recorder.end(answer.status, answer.message);
  return complete ? problem.positions(answer.v) : Vector();
}

Vector solve_with(const Program& program, const Instance& instance, const Options& options,
                  Recorder& recorder) {
  const TemporaryFolder folder(options.temporary_folder);
  const auto units = SemidefiniteProgram::units_of(instance.problem, instance.rest);
  const SemidefiniteProgram problem(instance.problem, units);
  write_file(folder.path() / problem_file, [&](std::ostream& out) { problem.write(out); });
  // Feasible positions are hardly ever ten times worse than the rest shape.
  const double largest_optimum = 10 * sdp_penalty::energy(instance.problem, instance.rest) / units.energy;
  if (program.parameter_file)
    write_file(folder.path() / program.parameter_file,
               [&](std::ostream& out) { out << program.parameters(options, largest_optimum); });

  recorder.begin(Phase::solving);
  const ProcessResult process = run_program(program, folder.path(), options, recorder);
  recorder.result().peak_megabytes = process.peak_megabytes;
  recorder.begin(Phase::reading);
  if (recorder.ended()) return {};
  const std::string answer = file_text(folder.path() / answer_file);
  Vector x = read_answer(program, problem, process, answer, recorder);
  if (x.size() > 0) recorder.record(x, recorder.result().iterations);
  return x;
}

template <const Program& program>
Entry entry() {
  SolverInfo info{program.name, program.title, program.source, Kind::convex, {}, true};
  if (find_program(program.command).empty())
    info.needs = std::string("program ") + program.command + " (Debian: " + program.package + ") in PATH";
  return {info, [](const Instance& instance, const Options& options, Recorder& recorder) {
            return solve_with(program, instance, options, recorder);
          }};
}

}  // namespace

std::vector<Entry> sdp_programs() {
  return {entry<csdp>(), entry<sdpa>(), entry<dsdp>()};
}

}  // namespace isostretch::baselines
