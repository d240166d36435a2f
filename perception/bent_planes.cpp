#include "perception/bent_planes.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "perception/thin_planes.hpp"

namespace scanchor {
namespace {

constexpr double least_cosine = 0.995;  // 0.1 rad
// Mean square of an error spread evenly within its bounds.
constexpr double systematic_variance = systematic_error * systematic_error / 3.0;

// Where two pieces touch: the points of either that lie in neighbouring leaves.
struct Contact {
  Moments a, b;
};
using Contacts = std::map<std::pair<std::int32_t, std::int32_t>, Contact>;

struct Share {
  std::int32_t label;
  Moments moments;
};

Contacts find_contacts(const CanonicalCloud& cloud, const CellTree& tree,
                       const PlaneLabels& labels) {
  std::vector<std::vector<Share>> shares(tree.cells.size());
  for (std::size_t i = 0; i < tree.cells.size(); ++i) {
    const Cell& cell = tree.cells[i];
    if (cell.children != 0) continue;
    for (auto p = cell.begin; p < cell.end; ++p) {
      const auto label = labels.of_point[p];
      if (label < 0) continue;
      auto at = std::find_if(shares[i].begin(), shares[i].end(),
                             [&](const Share& s) { return s.label == label; });
      if (at == shares[i].end()) at = shares[i].insert(at, Share{label, {}});
      at->moments.add(cloud.x[p], cloud.y[p], cloud.z[p]);
    }
  }
  Contacts contacts;
  const auto meet = [&](const std::vector<Share>& here, const std::vector<Share>& there) {
    for (const auto& h : here) {
      for (const auto& t : there) {
        if (h.label == t.label) continue;
        const auto& na = labels.planes[static_cast<std::size_t>(h.label)].plane.normal;
        const auto& nb = labels.planes[static_cast<std::size_t>(t.label)].plane.normal;
        if (std::abs(na.dot(nb)) < least_cosine) continue;
        const bool rising = h.label < t.label;
        auto& contact =
            contacts[rising ? std::pair(h.label, t.label) : std::pair(t.label, h.label)];
        (rising ? contact.a : contact.b).add(h.moments);
        (rising ? contact.b : contact.a).add(t.moments);
      }
    }
  };
  std::array<std::uint64_t, 26> codes;
  const auto never = [](std::uint32_t) { return false; };
  for (std::uint32_t i = 0; i < tree.cells.size(); ++i) {
    if (shares[i].empty()) continue;
    meet(shares[i], shares[i]);
    const int level = tree.cells[i].level;
    const int count = tree.neighbour_codes(cloud, i, codes);
    for (int k = 0; k < count; ++k) {
      const auto at = tree.find(codes[static_cast<std::size_t>(k)], level, never);
      if (at == CellTree::none || tree.cells[at].children != 0 || shares[at].empty()) continue;
      if (tree.cells[at].level < level || at > i)
        meet(shares[i], shares[at]);  // equal ones meet once
    }
  }
  return contacts;
}

// Height of b over a at the contact: each piece's points there against the other's plane, of which
// a tilt cancels.
double step(const GrownPlane& a, const GrownPlane& b, const Contact& contact) {
  const double side = a.plane.normal.dot(b.plane.normal) < 0.0 ? -1.0 : 1.0;
  return 0.5 *
         std::abs(a.plane.distance(contact.b.mean()) - side * b.plane.distance(contact.a.mean()));
}

}  // namespace

double estimate_flatness(const CellTree& tree, double sigma) {
  constexpr double fewest = 12.0, broad = 400.0, covered_least = 0.9;
  std::vector<std::pair<double, double>> seen;  // excess, points
  for (std::size_t i = 0; i < tree.cells.size(); ++i) {
    const Cell& cell = tree.cells[i];
    if (cell.children < 2 || cell.size() < 4 * fewest) continue;
    // Broad in both directions: twenty times the noise, where it has averaged out.
    const Eigen::Vector3d variances = plane_variances_fast(tree.moments[i]);
    if (variances[1] < broad * sigma * sigma || variances[1] < 9.0 * variances[0]) continue;
    const MomentPlane whole = fit_plane_fast(tree.moments[i]);
    double squares = 0.0, freedom = 0.0, covered = 0.0;
    bool even = true;
    for (std::uint32_t c = 0; c < cell.children && even; ++c) {
      const Moments& part = tree.moments[cell.child + c];
      if (part.n < fewest) continue;
      const MomentPlane plane = fit_plane_fast(part);
      const bool knows = plane.variances[1] > 9.0 * plane.variances[0];
      even = !knows || std::abs(plane.normal.dot(whole.normal)) > least_cosine;
      squares += part.n * plane.variances[0];
      freedom += part.n - 3.0;
      covered += part.n;
    }
    if (!even || covered < covered_least * cell.size()) continue;
    const double parts = squares / freedom;
    const double excess = whole.variances[0] * cell.size() / (cell.size() - 3.0) - parts;
    if (parts > 2.0 * sigma * sigma || excess > systematic_variance)
      continue;  // edges and steps, not bends
    seen.emplace_back(excess, static_cast<double>(cell.size()));
  }
  if (seen.empty()) return 0.0;
  std::sort(seen.begin(), seen.end());
  double total = 0.0, sum = 0.0;
  for (const auto& s : seen) total += s.second;
  for (const auto& s : seen) {
    sum += s.second;
    if (sum >= 0.5 * total) return std::sqrt(std::max(0.0, s.first));
  }
  return 0.0;
}

void join_bent_planes(const CanonicalCloud& cloud, const CellTree& tree, double sigma,
                      PlaneLabels& labels) {
  const Contacts contacts = find_contacts(cloud, tree, labels);
  struct Pair {
    std::int32_t a, b;
    double weight;
  };
  std::vector<Pair> pairs;
  for (const auto& [key, contact] : contacts) {
    const auto& pa = labels.planes[static_cast<std::size_t>(key.first)];
    const auto& pb = labels.planes[static_cast<std::size_t>(key.second)];
    if (step(pa, pb, contact) > sigma) continue;
    pairs.push_back({key.first, key.second, std::min(pa.moments.n, pb.moments.n)});
  }
  // The best known pieces first.
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const Pair& a, const Pair& b) { return a.weight > b.weight; });
  auto& planes = labels.planes;
  std::vector<std::int32_t> into(planes.size());
  std::iota(into.begin(), into.end(), 0);
  const auto root = [&](std::int32_t r) {
    while (into[static_cast<std::size_t>(r)] != r) r = into[static_cast<std::size_t>(r)];
    return r;
  };
  for (const auto& pair : pairs) {
    auto a = root(pair.a), b = root(pair.b);
    if (a == b) continue;
    if (planes[static_cast<std::size_t>(a)].moments.n <
        planes[static_cast<std::size_t>(b)].moments.n)
      std::swap(a, b);
    auto &pa = planes[static_cast<std::size_t>(a)], &pb = planes[static_cast<std::size_t>(b)];
    Moments both = pa.moments;
    both.add(pb.moments);
    GrownPlane common = grown_plane(both, sigma);
    const double most = sigma * sigma + systematic_variance;
    if (common.plane.mean_square(pa.moments) > most || common.plane.mean_square(pb.moments) > most)
      continue;
    if (std::abs(common.plane.normal.dot(pa.plane.normal)) < least_cosine) continue;
    if (std::abs(common.plane.normal.dot(pb.plane.normal)) < least_cosine) continue;
    pa = std::move(common);
    into[static_cast<std::size_t>(b)] = a;
  }
  for (auto& label : labels.of_point) {
    if (label >= 0) label = root(label);
  }
}

}  // namespace scanchor
