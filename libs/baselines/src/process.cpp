#include <isostretch/baselines/process.hpp>
#include <isostretch/core/error.hpp>
#include <isostretch/core/timer.hpp>

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <memory>
#include <sstream>
#include <thread>

extern char** environ;

namespace isostretch::baselines {
namespace {

constexpr double bytes_per_megabyte = 1024.0 * 1024.0;

[[noreturn]] void fail(const std::string& what, int error) {
  throw Error(what + ": " + std::strerror(error));
}

// A file that is closed, and where it has no name gone, whatever happens.
class OutputFile {
 public:
  // Without a name: for the caller to read.
  explicit OutputFile(const std::filesystem::path& name)
      : named_(!name.empty()),
        file_(named_ ? std::fopen(name.c_str(), "wbe") : std::tmpfile(), &std::fclose) {
    if (!file_) fail(named_ ? "cannot write " + name.string() : "cannot make a temporary file", errno);
  }
  int descriptor() const { return fileno(file_.get()); }

  // What the program wrote; nothing where the file has a name.
  std::string text() const {
    std::string text;
    if (named_) return text;
    std::rewind(file_.get());
    std::array<char, 65536> buffer;
    while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), file_.get()))
      text.append(buffer.data(), count);
    return text;
  }

 private:
  bool named_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
};

// Pointers to strings as the system wants them.
class StringTable {
 public:
  explicit StringTable(std::vector<std::string> strings) : strings_(std::move(strings)) {
    for (std::string& string : strings_) pointers_.push_back(string.data());
    pointers_.push_back(nullptr);
  }
  char* const* data() { return pointers_.data(); }

 private:
  std::vector<std::string> strings_;
  std::vector<char*> pointers_;
};

std::vector<std::string> argument_strings(const Command& command) {
  std::vector<std::string> strings = {command.program};
  strings.insert(strings.end(), command.arguments.begin(), command.arguments.end());
  return strings;
}

std::vector<std::string> environment_strings(const Command& command) {
  std::vector<std::string> strings;
  for (char** entry = environ; entry && *entry; ++entry) {
    const std::string text = *entry;
    const auto replaces = [&](const auto& variable) { return text.starts_with(variable.first + "="); };
    if (std::none_of(command.environment.begin(), command.environment.end(), replaces))
      strings.push_back(text);
  }
  for (const auto& [name, value] : command.environment) strings.push_back(name + "=" + value);
  return strings;
}

// A pipe through which a new process says why it could not become the program; it closes when it did.
class FailurePipe {
 public:
  FailurePipe() {
    if (pipe2(ends_, O_CLOEXEC) != 0) fail("cannot make a pipe", errno);
  }
  ~FailurePipe() {
    close(ends_[0]);
    close_writing();
  }
  FailurePipe(const FailurePipe&) = delete;
  FailurePipe& operator=(const FailurePipe&) = delete;

  int writing() const { return ends_[1]; }
  void close_writing() {
    if (ends_[1] >= 0) close(ends_[1]);
    ends_[1] = -1;
  }
  // 0: it is the program.
  int error() const {
    int error = 0;
    ssize_t count = 0;
    do {
      count = read(ends_[0], &error, sizeof error);
    } while (count < 0 && errno == EINTR);
    return count == sizeof error ? error : 0;
  }

 private:
  int ends_[2] = {-1, -1};
};

// All that the new process needs, made before it: as a copy of one thread of a caller with many it may
// neither allocate nor lock.
struct Plan {
  const char* file;
  const char* folder;  // nullptr: stay
  char* const* arguments;
  char* const* environment;
  int output, errors, failure;
  pid_t caller;
  double megabytes;
};

