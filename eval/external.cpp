#include "eval/external.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <thread>

#include "cloud/io.hpp"
#include "core/error.hpp"
#include "core/file.hpp"

namespace scanchor {
namespace {

namespace fs = std::filesystem;

std::string quoted(const fs::path& path) {
  std::string text = "'";
  for (const char c : path.string()) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

void replace_all(std::string& text, const std::string& what, const std::string& with) {
  for (std::size_t at = text.find(what); at != std::string::npos;
       at = text.find(what, at + with.size()))
    text.replace(at, what.size(), with);
}

std::string last_line(std::string text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == '\r' || text.back() == ' '))
    text.pop_back();
  const auto start = text.rfind('\n');
  text = start == std::string::npos ? text : text.substr(start + 1);
  return text.size() > 200 ? text.substr(0, 200) + "..." : text;
}

// A folder that is removed with the method that uses it.
struct OwnFolder {
  fs::path path;
  bool remove = false;
  std::atomic<int> next{0};
  ~OwnFolder() {
    std::error_code error;
    if (remove) fs::remove_all(path, error);
  }
};

}  // namespace

ProcessResult run_process(const std::string& command, double time_limit,
                          const fs::path& error_file) {
  ProcessResult result;
  const auto start = std::chrono::steady_clock::now();
  // Everything that allocates happens before the fork: the child may only call what is safe in a
  // threaded process.
  const std::string errors = error_file.string();
  const char* arguments[] = {"/bin/sh", "-c", command.c_str(), nullptr};
  const pid_t child = fork();
  if (child < 0) fail_data("", "", "cannot start a process: " + command);
  if (child == 0) {
    setpgid(0, 0);
    const int nothing = open("/dev/null", O_RDWR);
    const int log = open(errors.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    dup2(nothing, 0);
    dup2(nothing, 1);
    dup2(log >= 0 ? log : nothing, 2);
    execv("/bin/sh", const_cast<char* const*>(arguments));
    _exit(127);
  }
  setpgid(child, child);
  const auto seconds = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  int status = 0;
  auto pause = std::chrono::milliseconds(1);
  while (waitpid(child, &status, WNOHANG) == 0) {
    if (seconds() > time_limit) {
      result.timed_out = true;
      kill(-child, SIGKILL);
      waitpid(child, &status, 0);
      break;
    }
    std::this_thread::sleep_for(pause);
    pause = std::min(pause * 2, std::chrono::milliseconds(20));
  }
  kill(-child, SIGKILL);  // what it left running in the background
  result.seconds = seconds();
  result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  result.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  std::error_code error;
  if (fs::exists(error_file, error)) {
    result.error_output = read_file(error_file);
    if (result.error_output.size() > 4096)
      result.error_output.erase(0, result.error_output.size() - 4096);
  }
  return result;
}

Method external_method(const ExternalOptions& options) {
  for (const char* word : {"{scan}", "{out}"}) {
    if (options.command.find(word) == std::string::npos) {
      fail_usage("the pipeline's command does not say " + std::string(word),
                 "write --pipeline 'CMD {scan} {out}'");
    }
  }
  auto folder = std::make_shared<OwnFolder>();
  folder->remove = options.folder.empty();
  folder->path = options.folder;
  if (folder->remove) {
    std::string name = (fs::temp_directory_path() / "scanchor-pipeline-XXXXXX").string();
    if (!mkdtemp(name.data())) fail_data(name, "", "cannot make a folder");
    folder->path = name;
  } else {
    make_folder(folder->path);
  }
  Method method;
  method.name = options.command;
  method.answer = [options, folder](const Scan& scan, const std::string&) {
    const std::string stem = std::to_string(folder->next++);
    const fs::path input = folder->path / (stem + "." + options.scan_format);
    const fs::path output = folder->path / (stem + ".out." + options.out_format);
    const fs::path errors = folder->path / (stem + ".err");
    std::error_code ignored;
    fs::remove(output, ignored);
    write_cloud(input, scan.cloud);  // positions and intensity: the truth is no part of Scan::cloud
    std::string command = options.command;
    replace_all(command, "{scan}", quoted(input));
    replace_all(command, "{out}", quoted(output));
    const ProcessResult ended = run_process(command, options.time_limit, errors);
    const auto clean = [&] {
      if (!folder->remove) return;
      for (const auto& path : {input, output, errors}) fs::remove(path, ignored);
    };
    MethodAnswer answer;
    try {
      char limit[32];
      std::snprintf(limit, sizeof limit, "%g", options.time_limit);
      const std::string said = last_line(ended.error_output);
      const std::string why = said.empty() ? "" : ": " + said;
      if (ended.timed_out) fail_data("", "", std::string("killed after ") + limit + " s" + why);
      if (ended.signal != 0)
        fail_data("", "", "killed by signal " + std::to_string(ended.signal) + why);
      if (ended.exit_code != 0)
        fail_data("", "", "exit code " + std::to_string(ended.exit_code) + why);
      if (!fs::exists(output)) fail_data("", "", "left no file" + why);
      answer.points = read_prediction(output, scan.cloud, options.predictions);
    } catch (...) {
      clean();
      throw;
    }
    clean();
    answer.perceive_seconds = ended.seconds;
    return answer;
  };
  return method;
}

}  // namespace scanchor
