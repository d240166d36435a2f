#pragma once
// What a class file says, as plain values: the tree that the reader makes of `.sdl` text
// (docs/reference/sdl.md).

#include <filesystem>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace scanchor {

/// Where something stands in a class file, both from 1; 0: it was not read from a file.
struct SourcePlace {
  int line = 0;
  int column = 0;
};

/// What is measured of one entity.
enum class Feature {
  area,             ///< A of the paper [m2] (a scalar: slip S2)
  extension,        ///< E of the paper [m]: the longer side of the minimum-area rectangle (slip S3)
  width,            ///< [m] the shorter side of it
  height,           ///< [m] vertical extent
  elongation,       ///< [1] extension / width, at least 1
  rectangularness,  ///< R of the paper [1]: area / area of the fitted rectangle
  members,          ///< [1] how many things a group is made of; 1 of a surface
};

enum class Extremum {
  lowest,     ///< nothing to speak of lies lower
  highest,    ///< nothing to speak of lies higher
  outermost,  ///< nothing to speak of lies behind its plane, seen from the middle of the scene
  largest,    ///< no rival of the same class is larger
  cornered,   ///< another surface meets it at an outer edge, as the faces of a box do
};

/// A relation between an entity (subject) and a target; reasoning.md section 2.3.
enum class Relation {
  parallel,
  orthogonal,
  above,
  below,
  on,
  supports,
  inside,
  near,
  touching,
  same_size,
  aligned,
  stacked,  ///< over or under it, the smaller one's footprint within the other's

  coplanar,
  higher,
  lower,
  elevation,  ///< height of the middle above the target's [m]
  bottom,     ///< height of the lower end above the target's middle [m]
  top,        ///< height of the upper end above the target's middle [m]
  set_back,   ///< depth of the middle behind the target's plane, seen from the sensor [m]
  left_of,
  right_of,
  in_front_of,
  behind,  ///< seen from the first position of the sensor
};

/// An interval of a quantity in SI units (m, m2) or degrees, open sides infinite.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  std::string unit;    ///< as written: "m", "cm", "mm", "m2", "cm2", "deg", "" for pure numbers
  bool about = false;  ///< written as "about x": low and high are x -+ 20 %
  bool strict =
      false;  ///< written as "under" or "over" rather than "at most" or "at least"; means the same
  [[nodiscard]] bool has_low() const { return low > -std::numeric_limits<double>::infinity(); }
  [[nodiscard]] bool has_high() const { return high < std::numeric_limits<double>::infinity(); }
  bool operator==(const Range&) const = default;
};

struct RelationTerm {
  Relation relation = Relation::parallel;
  Range range;  ///< of elevation, bottom, top; the distance of `within`; otherwise open
  bool operator==(const RelationTerm&) const = default;
};

enum class ClauseKind {
  feature,
  horizontal,
  vertical,
  rectangular,
  extremum,
  relation,
  negation,
  group
};

/// One line of a description.
struct Clause {
  ClauseKind kind = ClauseKind::feature;
  double weight =
      1.0;  ///< exponent of its likelihood ratio; below 1 for clauses that say nearly the same
  bool usually = false;  ///< context: may raise or lower, never required, may refer in a circle
  Feature feature = Feature::area;
  Range range;  ///< of a feature; of `horizontal` and `vertical` the tolerance in deg, open: 5 deg
  Extremum extremum = Extremum::lowest;
  std::vector<RelationTerm> relations;  ///< conjunction on one shared target
  std::string
      target;  ///< class name of the target, of the forbidden target, or of a group's members
  std::vector<Clause> target_clauses;  ///< "that is ...": what the target has to be besides
  int count_low = 0;                   ///< group: at least so many members
  int count_high = std::numeric_limits<int>::max();  ///< group: at most so many
  std::vector<RelationTerm> pairwise;                ///< group: for each pair of members
  // Learned on training scenes (`scanchor fit`), negative: the documented default of the kind.
  double hit_rate = -1.0;       ///< P(clause holds | class), alpha
  double background = -1.0;     ///< P(clause holds | any other entity), beta
  double counted_weight = 1.0;  ///< multiplies `weight`; below 1 where other clauses say the same
  SourcePlace place;
  // For the formatter:
  std::string written_target;              ///< of a group, in its plural
  std::string comment;                     ///< text behind '#'
  std::vector<std::string> comments;       ///< lines in front; blank_line stands for an empty one
  std::vector<std::string> pair_comments;  ///< one a pair relation
};

