#pragma once
// The free constants of the relations' likelihoods: counted by `scanchor fit-relations`, kept in
// ontologies/relations.json.

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace scanchor {

/// What relations take for granted of measurements and of rooms. Shares are in [0, 1]; what each
/// constant means, its unit and its range: relation_constants(), docs/reference/relations.md.
struct RelationModel {
  // How far planes are off (plane_error).
  double tilt_scale = 1.2;
  double tilt_of_points = 0.2;
  double tilt_excess_power = 3.0;
  // Angles between faces and against gravity.
  double flatness = 0.3;
  double gross_share = 0.05;
  double gross_factor = 5.0;
  double lost_planes = 1.0;
  double askew = 3.0;
  double faces_parallel = 0.07;
  double faces_nearly_parallel = 0.09;
  double faces_orthogonal = 0.37;
  double faces_nearly_orthogonal = 0.10;
  double level_parallel = 0.28;
  double level_nearly_parallel = 0.005;
  double level_orthogonal = 0.60;
  double level_nearly_orthogonal = 0.05;
  // How far things go on unseen (goes_on).
  double shadow_share = 0.7;
  double shadow_rate = 1.7;
  double end_share = 0.09;
  double end_rate = 6.0;
  double far_share = 0.015;
  double far_rate = 0.5;
  // Above, on.
  double overlap_softness = 0.08;
  double end_softness = 0.02;
  double carries = 0.67;
  double carrier_far_share = 0.015;
  double carrier_far_rate = 0.5;
  double tail_share = 0.1;
  double foreign_share = 0.03;
  double foreign_scale = 0.15;
  double upright_contact = 1.3;
  double upright_feet = 0.5;
  double upright_past = 0.33;
  double level_feet = 0.2;
  // Near.
  double near_softness = 0.03;
  double near_meets = 0.7;
  double near_short = 0.005;
  // Coplanar.
  double in_one_plane = 0.021;
  double plane_softness = 0.003;
  double hidden_middle = 0.3;
  double gross_offset_share = 0.02;
  // Same size.
  double twins = 0.04;
  double side_by_area = 0.3;
  double size_softness = 0.02;
  double misread_share = 0.3;
  double misread_factor = 4.0;
  // Vertically aligned.
  double middle_softness = 0.02;
  double in_one_line = 0.02;
  double axes_agree = 0.7;
  double turn_softness = 1.0;
  // Left of, in front of.
  double bearing_softness = 0.3;
};

/// One of them: where it stands, what it means, and between which values it is looked for.
struct RelationConstant {
  const char* name;
  const char* unit;  ///< "deg", "m", "1"
  const char* part;  ///< constants of one part are fitted together: "planes",
                     ///< "angles", ...
  const char* meaning;
  double RelationModel::*value;
  double low, high;
};
const std::vector<RelationConstant>& relation_constants();

/// The constants in use: those of ontologies/relations.json, read once (data_folder.hpp says where
/// it is looked for); where there is none, the same values built in. Throws Error(bad_data) for a
/// broken file.
const RelationModel& relation_model();

/// The file: constants and what they were fitted on.
struct RelationFile {
  std::string fitted_on;
  RelationModel model;
};
nlohmann::ordered_json relation_file_to_json(const RelationFile& file);
/// Throws Error(bad_data) for unknown, missing and impossible constants.
RelationFile relation_file_from_json(const nlohmann::ordered_json& json, const std::string& file);
RelationFile read_relation_file(const std::filesystem::path& path);
void write_relation_file(const std::filesystem::path& path, const RelationFile& file);

}  // namespace scanchor
