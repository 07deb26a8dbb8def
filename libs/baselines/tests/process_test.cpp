#include "fake_programs.hpp"

#include <isostretch/baselines/process.hpp>
#include <isostretch/core/error.hpp>
#include <isostretch/core/timer.hpp>

#include <doctest/doctest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <string>
#include <thread>

namespace {

using namespace isostretch;
using baselines::Command;
using baselines::ProcessResult;
using baselines::run_process;
using baselines::TemporaryFolder;

Command shell(const std::string& script) {
  Command command;
  command.program = "sh";
  command.arguments = {"-c", script};
  return command;
}

std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

// A process that has ended may stay in the table until somebody asks for it, without a command line; one that
// has just been killed may take a moment.
bool ends(const std::string& process) {
  const Timer timer;
  while (timer.seconds() < 5)
    if (text_of("/proc/" + process + "/cmdline").empty()) return true;
  return false;
}

TEST_CASE("A process hands back its exit code, what it wrote, its time and its memory") {
  const ProcessResult result = run_process(shell("echo out; echo err >&2; exit 3"));
  CHECK(result.exit_code == 3);
  CHECK(result.signal == 0);
  CHECK_FALSE(result.ended_well());
  CHECK_FALSE(result.crashed());
  CHECK(result.output == "out\n");
  CHECK(result.errors == "err\n");
  CHECK(result.seconds > 0);
  CHECK(result.peak_megabytes > 0);
}

TEST_CASE("Arguments reach a program as they are, and its standard input is empty") {
  Command command{"printf", {"%s|", "a b", "$HOME", "'*'"}, {}, {}, {}, {}};
  CHECK(run_process(command).output == "a b|$HOME|'*'|");
  CHECK(run_process({"cat", {}, {}, {}, {}, {}}).ended_well());
}

TEST_CASE("A process runs in the folder, the environment and with the files that it is given") {
  const TemporaryFolder folder({});
  Command command = shell("pwd; echo \"$ISOSTRETCH_TEST-$PATH\"; echo oops >&2");
  command.folder = folder.path();
  command.environment = {{"ISOSTRETCH_TEST", "value"}, {"PATH", "elsewhere"}};
  command.output_file = "out.txt";
  command.errors_file = "err.txt";
  const ProcessResult result = run_process(command);
  CHECK(result.ended_well());
  CHECK(result.output.empty());
  CHECK(text_of(folder.path() / "out.txt") ==
        std::filesystem::canonical(folder.path()).string() + "\nvalue-elsewhere\n");
  CHECK(text_of(folder.path() / "err.txt") == "oops\n");
}

TEST_CASE("A signal that nobody here sent is a crash") {
  const ProcessResult result = run_process(shell("kill -SEGV $$"));
  CHECK(result.signal == SIGSEGV);
  CHECK(result.exit_code == -1);
  CHECK(result.crashed());
}

TEST_CASE("The time limit ends a program and its children, also one that does not listen") {
  const Timer timer;
  const ProcessResult result = run_process(shell("sleep 1000 & echo $!; sleep 1000"), {.seconds = 0.1});
  CHECK(result.timed_out);
  CHECK_FALSE(result.crashed());
  CHECK(result.signal == SIGTERM);
  CHECK(timer.seconds() < 1.5);
  CHECK(ends(result.output.substr(0, result.output.find('\n'))));

  const ProcessResult deaf =
      run_process(shell("trap '' TERM; while true; do sleep 0.1; done"), {.seconds = 0.1});
  CHECK(deaf.timed_out);
  CHECK(deaf.signal == SIGKILL);
}

TEST_CASE("What a program leaves running in its group does not survive it") {
  const ProcessResult result = run_process(shell("sleep 1000 & echo $!"));
  CHECK(result.ended_well());
  CHECK(ends(result.output.substr(0, result.output.find('\n'))));
}

TEST_CASE("The caller is asked whether to go on") {
  int asked = 0;
  const ProcessResult result = run_process(shell("sleep 1000"), {}, [&] { return ++asked < 3; });
  CHECK(asked == 3);
  CHECK(result.stopped);
  CHECK_FALSE(result.timed_out);
  CHECK_FALSE(result.crashed());
}

TEST_CASE("An exception of the caller's leaves no process behind") {
  const TemporaryFolder folder({});
  Command command = shell("echo $$; exec sleep 1000");
  command.folder = folder.path();
  command.output_file = "process";
  const auto throws = [&]() -> bool {
    if (text_of(folder.path() / "process").empty()) return true;
    throw Error("enough");
  };
  CHECK_THROWS_WITH_AS(run_process(command, {}, throws), "enough", Error);
  const std::string process = text_of(folder.path() / "process");
  CHECK(ends(process.substr(0, process.find('\n'))));
}

TEST_CASE("A program does not survive its caller") {
  const TemporaryFolder folder({});
  const std::filesystem::path file = folder.path() / "process";
  Command command = shell("echo $$; exec sleep 1000");
  command.output_file = file;
  const pid_t caller = fork();
  REQUIRE(caller >= 0);
  if (caller == 0) {
    run_process(command);
    kill(getpid(), SIGKILL);
  }
  const Timer timer;
  while (text_of(file).empty() && timer.seconds() < 5) usleep(1000);
  kill(caller, SIGKILL);
  waitpid(caller, nullptr, 0);
  const std::string process = text_of(file);
  REQUIRE_FALSE(process.empty());
  CHECK(ends(process.substr(0, process.find('\n'))));
}

TEST_CASE("The memory limit refuses memory, and the peak is the program's own") {
  // tail keeps all of a last line.
  const ProcessResult refused = run_process(shell("head -c 400m /dev/zero | tail -n 1 | wc -c"), {0, 100});
  CHECK(refused.errors.find("memory") != std::string::npos);
  const std::string large(std::size_t{300} << 20, 'x');  // of the caller's
  // The shell itself keeps the text, and long enough to be seen.
  const ProcessResult allowed =
      run_process(shell("x=$(head -c 60m /dev/zero | tr '\\0' a); sleep 0.5; echo ${#x}"));
  CHECK(allowed.output.find("62914560") != std::string::npos);
  CHECK(allowed.peak_megabytes >= 60);
  CHECK(allowed.peak_megabytes < 299);
  CHECK(run_process(shell("sleep 0.05; exit " + std::to_string(large[7] == 'y'))).peak_megabytes < 100);
}

TEST_CASE("A program that cannot be started is an error with its name") {
  CHECK_THROWS_WITH_AS(run_process({"isostretch-no-such-program", {}, {}, {}, {}, {}}),
                       "cannot start isostretch-no-such-program: No such file or directory", Error);
  const TemporaryFolder folder({});
  std::ofstream(folder.path() / "text") << "no program\n";
  CHECK_THROWS_WITH_AS(run_process({(folder.path() / "text").string(), {}, {}, {}, {}, {}}),
                       doctest::Contains("Permission denied"), Error);
  Command command = shell("true");
  command.folder = folder.path() / "nowhere";
  CHECK_THROWS_WITH_AS(run_process(command), doctest::Contains("No such file or directory"), Error);
}

TEST_CASE("Programs are found by PATH at the time") {
  const tests::FakePrograms programs;
  CHECK(baselines::find_program("isostretch-fake").empty());
  programs.add("isostretch-fake", "echo fake");
  CHECK_FALSE(baselines::find_program("isostretch-fake").empty());
  CHECK(run_process({"isostretch-fake", {}, {}, {}, {}, {}}).output == "fake\n");
  programs.hide_the_others();
  CHECK(baselines::find_program("sh").empty());
}

TEST_CASE("Several threads run programs at the same time") {
  std::vector<std::thread> threads;
  std::vector<std::string> outputs(6);
  for (std::size_t i = 0; i < outputs.size(); ++i)
    threads.emplace_back(
        [&outputs, i] { outputs[i] = run_process(shell("echo " + std::to_string(i))).output; });
  for (std::thread& thread : threads) thread.join();
  for (std::size_t i = 0; i < outputs.size(); ++i) CHECK(outputs[i] == std::to_string(i) + "\n");
}

TEST_CASE("A temporary folder is gone with its content, whatever happens") {
  std::filesystem::path path;
  try {
    const TemporaryFolder folder({});
    path = folder.path();
    std::filesystem::create_directories(path / "a/b");
    std::ofstream(path / "a/b/file") << "text";
    throw Error("on the way");
  } catch (const Error&) {
  }
  CHECK_FALSE(path.empty());
  CHECK_FALSE(std::filesystem::exists(path));
  CHECK_THROWS_WITH_AS(TemporaryFolder("/nonexistent"), doctest::Contains("/nonexistent: No such file"),
                       Error);
}

}  // namespace