/// Stands for an empty line among comments.
inline constexpr std::string_view blank_line = "\f";

struct ClassDescription {
  std::vector<std::string>
      names;  ///< the first is the one that is reported, the others are synonyms
  bool axiom = false;
  std::string parent;  ///< "is a": all clauses of the parent hold too
  std::string
      part_of;  ///< "part of": what is found belongs to its whole and is no thing of its own
  bool unique = false;         ///< at most one in a scene
  bool several_faces = false;  ///< faces of this class that meet at a right angle are one thing
  std::vector<Clause> clauses;
  double prior = -1.0;  ///< P(class) of a random surface; negative: default
  SourcePlace place;
  std::vector<std::string> comments;  ///< lines in front of the class
  std::string comment;                ///< behind the header
  std::string file;                   ///< that it was read from
  [[nodiscard]] const std::string& name() const { return names.front(); }
};

struct Ontology {
  std::string name;  ///< file name without folder and suffix
  std::string file;
  std::vector<std::string> imports;       ///< as written
  std::vector<ClassDescription> classes;  ///< imported ones first, in the order of the files
  std::vector<std::string> closing_comments;
  double unknown_prior = -1.0;  ///< P(a random surface is of no described class); negative: default
  double temperature = 1.0;     ///< exponent of all likelihood ratios, learned; 1: as described
  std::string fitted_on;        ///< what the background rates were counted on; empty: defaults
  /// Index of the class with this name or synonym, plural forms allowed where `plural`; -1: none.
  [[nodiscard]] int find(std::string_view class_name, bool plural = false) const;
  [[nodiscard]] std::vector<std::string> class_names() const;
};

/// Reads a class file with all it imports, and the counted rates in `<name>.background.json` beside
/// it if that is there. Throws Error(bad_data): "office.sdl:12:5: unknown feature 'aera'; did you
/// mean 'area'?", then the line and a caret.
Ontology read_ontology(const std::filesystem::path& path);

/// The same from text; `file` names it in messages, and imports are looked up beside it.
Ontology parse_ontology(const std::string& text, const std::string& file);

/// A path, or a name such as "office" that is looked up as core/data_folder.hpp says. Throws
/// Error(bad_data) that lists what there is.
Ontology find_ontology(const std::string& name_or_path);

/// Classes in an order in which every class comes behind those it needs (indices into `classes`).
/// Throws Error(bad_data) that names the circle and a class that can never be grounded: "desk needs
/// screen needs desk".
std::vector<int> evaluation_order(const Ontology& ontology);

/// The class and the classes it is a kind of, the most general one first.
std::vector<int> with_parents(const Ontology& ontology, int class_index);

/// The class above: what it is a kind of, else what it is a part of; -1: none. Who sees a piece of
/// a wall sees a wall.
int class_above(const Ontology& ontology, int class_index);
/// Is it the class, or above it?
bool is_ancestor(const Ontology& ontology, int ancestor, int class_index);
/// Is one of the two the other, or above it?
bool are_akin(const Ontology& ontology, int a, int b);

/// A part that only a group of its whole holds together (a board of a shelf, an end of the frame of
/// a desk): nothing by itself, it counts through the group.
bool only_a_member(const Ontology& ontology, int class_index);

/// Clauses of a class with those of its parents in front.
std::vector<Clause> all_clauses(const Ontology& ontology, int class_index);

/// Words of the language.
std::string relation_words(Relation relation);
std::string feature_word(Feature feature);
std::string extremum_word(Extremum extremum);
/// "0.9..1.7 m2", "at least 2 m", "about 30 deg".
std::string range_text(const Range& range);
/// The clause as it would stand in a class file, without its comment: "parallel to a floor". Pair
/// relations of a group are joined with " and " on the same line.
std::string clause_text(const Clause& clause);

}  // namespace scanchor
