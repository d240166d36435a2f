#include "cloud/point_cloud.hpp"

#include <cassert>

namespace scanchor {

std::size_t Field::size() const {
  return std::visit([](const auto& column) { return column.size(); }, values);
}

double Field::at(std::size_t i) const {
  return std::visit([i](const auto& column) { return static_cast<double>(column[i]); }, values);
}

const Field* PointCloud::find(std::string_view name) const {
  for (const auto& field : fields) {
    if (field.name == name) return &field;
  }
  return nullptr;
}

void PointCloud::set(Field field) {
  assert(field.size() == points.size());
  for (auto& old : fields) {
    if (old.name == field.name) {
      old = std::move(field);
      return;
    }
  }
  fields.push_back(std::move(field));
}

}  // namespace scanchor
