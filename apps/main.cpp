// The scanchor command: reads the words, calls one verb, turns an Error into one line and its exit
// code.

#include <fmt/format.h>

#include <csignal>
#include <cstdio>

#include "apps/command.hpp"

namespace {

extern "C" void on_interrupt(int) { scanchor::apps::interrupted = true; }

/// CLI11's messages are sentences already; the exit code is ours.
int usage_error(const CLI::App& app, const CLI::ParseError& error) {
  if (error.get_exit_code() == 0) return app.exit(error);  // --help, --version
  std::string verb = app.get_name();
  for (auto verbs = app.get_subcommands(); !verbs.empty(); verbs = verbs.front()->get_subcommands())
    verb += " " + verbs.front()->get_name();
  fmt::print(stderr, "scanchor: {}; see {} --help\n", error.what(), verb);
  return static_cast<int>(scanchor::ExitCode::wrong_usage);
}

}  // namespace

int main(int argc, char** argv) {
  using namespace scanchor;
  std::signal(SIGINT, on_interrupt);
  std::signal(SIGTERM, on_interrupt);

  CLI::App root(
      "Scanchor: simulated tilting-LIDAR scans of indoor rooms, described classes, scored answers.",
      "scanchor");
  root.set_version_flag("--version,-V", "scanchor " SCANCHOR_VERSION);
  root.require_subcommand(1);
  root.footer(
      "Each verb has its own help with an example: scanchor run --help\n"
      "Exit codes: 0 done, 1 a gate failed, 2 wrong usage, 3 bad or mismatching data, 4 nothing "
      "measured, 5 inconclusive.");
  int code = 0;
  apps::add_all_verbs(root, code);
  try {
    root.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return usage_error(root, error);
  } catch (const Error& error) {
    fmt::print(stderr, "scanchor: {}\n", error.what());
    return static_cast<int>(error.code());
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "scanchor: not enough memory for this input\n");
    return static_cast<int>(ExitCode::bad_data);
  } catch (const std::exception& error) {
    fmt::print(stderr,
               "scanchor: internal error: {}; please report it with the command that led to it\n",
               error.what());
    return 70;  // EX_SOFTWARE: never one of the documented codes
  }
  return code;
}
