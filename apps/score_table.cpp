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

void print_score(const Common& common, const Score& score, const Protocol& protocol) {
  say(common, fmt::format("{} scans under {}", score.scans, protocol_stamp(protocol)));
  for (const auto& [name, value] : metrics(score, protocol)) {
    if (name.find('.') == name.rfind('.'))
      say(common, fmt::format("  {:<28} {}", name, fraction_text(value)));
  }
  say(common, "");
  print_objects(common, score.objects);
  for (const auto& failed : score.failed) say(common, "no answer: " + failed);
}

}  // namespace scanchor::apps
