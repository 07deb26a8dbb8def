#include "process.hpp"

#include "scratch.hpp"

#include <cstring>
#include <stdexcept>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>

extern char** environ;  // NOLINT: POSIX declares it nowhere

namespace isostretch::test {

Outcome run(const std::vector<std::string>& command, const std::function<void(int)>& meanwhile) {
  const Scratch streams;
  const std::string out = streams.path("out"), err = streams.path("err");
  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, 1, out.c_str(), O_WRONLY | O_CREAT, 0600);
  posix_spawn_file_actions_addopen(&actions, 2, err.c_str(), O_WRONLY | O_CREAT, 0600);
  pid_t child = 0;
  const int failure = posix_spawn(&child, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failure != 0) throw std::runtime_error(command[0] + ": " + std::strerror(failure));
  if (meanwhile) meanwhile(child);

  int status = 0;
  waitpid(child, &status, 0);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status), read_file(out), read_file(err)};
}

Outcome parameterize(std::vector<std::string> arguments, const std::function<void(int)>& meanwhile) {
  arguments.insert(arguments.begin(), program("parameterize"));
  return run(arguments, meanwhile);
}

}  // namespace isostretch::test
