// How far a class can be believed that nobody has counted: each class is taken out of the counted
// ones and described anew by its required clauses alone, as a user would, and held against rooms
// that were not used to count anything.
//   new_class_bench [ONTOLOGY [ROOMS [SEED]]]     default office, 40 rooms from seed 300

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>
#include <string>

#include "core/data_folder.hpp"
#include "core/parallel.hpp"
#include "eval/run.hpp"
#include "perception/perceive.hpp"
#include "reasoning/background.hpp"
#include "reasoning/matcher.hpp"
#include "reasoning/new_classes.hpp"
#include "scenes/classes.hpp"

namespace scanchor {
namespace {

namespace fs = std::filesystem;

struct Room {
  ReferenceRoom seen;
  std::vector<std::int64_t> thing;  ///< true instance of each surface; -1: none
};

Room make_room(const SceneTask& task) {
  const MadeScene made = make_scene(task, 1);
  const Scan& scan = made.scans.front();
  TrainingScene scene;
  scene.surfaces = perceive(scan.cloud, PerceiveOptions{});
  Room room;
  for (const auto& surface : scene.surfaces.surfaces) {
    std::map<std::pair<ClassId, std::int64_t>, std::size_t> votes;
    for (const auto point : surface.inliers) {
      const auto p = static_cast<std::size_t>(point);
      ++votes[{scan.truth.class_id[p], scan.truth.instance[p]}];
    }
    std::string name;
    std::int64_t thing = -1;
    for (const auto& [what, count] : votes) {
      if (5 * count <= 3 * surface.inliers.size() || what.first == unlabelled) continue;
      name = class_info(what.first).name;
      thing = what.second;
    }
    scene.classes.push_back(name);
    room.thing.push_back(thing);
  }
  room.seen = make_reference_room(scene, ReasonOptions{});
  return room;
}

/// As if nobody had counted the class, nor ever said more of it than has to be: no context, no
/// parts.
Ontology without(const Ontology& counted, const std::string& name) {
  Ontology ontology = counted;
  std::set<std::string> gone;
  for (std::size_t c = 0; c < ontology.classes.size(); ++c) {
    auto& described = ontology.classes[c];
    if (described.part_of == name && !only_a_member(counted, static_cast<int>(c)))
      gone.insert(described.name());
  }
  for (auto& described : ontology.classes) {
    if (described.name() == name) {
      described.prior = -1.0;
      std::erase_if(described.clauses, [](const Clause& c) { return c.usually; });
      for (auto& clause : described.clauses)
        clause.hit_rate = clause.background = -1.0, clause.counted_weight = 1.0;
    }
    std::erase_if(described.clauses, [&](const Clause& c) { return gone.count(c.target) > 0; });
  }
  std::erase_if(ontology.classes,
                [&](const ClassDescription& c) { return gone.count(c.name()) > 0; });
  return ontology;
}

/// As if nothing of the class had ever been there.
std::vector<ReferenceRoom> rooms_without(std::vector<ReferenceRoom> rooms,
                                         const std::string& name) {
  for (auto& room : rooms) {
    ReferenceRoom kept;
    for (std::size_t i = 0; i < room.items.size(); ++i) {
      if (room.classes[i] == name) continue;
      kept.classes.push_back(room.classes[i]);
      kept.items.push_back(room.items[i]);
      kept.items.back().id = static_cast<std::int32_t>(kept.items.size()) - 1;
    }
    room.items = std::move(kept.items);
    room.classes = std::move(kept.classes);
  }
  return rooms;
}

struct Bin {
  double sum = 0.0, right = 0.0, number = 0.0;
};

struct Tally {
  int claims = 0, right = 0;
  int things = 0, found = 0;
  std::vector<Bin> bins = std::vector<Bin>(10);
  void add(double p, bool truth) {
    auto& bin = bins[std::min<std::size_t>(9, static_cast<std::size_t>(p * 10.0))];
    bin.sum += p, bin.right += truth ? 1.0 : 0.0, bin.number += 1.0;
  }
  void add(const Tally& other) {
    claims += other.claims, right += other.right, things += other.things, found += other.found;
    for (std::size_t i = 0; i < bins.size(); ++i) {
      bins[i].sum += other.bins[i].sum;
      bins[i].right += other.bins[i].right;
      bins[i].number += other.bins[i].number;
    }
  }
  [[nodiscard]] double error() const {
    double all = 0.0, off = 0.0;
    for (const auto& bin : bins) all += bin.number, off += std::abs(bin.sum - bin.right);
    return all > 0.0 ? off / all : 0.0;
  }
};

/// Probabilities of the class on each item of a room, as labels have them.
Tally hold(const Ontology& ontology, int c, const Room& room, const std::string& name) {
  Matcher matcher(ontology, room.seen.items, room.seen.around);
  matcher.run();
  std::vector<double> all(matcher.items().size(), unknown_prior_of(ontology)), own(all.size(), 0.0);
  for (std::size_t k = 0; k < ontology.classes.size(); ++k) {
    if (only_a_member(ontology, static_cast<int>(k))) continue;
    const bool same = static_cast<int>(k) == c || ontology.classes[k].part_of == name;
    for (const auto& candidate : matcher.candidates(static_cast<int>(k))) {
      all[static_cast<std::size_t>(candidate.item)] += std::exp(candidate.score);
      if (same) own[static_cast<std::size_t>(candidate.item)] += std::exp(candidate.score);
    }
  }
  Tally tally;
  std::set<std::int64_t> things, found;
  for (std::size_t i = 0; i < room.thing.size(); ++i) {
    if (room.seen.classes[i] == name) things.insert(room.thing[i]);
  }
  for (const auto& item : matcher.items()) {
    const auto i = static_cast<std::size_t>(item.id);
    const double p = own[i] / all[i];
    double area = 0.0, right = 0.0;
    std::set<std::int64_t> ours;
    const std::vector<std::int32_t> faces =
        item.group ? item.members : std::vector<std::int32_t>{item.id};
    for (const auto f : faces) {
      const auto k = static_cast<std::size_t>(f);
      area += item.group ? matcher.items()[k].area.value : 1.0;
      if (room.seen.classes[k] != name) continue;
      right += item.group ? matcher.items()[k].area.value : 1.0;
      ours.insert(room.thing[k]);
    }
    const bool truth = 2.0 * right > area;
    if (p >= 0.05) tally.add(p, truth);
    if (p < 0.5) continue;
    ++tally.claims;
    tally.right += truth ? 1 : 0;
    if (truth) found.insert(ours.begin(), ours.end());
  }
  tally.things = static_cast<int>(things.size());
  tally.found = static_cast<int>(found.size());
  return tally;
}

Tally hold_all(const Ontology& ontology, const std::vector<Room>& rooms, const std::string& name) {
  Tally all;
  const int c = ontology.find(name);
  for (const auto& room : rooms) all.add(hold(ontology, c, room, name));
  return all;
}

std::string row(const Tally& t) {
  return fmt::format("{:>4} {:>4} {:>5.2f} {:>5.2f} {:>6.3f}", t.claims, t.right,
                     t.claims > 0 ? static_cast<double>(t.right) / t.claims : 0.0,
                     t.things > 0 ? static_cast<double>(t.found) / t.things : 0.0, t.error());
}

int run(const std::string& name, int count, std::uint64_t seed) {
  const fs::path file = find_data_file("ontologies", name, ".sdl");
  const Ontology counted = read_ontology(file);
  auto reference = read_reference_rooms(fs::path(file).replace_extension(".rooms.json"));
  Suite suite = read_suite(
      find_data_file("suites", name == "office" ? "work-training" : name + "-training", ".yaml"));
  suite.seed = seed;
  suite.scenes = count;
  const auto tasks = scene_tasks(suite);
  std::vector<Room> rooms(tasks.size());
  parallel_blocks(tasks.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) rooms[i] = make_room(tasks[i]);
  });
  fmt::print("{} rooms, seed {}; claims, right, precision, recall, calibration error\n", count,
             seed);
  fmt::print("{:<18}{:>10}  {:<28}  {:<28}  {:<28}  {:<28}\n", "class", "things", "counted",
             "new, by kinds of clauses", "new, in the rooms", "new, not in the rooms");
  Tally all[4];
  double mean[4] = {}, classes = 0.0;
  for (const auto& described : counted.classes) {
    const std::string& own = described.name();
    if (!described.part_of.empty() || described.prior < 0.0) continue;
    const Tally before = hold_all(counted, rooms, own);
    if (before.things < 3) continue;
    Ontology fresh = without(counted, own);
    fill_uncounted(fresh);
    const Tally filled = hold_all(fresh, rooms, own);
    auto nameless = reference;  // nobody knows what a new class's things are in the reference rooms
    for (auto& room : nameless) {
      for (auto& c : room.classes) {
        if (c == own) c = "not described";
      }
    }
    weigh_new_classes(fresh, {fresh.find(own)}, nameless);
    const Tally weighed = hold_all(fresh, rooms, own);
    Ontology absent = without(counted, own);
    fill_uncounted(absent);
    weigh_new_classes(absent, {absent.find(own)}, rooms_without(reference, own));
    const Tally alone = hold_all(absent, rooms, own);
    fmt::print("{:<18}{:>10}  {:<28}  {:<28}  {:<28}  {:<28}\n", own, before.things, row(before),
               row(filled), row(weighed), row(alone));
    std::fflush(stdout);
    mean[0] += before.error(), mean[1] += filled.error(), mean[2] += weighed.error(),
        mean[3] += alone.error(), classes += 1.0;
    all[0].add(before), all[1].add(filled), all[2].add(weighed), all[3].add(alone);
  }
  fmt::print("mean of errors of classes: {:.3f} {:.3f} {:.3f} {:.3f}\n", mean[0] / classes,
             mean[1] / classes, mean[2] / classes, mean[3] / classes);
  fmt::print("{:<18}{:>10}  {:<28}  {:<28}  {:<28}  {:<28}\n", "all", all[0].things, row(all[0]),
             row(all[1]), row(all[2]), row(all[3]));
  for (const auto& tally : all) {
    for (const auto& bin : tally.bins) {
      if (bin.number > 0.0)
        fmt::print("  {:.2f}:{:.2f} ({:.0f})", bin.sum / bin.number, bin.right / bin.number,
                   bin.number);
    }
    fmt::print("\n");
  }
  return 0;
}

}  // namespace
}  // namespace scanchor

int main(int argc, char** argv) {
  const std::string name = argc > 1 ? argv[1] : "office";
  const int rooms = argc > 2 ? std::atoi(argv[2]) : 40;
  const std::uint64_t seed = argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 300;
  return scanchor::run(name, rooms, seed);
}
