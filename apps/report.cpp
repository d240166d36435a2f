// scanchor report and scanchor figures: what a person opens, and what goes into a paper.

#include <fmt/format.h>

#include <filesystem>

#include "apps/command.hpp"
#include "core/file.hpp"
#include "core/progress.hpp"
#include "results/figures.hpp"
#include "results/report.hpp"

namespace scanchor::apps {
namespace fs = std::filesystem;
namespace {

struct ReportArguments {
  Common common;
  std::string run;
  std::string out;
  std::string baseline;
  std::vector<std::string> sweeps;
  ReportOptions options;
};

int report(ReportArguments& arguments) {
  const fs::path html =
      arguments.out.empty() ? fs::path(arguments.run) / "report.html" : fs::path(arguments.out);
  arguments.options.baseline = arguments.baseline;
  arguments.options.sweeps.assign(arguments.sweeps.begin(), arguments.sweeps.end());
  {
    Progress progress("rooms", 0, {.quiet = arguments.common.quiet || arguments.common.json});
    arguments.options.progress = [&](std::size_t done, std::size_t total) {
      progress.update(done, total);
    };
    write_report(arguments.run, html, arguments.options);
  }
  answer(arguments.common, Json{{"report", html.string()}});
  say(arguments.common, "report: " + html.string());
  return 0;
}

struct FigureArguments {
  Common common;
  std::string out = "figures";
};

int figures(const FigureArguments& arguments) {
  make_folder(arguments.out);
  Json json = Json::array();
  for (const auto& file : write_figures(arguments.out)) {
    json.push_back(file.string());
    say(arguments.common, file.string());
  }
  answer(arguments.common, json);
  return 0;
}

}  // namespace

void add_report(CLI::App& root, ExitCodeSlot& code) {
  auto* verb = root.add_subcommand("report", "One HTML file of a run that opens without a network");
  verb->footer(
      "Examples:\n  scanchor report demo --out report.html\n"
      "  scanchor report demo --sweep noise --baseline yesterday");
  auto arguments = std::make_shared<ReportArguments>();
  verb->add_option("run", arguments->run, "The folder that run wrote")
      ->required()
      ->type_name("RUN");
  verb->add_option("--out", arguments->out, "The page; default RUN/report.html")->type_name("FILE");
  verb->add_option("--baseline", arguments->baseline, "Another run to compare with")
      ->type_name("DIR");
  verb->add_option("--sweep", arguments->sweeps,
                   "The folder of a sweep, shown as curves (repeatable)")
      ->type_name("DIR")
      ->expected(1)
      ->take_all();
  verb->add_option("--title", arguments->options.title, "Title of the page");
  add_common(*verb, arguments->common, false);
  verb->callback([arguments, &code] { code = report(*arguments); });
}

void add_figures(CLI::App& root, ExitCodeSlot& code) {
  auto* verb = root.add_subcommand("figures", "The paper's figures, remade from simulated scans");
  verb->footer("Example:\n  scanchor figures --out figures");
  auto arguments = std::make_shared<FigureArguments>();
  verb->add_option("--out", arguments->out, "Folder")->type_name("DIR")->capture_default_str();
  add_common(*verb, arguments->common, false);
  verb->callback([arguments, &code] { code = figures(*arguments); });
}

}  // namespace scanchor::apps