bool limit_memory(double megabytes) {
  if (!(megabytes > 0)) return true;
  rlimit limit;
  if (getrlimit(RLIMIT_AS, &limit) != 0) return false;
  // The caller's own limit cannot be raised.
  const double bytes = megabytes * bytes_per_megabyte;
  constexpr double most = 1e18;  // beyond any machine, and within rlim_t
  if (bytes < most) limit.rlim_max = std::min(static_cast<rlim_t>(bytes), limit.rlim_max);
  limit.rlim_cur = limit.rlim_max;
  return setrlimit(RLIMIT_AS, &limit) == 0;
}

// Signals as a program expects them: none ignored, none blocked.
bool reset_signals() {
  struct sigaction by_default {};
  by_default.sa_handler = SIG_DFL;
  for (int number = 1; number < NSIG; ++number) sigaction(number, &by_default, nullptr);
  sigset_t none;
  sigemptyset(&none);
  return sigprocmask(SIG_SETMASK, &none, nullptr) == 0;
}

bool connect_streams(const Plan& plan) {
  const int nothing = open("/dev/null", O_RDONLY);
  return nothing >= 0 && dup2(nothing, STDIN_FILENO) >= 0 && dup2(plan.output, STDOUT_FILENO) >= 0 &&
         dup2(plan.errors, STDERR_FILENO) >= 0;
}

// A program does not survive the caller either, whatever ends that; it would in its group of its own.
bool end_with(pid_t caller) {
  return prctl(PR_SET_PDEATHSIG, SIGKILL) == 0 && getppid() == caller;
}

// In the new process. Returns only where it cannot be done; only what is safe in a signal handler is called.
void become(const Plan& plan) {
  if (setpgid(0, 0) == 0 && end_with(plan.caller) && reset_signals() && connect_streams(plan) &&
      (!plan.folder || chdir(plan.folder) == 0) && limit_memory(plan.megabytes))
    execve(plan.file, plan.arguments, plan.environment);
}

pid_t start(const Plan& plan) {
  const pid_t process = fork();
  if (process != 0) return process;
  become(plan);
  const int error = errno;
  [[maybe_unused]] const ssize_t written = write(plan.failure, &error, sizeof error);
  kill(getpid(), SIGKILL);  // not exit: nothing that the caller has registered for its own end may run
  return 0;
}

double own_peak_megabytes() {
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;  // Linux counts it in kilobytes
}

// Of the program alone, as long as it runs; 0 where the system does not tell.
double resident_peak_megabytes(pid_t process) {
  std::ifstream status("/proc/" + std::to_string(process) + "/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmHWM:")) return std::strtod(line.c_str() + 6, nullptr) / 1024;
  return 0;
}

// A group of processes, with the program that leads it. Nothing of it survives this object.
class ProcessGroup {
 public:
  ProcessGroup(Plan plan, const std::string& name) : caller_megabytes_(own_peak_megabytes()) {
    FailurePipe failure;
    plan.failure = failure.writing();
    leader_ = start(plan);
    if (leader_ < 0) fail("cannot start " + name, errno);
    failure.close_writing();
    if (const int error = failure.error(); error != 0) {
      end();
      fail("cannot start " + name, error);
    }
  }
  ~ProcessGroup() {
    if (!ended_) end();
  }
  ProcessGroup(const ProcessGroup&) = delete;
  ProcessGroup& operator=(const ProcessGroup&) = delete;

  bool running() {
    sampled_megabytes_ = std::max(sampled_megabytes_, resident_peak_megabytes(leader_));
    siginfo_t info{};
    // Left as it is, so that its number stays taken while the rest of the group is killed.
    const int code = waitid(P_PID, static_cast<id_t>(leader_), &info, WEXITED | WNOHANG | WNOWAIT);
    return code == 0 ? info.si_pid == 0 : errno == EINTR;
  }

  void send(int signal) const { kill(-leader_, signal); }

