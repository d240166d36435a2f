#pragma once
// Which things were there, which were found, what was claimed wrongly: the table that a person
// reads first.

#include <cstdint>
#include <string>
#include <vector>

#include "eval/evaluate.hpp"
#include "eval/protocol.hpp"
#include "eval/truth.hpp"

namespace scanchor {

enum class ThingStatus : std::uint8_t {
  found,
  missed,
  ignored,        ///< too few points or too little seen: counts on neither side
  not_described,  ///< of a class that the method has no word for
};

/// One thing of the truth. All stuff of a class (floor, wall, ceiling) is one entry.
struct ThingResult {
  std::int32_t instance = -1;  ///< Instance::id; -1 for stuff
  std::int32_t class_id = unlabelled;
  std::string name;  ///< "desk 12", "floor"
  std::int64_t points = 0;
  double visible_fraction = 1.0;
  ThingStatus status = ThingStatus::missed;
  std::int32_t claim = -1;  ///< index into claims of what found it
  double coverage = 0.0;    ///< [0, 1] share of its points in that claim
  std::int32_t called =
      unlabelled;  ///< where missed: the class that most of its named points were called
};

enum class ClaimStatus : std::uint8_t {
  right,
  wrong,     ///< lies on something else, or on too little of anything
  repeated,  ///< on a thing of that class which another claim found already, or on a small piece of
             ///< one
  ignored,   ///< lies mostly where there is no truth or on what could not be seen
};

/// One claim of the method.
struct ClaimResult {
  std::int32_t instance = -1;  ///< of the prediction: the entity's id
  std::int32_t class_id = unlabelled;
  std::int64_t points = 0;
  double confidence = 1.0;
  ClaimStatus status = ClaimStatus::wrong;
  std::int32_t thing = -1;  ///< index into things that most of its points lie on; -1: none
  double purity = 0.0;      ///< [0, 1] share of its points with truth that lie on that thing
};

struct ObjectCounts {
  std::int64_t truths = 0;  ///< that count
  std::int64_t found = 0;
  std::int64_t wrong = 0;  ///< claims
  std::int64_t repeated = 0;
  [[nodiscard]] std::int64_t missed() const { return truths - found; }
  [[nodiscard]] std::int64_t claims() const { return found + wrong + repeated; }
  [[nodiscard]] double precision() const;  ///< found / claims; 0 without claims
  [[nodiscard]] double recall() const;     ///< found / truths; 0 without truths
  [[nodiscard]] double f1() const;         ///< 2 found / (claims + truths)
  void add(const ObjectCounts& other);
  friend bool operator==(const ObjectCounts&, const ObjectCounts&) = default;
};

/// Counts by ClassId, added up over scans.
struct ObjectScore {
  std::vector<ObjectCounts> classes;
  std::int64_t ignored = 0;        ///< things that could not be seen well enough
  std::int64_t not_described = 0;  ///< things of classes that the method has no word for
  void add(const ObjectScore& other);
  [[nodiscard]] ObjectCounts total() const;
  [[nodiscard]] double mean_f1() const;  ///< over classes with truths or claims
  friend bool operator==(const ObjectScore&, const ObjectScore&) = default;
};

struct ObjectSummary {
  std::vector<ThingResult> things;  ///< stuff first, then by class and instance
  std::vector<ClaimResult> claims;  ///< by class and instance
  ObjectScore score;
};

/// A claim finds a thing of its class when more than `object_purity` of the claim's points lie on
/// it and at least `object_coverage` of the thing's points are in the claim. A description names
/// the face by which people know a thing (a desk by its top), so half of the thing's points is not
/// asked for, as it is in panoptic quality. `described`: classes that the method has a word for;
/// empty: all. Things of other classes are listed, not counted as missed.
ObjectSummary summarize_objects(const ScanTruth& truth, const PointPrediction& prediction,
                                const Protocol& protocol,
                                const std::vector<ClassId>& described = {});

/// The same from our own answer.
ObjectSummary summarize_objects(const Scan& scan, const Scene* scene, const Surfaces& surfaces,
                                const Labelling& labelling, const Protocol& protocol,
                                const std::vector<ClassId>& described = {});

/// A table for a terminal: class, there, found, missed, wrong, precision, recall; then one line for
/// each missed thing and wrong claim.
std::string objects_to_text(const ObjectSummary& summary, bool with_lists = true);

}  // namespace scanchor
