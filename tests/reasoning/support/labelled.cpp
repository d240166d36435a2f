#include "tests/reasoning/support/labelled.hpp"

namespace scanchor::test {

LabelledScene labelled(const std::vector<Named>& things, const Eigen::Vector3d& eye) {
  std::vector<Plate> plates;
  for (const auto& thing : things) plates.push_back(thing.plate);
  LabelledScene scene;
  scene.surfaces = make_surfaces(plates);
  scene.surfaces.sensor_positions = {eye};
  scene.labelling.mode = "default";
  scene.labelling.up_sigma = 0.002;
  for (std::size_t i = 0; i < things.size(); ++i) {
    Entity entity;
    entity.id = static_cast<std::int32_t>(i);
    entity.surfaces = {entity.id};
    entity.label = things[i].label;
    entity.probability = things[i].probability;
    if (things[i].label != "unknown")
      entity.classes.push_back({things[i].label, things[i].probability});
    entity.classes.push_back({"unknown", 1.0 - things[i].probability});
    entity.center = things[i].plate.center;
    entity.normal = things[i].plate.normal;
    entity.size = {things[i].plate.length, things[i].plate.width, 0.0};
    scene.labelling.entities.push_back(entity);
    scene.labelling.entity_of_surface.push_back(entity.id);
  }
  return scene;
}

void add_group(LabelledScene& scene, const std::vector<std::int32_t>& members,
               const std::string& label, double probability) {
  Entity group;
  group.id = static_cast<std::int32_t>(scene.labelling.entities.size());
  group.members = group.surfaces = members;
  group.label = label;
  group.probability = probability;
  group.classes = {{label, probability}, {"unknown", 1.0 - probability}};
  for (const auto m : members) {
    scene.labelling.entities[m].whole = group.id;
    scene.labelling.entities[m].classes = {{"unknown", 1.0}};
    scene.labelling.entities[m].label = "unknown";
    scene.labelling.entity_of_surface[m] = group.id;
  }
  scene.labelling.entities.push_back(group);
}

}  // namespace scanchor::test
