#include <fmt/format.h>

#include "core/json.hpp"
#include "core/markup.hpp"
#include "eval/gate.hpp"

namespace scanchor {
namespace {

std::string points(double value) { return fmt::format("{:+.2f}", 100 * value); }

std::string sentence(const GateMetric& m) {
  return fmt::format("{}: {:.2f} -> {:.2f}, {} points [{} .. {}], p = {:.4f}: {}", m.name,
                     100 * m.before, 100 * m.after, points(m.difference()), points(m.change.low),
                     points(m.change.high), m.p_adjusted, verdict_word(m.verdict));
}

Json metric_out(const GateMetric& m, bool verdict) {
  Json json = Json::object();
  json["name"] = m.name;
  json["before"] = m.before;
  json["after"] = m.after;
  json["difference"] = m.difference();
  json["low"] = m.change.low;
  json["high"] = m.change.high;
  json["p"] = m.p;
  if (!verdict) return json;
  json["p_adjusted"] = m.p_adjusted;
  json["verdict"] = verdict_word(m.verdict);
  return json;
}

}  // namespace

Json gate_to_json(const GateReport& report) {
  Json json = Json::object();
  json["format"] = "scanchor-gate";
  json["schema"] = 1;
  json["verdict"] = verdict_word(report.verdict);
  json["confidence"] = report.confidence;
  json["exit_code"] = static_cast<int>(report.exit_code(false));
  json["suite"] = report.suite;
  json["data"] = report.data;
  json["protocol"] = report.protocol;
  json["before"] = report.before_method;
  json["after"] = report.after_method;
  json["scenes"] = report.scenes;
  json["next"] = report.next;
  json["newly_failed"] = report.newly_failed;
  Json gated = Json::array();
  for (const auto& metric : report.gated) gated.push_back(metric_out(metric, true));
  json["metrics"] = std::move(gated);
  Json classes = Json::array();
  for (const auto& metric : report.classes) classes.push_back(metric_out(metric, false));
  json["classes"] = std::move(classes);
  Json worst = Json::array();
  for (const auto& scene : report.worst) {
    Json one = Json::object();
    one["index"] = scene.index;
    one["name"] = scene.name;
    one["family"] = scene.family;
    one["seed"] = scene.seed;
    one["difference"] = scene.difference;
    worst.push_back(std::move(one));
  }
  json["worst_scenes"] = std::move(worst);
  return json;
}

Json gate_to_bencher(const GateReport& report) {
  Json measures = Json::object();
  for (const auto& metric : report.gated) {
    Json value = Json::object();
    value["value"] = metric.after;
    value["lower_value"] = metric.before + metric.change.low;
    value["upper_value"] = metric.before + metric.change.high;
    measures[metric.name] = std::move(value);
  }
  Json json = Json::object();
  json["scanchor/" + report.suite] = std::move(measures);
  return json;
}

std::string gate_to_text(const GateReport& report) {
  std::string text = fmt::format("{} over {} scenes of {}\n", verdict_word(report.verdict),
                                 report.scenes, report.data);
  text += fmt::format("  {:<16} {:>6} {:>6} {:>7} {:>16} {:>6} {}\n", "metric", "before", "after",
                      "change", fmt::format("{:.4g} % interval", 100 * report.confidence), "p",
                      "verdict");
  for (const auto& m : report.gated) {
    text += fmt::format("  {:<16} {:>6.2f} {:>6.2f} {:>7} {:>16} {:>6.4f} {}\n", m.name,
                        100 * m.before, 100 * m.after, points(m.difference()),
                        fmt::format("{} .. {}", points(m.change.low), points(m.change.high)),
                        m.p_adjusted, verdict_word(m.verdict));
  }
  for (const auto& line : report.newly_failed) text += "  no answer any more: " + line + "\n";
  for (const auto& metric : report.classes) {
    if (metric.difference() < 0 && report.verdict != Verdict::not_worse) {
      text += fmt::format("  class {}: {} points [{} .. {}]\n", metric.name.substr(11),
                          points(metric.difference()), points(metric.change.low),
                          points(metric.change.high));
    }
  }
  for (const auto& scene : report.worst) {
    text += fmt::format("  scene {} ({}, index {}): {} points\n", scene.name, scene.family,
                        scene.index, points(scene.difference));
  }
  if (!report.next.empty()) text += "  " + report.next + "\n";
  return text;
}

std::string gate_to_markdown(const GateReport& report) {
  std::string text =
      fmt::format("### {}: {} ({} scenes)\n\n`{}`, protocol `{}`, `{}` against `{}`\n\n",
                  report.suite, verdict_word(report.verdict), report.scenes, report.data,
                  report.protocol, report.after_method, report.before_method);
  text +=
      "| metric | before | after | change | interval | p | verdict |\n| --- | ---: | ---: | ---: | "
      "---: | ---: | --- |\n";
  for (const auto& m : report.gated) {
    text += fmt::format("| {} | {:.2f} | {:.2f} | {} | {} .. {} | {:.4f} | {} |\n", m.name,
                        100 * m.before, 100 * m.after, points(m.difference()), points(m.change.low),
                        points(m.change.high), m.p_adjusted, verdict_word(m.verdict));
  }
  if (!report.classes.empty()) {
    text +=
        "\n| class (F1, for information) | before | after | change | interval |\n| --- | ---: | "
        "---: | ---: | ---: |\n";
    for (const auto& m : report.classes) {
      text += fmt::format("| {} | {:.2f} | {:.2f} | {} | {} .. {} |\n", m.name.substr(11),
                          100 * m.before, 100 * m.after, points(m.difference()),
                          points(m.change.low), points(m.change.high));
    }
  }
  for (const auto& line : report.newly_failed) text += "\n* no answer any more: " + line;
  if (!report.worst.empty()) text += "\nLargest drops:";
  for (const auto& scene : report.worst)
    text += fmt::format(" scene {} ({}, {})", scene.name, scene.family, points(scene.difference));
  return text + "\n";
}

std::string gate_to_junit(const GateReport& report) {
  int failures = report.newly_failed.empty() ? 0 : 1;
  int skipped = 0;
  std::string cases;
  for (const auto& metric : report.gated) {
    cases += fmt::format("    <testcase classname=\"scanchor.{}\" name=\"{}\">",
                         escape_markup(report.suite), escape_markup(metric.name));
    if (metric.verdict == Verdict::regressed) {
      ++failures;
      cases += fmt::format("<failure message=\"{}\"/>", escape_markup(sentence(metric)));
    } else if (metric.verdict == Verdict::inconclusive) {
      ++skipped;
      cases += fmt::format("<skipped message=\"{}\"/>", escape_markup(sentence(metric)));
    } else {
      cases += fmt::format("<system-out>{}</system-out>", escape_markup(sentence(metric)));
    }
    cases += "</testcase>\n";
  }
  cases += fmt::format("    <testcase classname=\"scanchor.{}\" name=\"every scan has an answer\">",
                       escape_markup(report.suite));
  if (!report.newly_failed.empty()) {
    std::string list;
    for (const auto& line : report.newly_failed) list += line + "\n";
    cases += fmt::format("<failure message=\"{} scans have no answer any more\">{}</failure>",
                         report.newly_failed.size(), escape_markup(list));
  }
  cases += "</testcase>\n";
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n  <testsuite name=\"scanchor "
      "check {}\" tests=\"{}\" "
      "failures=\"{}\" skipped=\"{}\">\n{}  </testsuite>\n</testsuites>\n",
      escape_markup(report.suite), report.gated.size() + 1, failures, skipped, cases);
}

}  // namespace scanchor
