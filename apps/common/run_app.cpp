#include "common/run_app.hpp"

#include "common/help.hpp"
#include "common/interrupt.hpp"
#include "common/threads.hpp"
#include "common/validators.hpp"

#include <isostretch/core/choice_names.hpp>
#include <isostretch/core/isa.hpp>
#include <isostretch/core/text.hpp>
#include <isostretch/core/version.hpp>
#include <isostretch/energies/plugin.hpp>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <iostream>
#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace isostretch::app {
namespace {

void declare_common(CLI::App& cli, CommonOptions& options) {
  cli.option_defaults()->group("Messages and machine");
  cli.get_help_ptr()->group("Messages and machine");
  auto* quiet = cli.add_flag("-q,--quiet", options.quiet, "Print nothing but errors");
  cli.add_flag("-v,--verbose", options.verbose, "Print debug messages and the full report")->excludes(quiet);
  cli.add_option_function<std::string>(
         "--log-level",
         [&options](const std::string& name) { options.log_level = log_level_from_name(name); },
         "Messages on stderr, and in the file, from this level on: " + listed(log_level_names()))
      ->check(one_of(log_level_names()))
      ->type_name("LEVEL");
  cli.add_option(
         "--log-file", options.log_file,
         "Write messages there, too, with time: debug ones and above unless --log-level says otherwise")
      ->type_name("FILE");
  cli.add_option("--threads", options.threads, "Threads of parallel loops; results do not depend on it")
      ->check(in_range(between(1, 1024), true))
      ->type_name("N");
  // At once, for what comes after it: --list-energies shows them.
  cli.add_option_function<std::string>(
         "--plugin",
         [&options](const std::string& file) {
           energies::load_plugin(file);
           options.plugins.push_back(file);
         },
         "Shared library with energies of your own (isostretch/energies/plugin.hpp); may be repeated")
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::Throw)
      ->trigger_on_parse()
      ->type_name("FILE");
  cli.set_version_flag("--version", "isostretch " + std::string(version_string));
}

ExitCode parse_and_run(int argc, const char* const* argv, const AppDescription& description) {
  CLI::App cli(description.purpose, description.name);
  cli.formatter(std::make_shared<HelpFormatter>());
  cli.footer(example_help(description.examples) + exit_code_help());
  CommonOptions options;
  description.declare(cli);
  declare_common(cli, options);
  std::vector<std::string> notices;
  try {
    std::vector<std::string> words = with_new_names(argc, argv, description.renamed, notices);
    words.erase(words.begin());                // the program
    std::reverse(words.begin(), words.end());  // as CLI11 wants them
    with_error_kind(ErrorKind::misuse, [&] { cli.parse(std::move(words)); });
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0)
      throw Error(ErrorKind::misuse, std::string(error.what()) + " (--help lists the options)");
    cli.exit(error, std::cout, std::cerr);
    return ExitCode::success;
  }
  with_error_kind(ErrorKind::resource, [&] { start_logging(options.logging()); });
  for (const std::string& text : notices) notice(text);
  set_threads(options.threads);
  with_error_kind(ErrorKind::misuse, [] { active_isa(); });  // ISOSTRETCH_ISA may ask for the impossible
  catch_interrupts();
  return description.body(options);
}

// But for lines that go on with two spaces: what shows an expression with the fault in it.
std::string one_line(std::string text) {
  for (std::size_t i = 0; i < text.size(); ++i)
    if (text[i] == '\r' || (text[i] == '\n' && text.compare(i + 1, 2, "  ") != 0)) text[i] = ' ';
  return text;
}

int fail(ExitCode code, const std::string& message) {
  report_error(one_line(message));
  return static_cast<int>(code);
}

}  // namespace

int run_app(int argc, const char* const* argv, const AppDescription& description) noexcept {
  wait_asleep(argv);
  try {
    try {
      return static_cast<int>(parse_and_run(argc, argv, description));
    } catch (const Error& error) {
      return fail(exit_code_of(error.kind()), error_text(error));
    } catch (const std::bad_alloc&) {
      return fail(ExitCode::internal_error, "out of memory");
    } catch (const std::exception& error) {
      return fail(ExitCode::internal_error, std::string("internal error: ") + error.what());
    }
  } catch (...) {
    std::fputs("error: internal error that could not even be reported\n", stderr);
    return static_cast<int>(ExitCode::internal_error);
  }
}

}  // namespace isostretch::app
