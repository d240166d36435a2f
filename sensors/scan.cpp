#include "sensors/scan.hpp"

#include <algorithm>

#include "core/error.hpp"

namespace scanchor {
namespace {

template <class Number>
void read_column(const PointCloud& cloud, const char* name, std::vector<Number>& column) {
  const Field* field = cloud.find(name);
  if (field == nullptr) return;
  for (std::size_t i = 0; i < column.size(); ++i) column[i] = static_cast<Number>(field->at(i));
}

}  // namespace

void PointTruth::resize(std::size_t count) {
  class_id.resize(count, 0);
  instance.resize(count, -1);
  part.resize(count, -1);
  face.resize(count, -1);
  runner_up.resize(count, -1);
  flags.resize(count, 0);
  true_range.resize(count, 0.0F);
  incidence.resize(count, 0.0F);
}

PointCloud cloud_with_truth(const Scan& scan) {
  PointCloud cloud = scan.cloud;
  if (scan.truth.size() != cloud.size()) {
    fail_data("scan", "", "truth and points differ in number");
  }
  // Unsigned, as PCL's PointXYZL wants it: of another type it finds no label at all.
  std::vector<std::uint32_t> label(scan.truth.size());
  for (std::size_t i = 0; i < label.size(); ++i)
    label[i] = static_cast<std::uint32_t>(std::max(0, scan.truth.class_id[i]));
  cloud.set({"label", std::move(label)});
  cloud.set({"instance", scan.truth.instance});
  cloud.set({"part", scan.truth.part});
  cloud.set({"face", scan.truth.face});
  cloud.set({"runner_up", scan.truth.runner_up});
  cloud.set({"flags", scan.truth.flags});
  cloud.set({"true_range", scan.truth.true_range});
  cloud.set({"incidence", scan.truth.incidence});
  if (scan.line.size() == cloud.size()) cloud.set({"line", scan.line});
  if (scan.beam.size() == cloud.size()) cloud.set({"beam", scan.beam});
  return cloud;
}

Scan scan_from_cloud(const PointCloud& cloud) {
  Scan scan;
  scan.cloud = cloud;
  scan.cloud.fields.clear();
  for (const Field& field : cloud.fields) {
    bool truth = false;
    for (const char* name : {"label", "instance", "part", "face", "runner_up", "flags",
                             "true_range", "incidence", "line", "beam"}) {
      truth = truth || field.name == name;
    }
    if (!truth) scan.cloud.set(field);
  }
  scan.truth.resize(cloud.size());
  read_column(cloud, "label", scan.truth.class_id);
  read_column(cloud, "instance", scan.truth.instance);
  read_column(cloud, "part", scan.truth.part);
  read_column(cloud, "face", scan.truth.face);
  read_column(cloud, "runner_up", scan.truth.runner_up);
  read_column(cloud, "flags", scan.truth.flags);
  read_column(cloud, "true_range", scan.truth.true_range);
  read_column(cloud, "incidence", scan.truth.incidence);
  scan.line.assign(cloud.size(), -1);
  scan.beam.assign(cloud.size(), -1);
  read_column(cloud, "line", scan.line);
  read_column(cloud, "beam", scan.beam);
  scan.beams_fired = cloud.size();
  return scan;
}

}  // namespace scanchor
