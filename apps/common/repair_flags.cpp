#include "common/repair_flags.hpp"

#include <isostretch/core/numbers.hpp>

#include <isostretch/core/error.hpp>

#include <CLI/CLI.hpp>

namespace isostretch::app {

void RepairFlags::declare(CLI::App& cli) {
  cli.add_flag(
      "--repair", repair_,
      "Turn elements of a file that are numbered the other way round, leave out those that are there twice");
  weld_option_ = declare_weld(cli, weld_);
}

MeshRepair RepairFlags::repair() const {
  MeshRepair result;
  result.repair = repair_;
  result.weld = weld_tolerance(weld_option_, weld_);
  return result;
}

const CLI::Option* declare_weld(CLI::App& cli, std::string& tolerance) {
  return cli.add_flag(
      "--weld{0.0}", tolerance,
      "Take vertices of a file at one place for one, or with =TOLERANCE those no farther apart");
}

std::optional<double> weld_tolerance(const CLI::Option* option, const std::string& tolerance) {
  if (option->count() == 0) return std::nullopt;
  const auto value = finite_number(tolerance);
  if (!value || *value < 0)
    throw Error("--weld: '" + tolerance + "' is no tolerance, which is a number >= 0");
  return *value;
}

}  // namespace isostretch::app
