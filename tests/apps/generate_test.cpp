// What a killed `scanchor generate` leaves, and how the next one goes on.

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <map>
#include <thread>

#include "core/file.hpp"
#include "core/json.hpp"
#include "tests/apps/support/command.hpp"

namespace scanchor {
namespace {
namespace fs = std::filesystem;

using testing_support::run_scanchor;
using testing_support::scratch;

constexpr const char* six_scenes =
    "generate quick --scenes 6 --threads 1 --quiet --set lidar.lines=40";

/// Starts the command without waiting.
pid_t start(const std::string& arguments) {
  const pid_t child = fork();
  if (child == 0) {
    const std::string line = std::string("exec '") + SCANCHOR_COMMAND + "' " + arguments;
    if (chdir(scratch().c_str()) != 0) _exit(126);
    execl("/bin/sh", "sh", "-c", line.c_str(), nullptr);
    _exit(127);
  }
  return child;
}

std::map<std::string, std::string> hashes(const fs::path& root) {
  std::map<std::string, std::string> list;
  for (const auto& entry : fs::recursive_directory_iterator(root)) {
    if (entry.is_regular_file())
      list[fs::relative(entry.path(), root).string()] = sha256(read_file(entry.path()));
  }
  return list;
}

TEST(Generate, AKilledRunGoesOnToTheSameBytes) {
  ASSERT_EQ(run_scanchor(std::string(six_scenes) + " --out whole").code, 0);
  const auto whole = hashes(scratch() + "whole");
  ASSERT_TRUE(whole.contains("dataset.json"));
  // Killed in the middle of the second, the third, the fourth room.
  for (const char* room : {"01", "02", "03"}) {
    const fs::path set = scratch() + "killed";
    const pid_t child = start(std::string(six_scenes) + " --out killed");
    ASSERT_GT(child, 0);
    for (int i = 0; i < 20000 && !fs::exists(set / "sequences" / room); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    kill(child, SIGKILL);
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_FALSE(fs::exists(set / "dataset.json")) << "killed in time";
    // What bears its final name is whole.
    for (const auto& [name, hash] : hashes(set)) {
      if (name.find(".part-") != std::string::npos) continue;
      EXPECT_EQ(hash, whole.at(name)) << name << " after " << room;
    }
  }
  const auto ran = run_scanchor(std::string(six_scenes) + " --out killed --json");
  ASSERT_EQ(ran.code, 0) << ran.error;
  EXPECT_GE(Json::parse(ran.out).at("scenes_found"), 1);
  EXPECT_EQ(hashes(scratch() + "killed"), whole);
}

}  // namespace
}  // namespace scanchor
