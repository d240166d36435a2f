#pragma once
// The rules of a score, named and versioned. A number without its protocol cannot be compared with
// another number.

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "core/options.hpp"

namespace scanchor {

/// Every decision that changes a score. The members' defaults are the built-in protocol
/// "scanchor-1"; docs/reference/protocols.md tells where each of the others differs and why.
struct Protocol {
  std::string name = "scanchor-1";
  int version = 2;

  // Classes
  std::vector<std::string> classes;  ///< scored classes by name; empty: the whole class list
  std::vector<std::pair<std::string, std::string>> merge = {
      {"bookcase", "shelf"}};         ///< {from, into}: counted as one class, on both sides
  std::string absent_class = "skip";  ///< a class in neither truth nor prediction: "skip" it in
                                      ///< means (COCO) or count it "zero" (SemanticKITTI)

  // What could not be seen does not count
  std::vector<std::string> ignore_flags = {
      "mixed", "ghost", "out_of_range"};  ///< points with such a PointFlag have no truth
  int min_points = 50;                    ///< a thing with fewer points of truth is small
  double min_visible = 0.1;  ///< [0, 1] a thing less of whose planar faces was reached is ignored
                             ///< (where the scene is known); of the best seen of its large faces
  double large_face =
      0.1;  ///< [0, 1] share of the area of a thing's largest face that makes a large face
  int min_face_points = 0;       ///< a large face with fewer points is not seen
  std::string small = "ignore";  ///< small things: "ignore" on both sides, or "unpunished" (a match
                                 ///< counts, a miss does not)

  // Segments
  double match_iou = 0.5;                ///< a match has a larger intersection over union
  std::string void_points = "subtract";  ///< predicted points without truth: "subtract" from the
                                         ///< union (COCO) or "remove" first (SemanticKITTI)
  bool merge_stuff = true;               ///< all predicted points of a stuff class are one segment
  std::string no_instance =
      "drop";  ///< points of a thing class without an instance: "drop", or one "segment"

  // Average precision
  std::string average_precision =
      "coco";  ///< "coco" (101 recalls, greedy by confidence) or "scannet" (area, greedy by truth)
  std::vector<double> ap_thresholds = {0.5, 0.55, 0.6, 0.65, 0.7, 0.75, 0.8, 0.85, 0.9, 0.95};

  // Planes
  std::vector<double> plane_tolerances = {0.51, 0.55, 0.6,  0.65, 0.7,
                                          0.75, 0.8,  0.85, 0.9,  0.95};  ///< Hoover's T
  int plane_min_points = 30;
  double plane_min_visible = 0.1;  ///< [0, 1]
  double plane_merge_angle_deg =
      1.0;  ///< faces that no scan can tell apart are one plane: angle between them at most this,
  double plane_merge_offset = 0.005;  ///< [m] step between them at most this,
  double plane_merge_gap = 0.02;      ///< [m] gap between their rectangles at most this
  double small_plane_share = 0.01;    ///< a plane with a smaller share of the scan's points counts
                                      ///< for the recall of small planes
  double geometry_tolerance = 0.8;    ///< Hoover's T from which a plane's geometry is compared
  double full_view = 0.9;  ///< visible fraction from which width, height and area are compared

  // Things
  double object_purity = 0.5;     ///< more than this share of a claim's points lies on the thing
  double object_coverage = 0.25;  ///< at least this share of the thing's points is in the claim
  int calibration_bins = 15;      ///< of the expected calibration error (Guo et al. 2017)

  void describe(OptionList& list);  ///< the numbers, words and switches; lists are read apart
};

/// The first 16 digits of the SHA-256 of the protocol as text: two protocols with the same stamp
/// score alike.
std::string protocol_hash(const Protocol& protocol);
/// "scanchor-1 v1 (0123456789abcdef)"
std::string protocol_stamp(const Protocol& protocol);

/// "scanchor-1", "coco", "semantickitti", "scannet".
const std::vector<std::string>& builtin_protocols();
/// A built-in protocol by name, or a file by path (ending .yaml, .yml or .json). Throws
/// Error(wrong_usage) for an unknown name.
Protocol find_protocol(const std::string& name_or_path);
/// Reads a protocol file. What it leaves out is as in the protocol that its key `base` names
/// (scanchor-1 if absent). Throws Error(bad_data) with file and line: unknown key (did you mean),
/// wrong type, out of range, class that is none.
Protocol read_protocol(const std::filesystem::path& path);
Protocol protocol_from_text(const std::string& text, const std::string& file);
/// All values in YAML, each with its unit and meaning as a comment; reads back to the same hash.
std::string protocol_to_text(const Protocol& protocol);
void write_protocol(const std::filesystem::path& path, const Protocol& protocol);

/// What the metrics need to know of the classes, by ClassId. For tests it can be filled by hand,
/// without the class list.
struct ClassRules {
  std::vector<std::string> names;
  std::vector<char> scored;              ///< 1: counts
  std::vector<char> thing;               ///< 1: countable
  std::vector<std::int32_t> counted_as;  ///< class after merging
  [[nodiscard]] std::size_t size() const { return names.size(); }
  /// The class that counts for id, or -1: no truth (not scored, no class at all).
  [[nodiscard]] std::int32_t of(std::int32_t id) const;
};
ClassRules class_rules(const Protocol& protocol);

}  // namespace scanchor
