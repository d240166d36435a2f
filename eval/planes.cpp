#include "eval/planes.hpp"

#include <algorithm>
#include <cassert>
#include <tuple>

#include "eval/overlap.hpp"

namespace scanchor {
namespace {

// The overlaps of planes and regions that count, and their sizes within the points that count.
struct Table {
  std::vector<Overlap> cells;  // truth and region as indices below
  std::vector<std::int64_t> truth_points, region_points;
  std::vector<std::int32_t> truth_label, region_label;
};

double share(std::int64_t part, std::int64_t whole) {
  return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0.0;
}

std::int64_t pairs_of(std::int64_t n) { return n * (n - 1) / 2; }

Table make_table(std::span<const std::int32_t> truth, std::span<const char> ignored,
                 std::span<const std::int32_t> predicted, const Protocol& protocol) {
  const auto cells = overlap_table(truth, predicted);
  std::int32_t last = -1;
  for (const auto& cell : cells) last = std::max(last, cell.predicted);
  const auto regions = static_cast<std::size_t>(last + 1);
  std::vector<std::int64_t> inside(regions, 0);
  std::vector<std::int64_t> all(regions, 0);
  std::vector<std::int64_t> sizes(ignored.size(), 0);
  const auto counts = [&](std::int32_t t) {
    return t >= 0 && !ignored[static_cast<std::size_t>(t)];
  };
  for (const auto& cell : cells) {
    if (counts(cell.truth)) sizes[static_cast<std::size_t>(cell.truth)] += cell.points;
    if (cell.predicted < 0) continue;
    all[static_cast<std::size_t>(cell.predicted)] += cell.points;
    if (counts(cell.truth)) inside[static_cast<std::size_t>(cell.predicted)] += cell.points;
  }
  Table table;
  std::vector<std::int32_t> truth_index(ignored.size(), -1);
  std::vector<std::int32_t> region_index(regions, -1);
  for (std::size_t t = 0; t < ignored.size(); ++t) {
    if (ignored[t] || sizes[t] == 0) continue;
    truth_index[t] = static_cast<std::int32_t>(table.truth_label.size());
    table.truth_label.push_back(static_cast<std::int32_t>(t));
    table.truth_points.push_back(sizes[t]);
  }
  for (std::size_t r = 0; r < regions; ++r) {
    // Small ones, and those that lie mostly where nothing counts, are neither right nor wrong.
    if (all[r] < std::max(protocol.plane_min_points, 1) || 2 * inside[r] < all[r]) continue;
    region_index[r] = static_cast<std::int32_t>(table.region_label.size());
    table.region_label.push_back(static_cast<std::int32_t>(r));
    table.region_points.push_back(inside[r]);
  }
  for (const auto& cell : cells) {
    if (cell.predicted < 0 || !counts(cell.truth)) continue;
    const std::int32_t r = region_index[static_cast<std::size_t>(cell.predicted)];
    if (r >= 0)
      table.cells.push_back({truth_index[static_cast<std::size_t>(cell.truth)], r, cell.points});
  }
  return table;
}

// One finding of Hoover's: correct, over- or under-segmentation, with the average of its two
// measures.
struct Finding {
  HooverClass kind;
  double measure;
  std::vector<std::int32_t> truths, regions;
};

std::vector<Finding> findings_at(const Table& table, double tolerance) {
  std::vector<Finding> findings;
  struct Gathered {
    std::vector<std::int32_t> members;
    std::int64_t overlap = 0, sizes = 0;
  };
  std::vector<Gathered> pieces(table.truth_points.size());   // by truth: the regions that lie in it
  std::vector<Gathered> merged(table.region_points.size());  // by region: the truths that lie in it
  for (const auto& cell : table.cells) {
    const auto t = static_cast<std::size_t>(cell.truth);
    const auto r = static_cast<std::size_t>(cell.predicted);
    const double of_truth = share(cell.points, table.truth_points[t]);
    const double of_region = share(cell.points, table.region_points[r]);
    if (of_truth >= tolerance && of_region >= tolerance) {
      findings.push_back(
          {HooverClass::correct, 0.5 * (of_truth + of_region), {cell.truth}, {cell.predicted}});
    }
    if (of_region >= tolerance) {
      pieces[t].members.push_back(cell.predicted);
      pieces[t].overlap += cell.points;
      pieces[t].sizes += table.region_points[r];
    }
    if (of_truth >= tolerance) {
      merged[r].members.push_back(cell.truth);
      merged[r].overlap += cell.points;
      merged[r].sizes += table.truth_points[t];
    }
  }
  for (std::size_t t = 0; t < pieces.size(); ++t) {
    const auto& p = pieces[t];
    const double covered = share(p.overlap, table.truth_points[t]);
    if (p.members.size() < 2 || covered < tolerance) continue;
    findings.push_back({HooverClass::over,
                        0.5 * (covered + share(p.overlap, p.sizes)),
                        {static_cast<std::int32_t>(t)},
                        p.members});
  }
  for (std::size_t r = 0; r < merged.size(); ++r) {
    const auto& m = merged[r];
    const double covered = share(m.overlap, table.region_points[r]);
    if (m.members.size() < 2 || covered < tolerance) continue;
    findings.push_back({HooverClass::under,
                        0.5 * (covered + share(m.overlap, m.sizes)),
                        m.members,
                        {static_cast<std::int32_t>(r)}});
  }
  // Where several apply to one region, the one with the larger average holds (Hoover et al.,
  // section 4.1).
  std::stable_sort(findings.begin(), findings.end(), [](const Finding& a, const Finding& b) {
    return std::make_tuple(-a.measure, a.kind, a.truths[0], a.regions[0]) <
           std::make_tuple(-b.measure, b.kind, b.truths[0], b.regions[0]);
  });
  return findings;
}

HooverCounts classify(const Table& table, double tolerance, PlaneMatch* match) {
  std::vector<char> truth_taken(table.truth_points.size(), 0);
  std::vector<char> region_taken(table.region_points.size(), 0);
  HooverCounts counts;
  for (const Finding& finding : findings_at(table, tolerance)) {
    bool free = true;
    for (const auto t : finding.truths) free = free && !truth_taken[static_cast<std::size_t>(t)];
    for (const auto r : finding.regions) free = free && !region_taken[static_cast<std::size_t>(r)];
    if (!free) continue;
    for (const auto t : finding.truths) truth_taken[static_cast<std::size_t>(t)] = 1;
    for (const auto r : finding.regions) region_taken[static_cast<std::size_t>(r)] = 1;
    const auto truths = static_cast<std::int64_t>(finding.truths.size());
    const auto regions = static_cast<std::int64_t>(finding.regions.size());
    if (finding.kind == HooverClass::correct) ++counts.correct;
    if (finding.kind == HooverClass::over)
      counts.truth_over += truths, counts.regions_over += regions;
    if (finding.kind == HooverClass::under)
      counts.truth_under += truths, counts.regions_under += regions;
    if (!match) continue;
    for (const auto t : finding.truths)
      match->truth[static_cast<std::size_t>(table.truth_label[static_cast<std::size_t>(t)])] =
          finding.kind;
    for (const auto r : finding.regions)
      match->region[static_cast<std::size_t>(table.region_label[static_cast<std::size_t>(r)])] =
          finding.kind;
    if (finding.kind == HooverClass::correct) {
      match->region_of_truth[static_cast<std::size_t>(
          table.truth_label[static_cast<std::size_t>(finding.truths[0])])] =
          table.region_label[static_cast<std::size_t>(finding.regions[0])];
    }
  }
  counts.missed = std::count(truth_taken.begin(), truth_taken.end(), 0);
  counts.noise = std::count(region_taken.begin(), region_taken.end(), 0);
  return counts;
}

void pair_by_overlap(const Table& table, PlaneScore& score) {
  std::vector<Overlap> cells = table.cells;
  std::stable_sort(cells.begin(), cells.end(),
                   [](const Overlap& a, const Overlap& b) { return a.points > b.points; });
  std::vector<char> truth_taken(table.truth_points.size(), 0);
  std::vector<char> region_taken(table.region_points.size(), 0);
  for (const auto& cell : cells) {
    auto& t = truth_taken[static_cast<std::size_t>(cell.truth)];
    auto& r = region_taken[static_cast<std::size_t>(cell.predicted)];
    if (t || r) continue;
    t = r = 1;
    score.paired_points += cell.points;
  }
}

void count_pairs(const Table& table, PlaneScore& score) {
  // A point in no region is a region of its own: it is together with nothing.
  std::int64_t together = 0, in_truth = 0, in_region = 0;
  for (const auto& cell : table.cells) together += pairs_of(cell.points);
  for (const auto n : table.truth_points) in_truth += pairs_of(n);
  for (const auto n : table.region_points) in_region += pairs_of(n);
  score.pairs = pairs_of(score.truth_points);
  score.pairs_agree = score.pairs + 2 * together - in_truth - in_region;
  if (score.pairs == 0) return;
  const double expected = static_cast<double>(in_truth) * static_cast<double>(in_region) /
                          static_cast<double>(score.pairs);
  const double most = 0.5 * (static_cast<double>(in_truth) + static_cast<double>(in_region));
  score.adjusted_rand.add(
      most > expected ? (static_cast<double>(together) - expected) / (most - expected) : 1.0);
}

}  // namespace

PlaneScore score_planes(std::span<const std::int32_t> truth, std::span<const char> ignored,
                        std::span<const std::int32_t> predicted, const Protocol& protocol,
                        PlaneMatch* match) {
  const Table table = make_table(truth, ignored, predicted, protocol);
  PlaneScore score;
  score.scans = 1;
  score.truths = static_cast<std::int64_t>(table.truth_points.size());
  score.regions = static_cast<std::int64_t>(table.region_points.size());
  for (const auto n : table.truth_points) score.truth_points += n;
  for (const auto n : table.region_points) score.region_points += n;
  for (const double tolerance : protocol.plane_tolerances)
    score.hoover.push_back(classify(table, tolerance, nullptr));
  pair_by_overlap(table, score);
  std::vector<std::int64_t> best(table.truth_points.size(), 0);
  for (const auto& cell : table.cells)
    best[static_cast<std::size_t>(cell.truth)] =
        std::max(best[static_cast<std::size_t>(cell.truth)], cell.points);
  for (std::size_t t = 0; t < best.size(); ++t) {
    if (share(table.truth_points[t], static_cast<std::int64_t>(truth.size())) >=
        protocol.small_plane_share)
      continue;
    ++score.small_truths;
    score.small_recall.add(share(best[t], table.truth_points[t]));
  }
  count_pairs(table, score);
  if (match) {
    std::int32_t last = -1;
    for (const auto label : predicted) last = std::max(last, label);
    match->truth.assign(ignored.size(), HooverClass::ignored);
    match->region.assign(static_cast<std::size_t>(last + 1), HooverClass::ignored);
    match->region_of_truth.assign(ignored.size(), -1);
    for (const auto t : table.truth_label)
      match->truth[static_cast<std::size_t>(t)] = HooverClass::missed_or_noise;
    for (const auto r : table.region_label)
      match->region[static_cast<std::size_t>(r)] = HooverClass::missed_or_noise;
    classify(table, protocol.geometry_tolerance, match);
  }
  return score;
}

void HooverCounts::add(const HooverCounts& other) {
  correct += other.correct;
  truth_over += other.truth_over;
  regions_over += other.regions_over;
  truth_under += other.truth_under;
  regions_under += other.regions_under;
  missed += other.missed;
  noise += other.noise;
}

void PlaneScore::add(const PlaneScore& other) {
  if (hoover.size() < other.hoover.size()) hoover.resize(other.hoover.size());
  for (std::size_t i = 0; i < other.hoover.size(); ++i) hoover[i].add(other.hoover[i]);
  scans += other.scans;
  truths += other.truths;
  regions += other.regions;
  truth_points += other.truth_points;
  region_points += other.region_points;
  paired_points += other.paired_points;
  small_truths += other.small_truths;
  small_recall.add(other.small_recall);
  pairs += other.pairs;
  pairs_agree += other.pairs_agree;
  adjusted_rand.add(other.adjusted_rand);
}

double plane_precision(const PlaneScore& score, std::size_t tolerance) {
  return tolerance < score.hoover.size() ? share(score.hoover[tolerance].correct, score.regions)
                                         : 0.0;
}
double plane_recall(const PlaneScore& score, std::size_t tolerance) {
  return tolerance < score.hoover.size() ? share(score.hoover[tolerance].correct, score.truths)
                                         : 0.0;
}
double plane_f1(const PlaneScore& score, std::size_t tolerance) {
  return tolerance < score.hoover.size()
             ? share(2 * score.hoover[tolerance].correct, score.regions + score.truths)
             : 0.0;
}
double adjusted_precision(const PlaneScore& score) {
  return share(score.paired_points, score.region_points);
}
double adjusted_recall(const PlaneScore& score) {
  return share(score.paired_points, score.truth_points);
}
double small_plane_recall(const PlaneScore& score) {
  return score.small_truths > 0
             ? score.small_recall.value() / static_cast<double>(score.small_truths)
             : 0.0;
}
double rand_index(const PlaneScore& score) { return share(score.pairs_agree, score.pairs); }
double adjusted_rand_index(const PlaneScore& score) {
  return score.scans > 0 ? score.adjusted_rand.value() / static_cast<double>(score.scans) : 0.0;
}

}  // namespace scanchor
