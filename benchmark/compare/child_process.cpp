// SPDX-License-Identifier: GPL-3.0-or-later
#include "child_process.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <thread>

#include "scratch_folder.h"

extern char** environ;

namespace filmsticking::bench {
namespace {

constexpr int kNotStarted = 127;

std::string read_all(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(file), {});
}

std::vector<char*> pointers(std::vector<std::string>& words) {
  std::vector<char*> all;
  for (std::string& word : words) all.push_back(word.data());
  all.push_back(nullptr);
  return all;
}

std::vector<std::string> make_environment(int threads) {
  // Threads that wait must sleep: the Poisson methods take ten times as long where they spin on busy cores.
  std::vector<std::string> own = {"OMP_WAIT_POLICY=passive"};
  if (threads > 0) own.push_back("OMP_NUM_THREADS=" + std::to_string(threads));
  const auto name_of = [](const std::string& variable) { return variable.substr(0, variable.find('=') + 1); };
  std::vector<std::string> all = own;
  for (char** variable = environ; *variable; ++variable)
    if (std::none_of(own.begin(), own.end(),
                     [&](const std::string& mine) { return name_of(mine) == name_of(*variable); }))
      all.emplace_back(*variable);
  return all;
}

}  // namespace

ChildEnd run_child(const std::vector<std::string>& command, const Limits& limits, int threads) {
  const ScratchFolder folder;
  const std::string out = folder / "out", err = folder / "err";
  std::vector<std::string> words = command, environment = make_environment(threads);
  const std::vector<char*> arguments = pointers(words), variables = pointers(environment);

  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("no process can be made");
  if (child == 0) {  // from here on only what is safe in a copy of a program with many threads
    setpgid(0, 0);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (limits.memory_mb > 0) {
      const auto bytes = static_cast<rlim_t>(limits.memory_mb) * 1000000;
      const struct rlimit limit = {bytes, bytes};
      setrlimit(RLIMIT_AS, &limit);
    }
    const struct rlimit no_core = {0, 0};
    setrlimit(RLIMIT_CORE, &no_core);
    const int to_out = open(out.c_str(), O_WRONLY | O_CREAT, 0600);
    const int to_err = open(err.c_str(), O_WRONLY | O_CREAT, 0600);
    if (dup2(to_out, STDOUT_FILENO) < 0 || dup2(to_err, STDERR_FILENO) < 0) _exit(kNotStarted);
    execvpe(arguments[0], arguments.data(), variables.data());
    _exit(kNotStarted);
  }

  const auto begin = std::chrono::steady_clock::now();
  ChildEnd end;
  int status = 0;
  while (waitpid(child, &status, WNOHANG) == 0) {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
    if (limits.seconds > 0 && passed.count() > limits.seconds) {
      end.timed_out = true;
      if (kill(-child, SIGKILL) != 0) kill(child, SIGKILL);
      waitpid(child, &status, 0);
      break;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  if (WIFSIGNALED(status)) end.signal = WTERMSIG(status);
  if (WIFEXITED(status)) end.code = WEXITSTATUS(status);
  if (end.code == kNotStarted) throw std::runtime_error(command[0] + " cannot be run");
  end.out = read_all(out);
  end.err = read_all(err);
  return end;
}

}  // namespace filmsticking::bench
