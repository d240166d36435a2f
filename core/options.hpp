#pragma once
// One declaration for each option of a stage. It feeds `--set stage.option=value`, the YAML
// readers, the JSON of the resolved configuration, the table in the docs and the axes of a sweep.
//
//   struct LidarOptions {
//     double range_sigma = 0.01;
//     void describe(OptionList& list) {
//       list.add("range_sigma", range_sigma, "m", "standard deviation of the range noise",
//       0.0, 1.0);
//     }
//   };

#include <cstdint>
#include <limits>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace scanchor {

struct Option {
  std::string name;  ///< "lidar.range_sigma"
  std::string unit;  ///< "m", "deg", "1", "" for switches and words
  std::string text;  ///< what it does, one line
  double minimum = -std::numeric_limits<double>::infinity();
  double maximum = std::numeric_limits<double>::infinity();
  std::vector<std::string> choices;  ///< allowed words, for a string with a closed set
  std::variant<double*, int*, bool*, std::uint64_t*, std::string*> value;
};

/// Options by their dotted names. Holds pointers into the structs that were described: they must
/// outlive the list and not move.
class OptionList {
 public:
  void add(std::string_view name, double& value, std::string_view unit, std::string_view text,
           double minimum = -std::numeric_limits<double>::infinity(),
           double maximum = std::numeric_limits<double>::infinity());
  void add(std::string_view name, int& value, std::string_view unit, std::string_view text,
           double minimum = -std::numeric_limits<double>::infinity(),
           double maximum = std::numeric_limits<double>::infinity());
  void add(std::string_view name, bool& value, std::string_view text);
  void add(std::string_view name, std::uint64_t& value, std::string_view text);
  void add(std::string_view name, std::string& value, std::string_view text,
           std::vector<std::string> choices = {});

  /// Describes a whole struct under a prefix: `list.add_group("lidar", lidar_options)`.
  template <class Options>
  void add_group(std::string_view prefix, Options& options) {
    const std::string outer = prefix_;
    prefix_ += std::string(prefix) + ".";
    options.describe(*this);
    prefix_ = outer;
  }

  [[nodiscard]] const std::vector<Option>& options() const { return options_; }

  /// Sets one option from text. Throws Error(wrong_usage): unknown name (with "did you mean"), not
  /// a number, out of range.
  void set(std::string_view name, std::string_view value);
  /// Takes "name=value", as `--set` gives it.
  void set_assignment(std::string_view assignment);
  /// Value as text, in the form that `set` reads back to the same bits.
  [[nodiscard]] std::string get(std::string_view name) const;
  /// All options as a nested JSON object, in the order of their declaration.
  [[nodiscard]] nlohmann::ordered_json to_json() const;
  /// A Markdown table: name, default, unit, range, meaning.
  [[nodiscard]] std::string to_markdown() const;

 private:
  const Option& find(std::string_view name) const;
  void push(Option option);
  std::string prefix_;
  std::vector<Option> options_;
};

}  // namespace scanchor