  // Kills what is left, and takes the books of the leader.
  void end(ProcessResult* result = nullptr) {
    send(SIGKILL);
    int status = 0;
    rusage usage{};
    pid_t waited = -1;
    do {
      waited = wait4(leader_, &status, 0, &usage);
    } while (waited < 0 && errno == EINTR);
    ended_ = true;
    // Nobody knows how it ended where the caller ignores SIGCHLD.
    if (!result || waited < 0) return;
    if (WIFEXITED(status)) result->exit_code = WEXITSTATUS(status);
    if (WIFSIGNALED(status)) result->signal = WTERMSIG(status);
    result->peak_megabytes = peak_megabytes(usage);
  }

 private:
  // A process begins with the books of the one that started it: where its peak is not above that one's, it
  // is the caller's, and samples are what is known.
  double peak_megabytes(const rusage& usage) const {
    const double peak = static_cast<double>(usage.ru_maxrss) / 1024;
    return peak > caller_megabytes_ || sampled_megabytes_ == 0 ? peak : sampled_megabytes_;
  }

  pid_t leader_ = -1;
  bool ended_ = false;
  double caller_megabytes_, sampled_megabytes_ = 0;
};

void nap(double seconds) {
  std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
}

// The end of a quick program is noticed at once, that of a slow one within a twentieth of a second.
double nap_after(double seconds) {
  return std::clamp(seconds / 20, 5e-4, 0.05);
}

void wait_for_end(ProcessGroup& group, const Timer& timer, double seconds) {
  while (group.running() && timer.seconds() < seconds) nap(nap_after(timer.seconds()));
}

void supervise(ProcessGroup& group, const ProcessLimits& limits, const MayGoOn& may_go_on,
               ProcessResult& result) {
  constexpr double grace = 2;  // seconds from SIGTERM to SIGKILL
  const Timer timer;
  while (group.running()) {
    result.timed_out = limits.seconds > 0 && timer.seconds() >= limits.seconds;
    result.stopped = !result.timed_out && may_go_on && !may_go_on();
    if (result.timed_out || result.stopped) {
      group.send(SIGTERM);
      wait_for_end(group, Timer(), grace);
      break;
    }
    const double pause = nap_after(timer.seconds());
    nap(limits.seconds > 0 ? std::min(pause, std::max(limits.seconds - timer.seconds(), 0.0)) : pause);
  }
  result.seconds = timer.seconds();
  group.end(&result);
}

bool executable(const std::filesystem::path& file) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(file, ignored) && access(file.c_str(), X_OK) == 0;
}

std::filesystem::path file_of(const std::string& program) {
  if (program.find('/') != std::string::npos) return std::filesystem::absolute(program);
  std::filesystem::path file = find_program(program);
  if (file.empty()) fail("cannot start " + program, ENOENT);
  return file;
}

}  // namespace

std::filesystem::path find_program(const std::string& name) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');) {
    // An empty entry is the current folder.
    const std::filesystem::path file = std::filesystem::absolute(std::filesystem::path(folder) / name);
    if (executable(file)) return file;
  }
  return {};
}

ProcessResult run_process(const Command& command, const ProcessLimits& limits, const MayGoOn& may_go_on) {
  const auto in_folder = [&](const std::filesystem::path& name) {
    return name.empty() ? name : command.folder / name;
  };
  const OutputFile output(in_folder(command.output_file)), errors(in_folder(command.errors_file));
  StringTable arguments(argument_strings(command)), environment(environment_strings(command));
  const std::filesystem::path file = file_of(command.program);
  ProcessResult result;
  {
    ProcessGroup group({.file = file.c_str(),
                        .folder = command.folder.empty() ? nullptr : command.folder.c_str(),
                        .arguments = arguments.data(),
                        .environment = environment.data(),
                        .output = output.descriptor(),
                        .errors = errors.descriptor(),
                        .failure = -1,
                        .caller = getpid(),
                        .megabytes = limits.megabytes},
                       command.program);
    supervise(group, limits, may_go_on, result);
  }
  result.output = output.text();
  result.errors = errors.text();
  return result;
}

}  // namespace isostretch::baselines
