#include "core/options.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "core/text.hpp"

namespace scanchor {
namespace {

template <class Number>
Number parse_number(const Option& option, std::string_view text) {
  Number number{};
  const auto result = std::from_chars(text.data(), text.data() + text.size(), number);
  if (result.ec != std::errc() || result.ptr != text.data() + text.size()) {
    fail_usage(fmt::format("option {}: '{}' is not {}", option.name, text,
                           std::is_integral_v<Number> ? "a whole number" : "a number"));
  }
  const auto real = static_cast<double>(number);
  if (!std::isfinite(real) || real < option.minimum || real > option.maximum) {
    fail_usage(fmt::format("option {}: {} is outside {} .. {} {}", option.name, text,
                           option.minimum, option.maximum, option.unit));
  }
  return number;
}

bool parse_switch(const Option& option, std::string_view text) {
  if (text == "true" || text == "on" || text == "yes" || text == "1") return true;
  if (text == "false" || text == "off" || text == "no" || text == "0") return false;
  fail_usage(fmt::format("option {}: '{}' is neither true nor false", option.name, text));
}

std::string value_text(const Option& option) {
  return std::visit(
      [](auto* value) -> std::string {
        using Value = std::decay_t<decltype(*value)>;
        if constexpr (std::is_same_v<Value, bool>)
          return *value ? "true" : "false";
        else
          return fmt::format("{}", *value);  // fmt prints the shortest text that reads back
      },
      option.value);
}

}  // namespace

void OptionList::push(Option option) {
  option.name = prefix_ + option.name;
  options_.push_back(std::move(option));
}

void OptionList::add(std::string_view name, double& value, std::string_view unit,
                     std::string_view text, double minimum, double maximum) {
  push({std::string(name), std::string(unit), std::string(text), minimum, maximum, {}, &value});
}

void OptionList::add(std::string_view name, int& value, std::string_view unit,
                     std::string_view text, double minimum, double maximum) {
  push({std::string(name), std::string(unit), std::string(text), minimum, maximum, {}, &value});
}

void OptionList::add(std::string_view name, bool& value, std::string_view text) {
  push({std::string(name), "", std::string(text), 0, 1, {}, &value});
}

void OptionList::add(std::string_view name, std::uint64_t& value, std::string_view text) {
  push({std::string(name), "", std::string(text), 0, 1.8446744073709552e19, {}, &value});
}

void OptionList::add(std::string_view name, std::string& value, std::string_view text,
                     std::vector<std::string> choices) {
  push({std::string(name), "", std::string(text), 0, 0, std::move(choices), &value});
}

const Option& OptionList::find(std::string_view name) const {
  std::vector<std::string> names;
  for (const auto& option : options_) {
    if (option.name == name) return option;
    names.push_back(option.name);
  }
  fail_usage(fmt::format("unknown option '{}'", name), suggestion(name, names));
}

void OptionList::set(std::string_view name, std::string_view text) {
  const Option& option = find(name);
  std::visit(
      [&](auto* value) {
        using Value = std::decay_t<decltype(*value)>;
        if constexpr (std::is_same_v<Value, bool>) {
          *value = parse_switch(option, text);
        } else if constexpr (std::is_same_v<Value, std::string>) {
          bool known = option.choices.empty();
          for (const auto& choice : option.choices) known = known || choice == text;
          if (!known) {
            fail_usage(fmt::format("option {}: '{}' is not a choice", option.name, text),
                       suggestion(text, option.choices));
          }
          *value = std::string(text);
        } else {
          *value = parse_number<Value>(option, text);
        }
      },
      option.value);
}

void OptionList::set_assignment(std::string_view assignment) {
  const auto equals = assignment.find('=');
  if (equals == std::string_view::npos || equals == 0) {
    fail_usage(fmt::format("'{}' is no assignment", assignment), "write name=value");
  }
  set(assignment.substr(0, equals), assignment.substr(equals + 1));
}

std::string OptionList::get(std::string_view name) const { return value_text(find(name)); }

nlohmann::ordered_json OptionList::to_json() const {
  nlohmann::ordered_json root = nlohmann::ordered_json::object();
  for (const auto& option : options_) {
    nlohmann::ordered_json* node = &root;
    std::string_view rest = option.name;
    for (auto dot = rest.find('.'); dot != std::string_view::npos; dot = rest.find('.')) {
      node = &(*node)[std::string(rest.substr(0, dot))];
      rest = rest.substr(dot + 1);
    }
    std::visit([&](auto* value) { (*node)[std::string(rest)] = *value; }, option.value);
  }
  return root;
}

std::string OptionList::to_markdown() const {
  std::string table =
      "| option | default | unit | range | meaning |\n| --- | --- | --- | --- | --- |\n";
  for (const auto& option : options_) {
    std::string range;
    if (!option.choices.empty()) {
      for (const auto& choice : option.choices) range += (range.empty() ? "" : ", ") + choice;
    } else if (std::isfinite(option.minimum) && std::isfinite(option.maximum) &&
               (std::holds_alternative<double*>(option.value) ||
                std::holds_alternative<int*>(option.value))) {
      range = fmt::format("{} .. {}", option.minimum, option.maximum);
    }
    table += fmt::format("| `{}` | {} | {} | {} | {} |\n", option.name, value_text(option),
                         option.unit, range, option.text);
  }
  return table;
}

}  // namespace scanchor
