#include "apps/score_table.hpp"

#include <fmt/format.h>

#include "results/table.hpp"
#include "scenes/classes.hpp"

namespace scanchor::apps {
namespace {

void add_counts(Table& table, const std::string& name, const ObjectCounts& counts) {
  const auto share = [](bool known, double value) {
    return TableCell(known ? fraction_text(value, 2) : "-",
                     known ? tone_of(value, 0.9, 0.7) : CellTone::faint);
  };
  table.add_row({name, std::to_string(counts.truths), std::to_string(counts.found),
                 std::to_string(counts.missed()), std::to_string(counts.wrong + counts.repeated),
                 share(counts.claims() > 0, counts.precision()),
                 share(counts.truths > 0, counts.recall())});
}

}  // namespace

void print_objects(const Common& common, const ObjectScore& score) {
  Table table({"class", "there", "found", "missed", "wrong", "precision", "recall"});
  for (std::size_t id = 0; id < score.classes.size(); ++id) {
    const ObjectCounts& counts = score.classes[id];
    if (counts.truths + counts.claims() > 0)
      add_counts(table, std::string(class_info(static_cast<ClassId>(id)).name), counts);
  }
  table.add_rule();
  add_counts(table, "all", score.total());
  say(common, table.to_text({terminal_width(stdout), wants_color(stdout), 0}));
  if (score.ignored > 0)
    say(common, fmt::format("{} things could hardly be seen and do not count.", score.ignored));
  if (score.not_described > 0)
    say(common, fmt::format("{} things are of classes that the method has no word for.",
                            score.not_described));
}

void print_relations(const Common& common, const RelationScore& score) {
  if (score.clear.empty()) return;
  Table table(
      {"relation", "right", "wrong", "missed", "prec.", "recall", "border", "prec.", "recall"});
  const auto share = [](std::int64_t whole, double value) {
    return whole > 0 ? TableCell(fraction_text(value, 2), tone_of(value, 0.9, 0.7))
                     : TableCell("-", CellTone::faint);
  };
  const auto add = [&](const std::string& name, const RelationCounts& clear,
                       const RelationCounts& near) {
    table.add_row({name, std::to_string(clear.right), std::to_string(clear.wrong),
                   std::to_string(clear.missed),
                   share(clear.right + clear.wrong, clear.precision()),
                   share(clear.right + clear.missed, clear.recall()),
                   std::to_string(near.right + near.wrong + near.missed),
                   share(near.right + near.wrong, near.precision()),
                   share(near.right + near.missed, near.recall())});
  };
  RelationCounts clear_sum, near_sum;
  for (const auto& [name, clear] : score.clear) {
    const auto found = score.borderline.find(name);
    const RelationCounts near = found == score.borderline.end() ? RelationCounts{} : found->second;
    clear_sum.add(clear);
    near_sum.add(near);
    add(name, clear, near);
  }
  table.add_rule();
  add("all", clear_sum, near_sum);
  say(common,
      "\nRelations between planes that were found (border: truth within a fifth of the limit):");
  say(common, table.to_text({terminal_width(stdout), wants_color(stdout), 0}));
}

void print_score(const Common& common, const Score& score, const Protocol& protocol) {
  say(common, fmt::format("{} scans under {}", score.scans, protocol_stamp(protocol)));
  for (const auto& [name, value] : metrics(score, protocol)) {
    if (name.find('.') == name.rfind('.'))
      say(common, fmt::format("  {:<28} {}", name, fraction_text(value)));
  }
  say(common, "");
  print_objects(common, score.objects);
  print_relations(common, score.relations);
  for (const auto& failed : score.failed) say(common, "no answer: " + failed);
}

void print_methods(const Common& common, const std::vector<MethodScore>& methods,
                   const Protocol& protocol) {
  const Score& first = methods.front().score;
  say(common, fmt::format("{} scans under {}", first.scans, protocol_stamp(protocol)));
  Table table({"method", "prec.", "recall", "f1", "pq", "miou", "planes f1", "ece", "ms/scan"});
  for (const auto& method : methods) {
    const auto of = [&](const char* name) {
      return fraction_text(metric(method.score, protocol, name));
    };
    const auto scans = static_cast<double>(std::max<std::int64_t>(method.score.scans, 1));
    table.add_row({method.name.substr(0, method.name.find('/')), of("objects.precision"),
                   of("objects.recall"), of("objects.f1"), of("panoptic.pq"), of("points.miou"),
                   of("planes.f1@0.80"), of("labels.ece"),
                   method.seconds > 0 ? fmt::format("{:.0f}", 1e3 * method.seconds / scans) : "-"});
    if (!method.score.failed.empty())
      say(common, fmt::format("{}: {} scans without an answer, first {}", method.name,
                              method.score.failed.size(), method.score.failed.front()));
  }
  say(common, table.to_text({terminal_width(stdout), wants_color(stdout), 0}));
}

}  // namespace scanchor::apps
