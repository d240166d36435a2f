// The way back from Turtle. Without serd it is a clear refusal; the rest of the program does not
// need it.
#include <algorithm>
#include <cstdlib>
#include <map>
#include <vector>

#include "core/error.hpp"
#include "reasoning/owl.hpp"
#include "reasoning/sdl_words.hpp"

#if __has_include(<serd/serd.h>)
#include <serd/serd.h>

namespace scanchor {

namespace {

const std::string sdl_space = "https://scanchor.example/sdl#";
const std::string rdfs_space = "http://www.w3.org/2000/01/rdf-schema#";
const std::string owl_space = "http://www.w3.org/2002/07/owl#";
const std::string rdf_space = "http://www.w3.org/1999/02/22-rdf-syntax-ns#";
const std::string xsd_space = "http://www.w3.org/2001/XMLSchema#";
const std::string alt_label = "http://www.w3.org/2004/02/skos/core#altLabel";

struct Value {
  std::string text;
  bool literal = false;
};

/// subject -> (predicate, value) in the order of the file.
using Graph = std::map<std::string, std::vector<std::pair<std::string, Value>>>;

struct Reading {
  Graph graph;
  std::vector<std::string> subjects;
  SerdEnv* env = nullptr;
  std::string error;
};

std::string full_name(const Reading& reading, const SerdNode* node) {
  if (node->type == SERD_BLANK)
    return "_:" + std::string(reinterpret_cast<const char*>(node->buf), node->n_bytes);
  if (node->type == SERD_LITERAL)
    return std::string(reinterpret_cast<const char*>(node->buf), node->n_bytes);
  SerdNode expanded = serd_env_expand_node(reading.env, node);
  std::string name =
      expanded.buf != nullptr
          ? std::string(reinterpret_cast<const char*>(expanded.buf), expanded.n_bytes)
          : std::string(reinterpret_cast<const char*>(node->buf), node->n_bytes);
  serd_node_free(&expanded);
  return name;
}

SerdStatus on_base(void* handle, const SerdNode* uri) {
  return serd_env_set_base_uri(static_cast<Reading*>(handle)->env, uri);
}

SerdStatus on_prefix(void* handle, const SerdNode* name, const SerdNode* uri) {
  return serd_env_set_prefix(static_cast<Reading*>(handle)->env, name, uri);
}

SerdStatus on_statement(void* handle, SerdStatementFlags, const SerdNode*, const SerdNode* subject,
                        const SerdNode* predicate, const SerdNode* object, const SerdNode*,
                        const SerdNode*) {
  auto& reading = *static_cast<Reading*>(handle);
  const std::string s = full_name(reading, subject);
  auto [at, fresh] = reading.graph.try_emplace(s);
  if (fresh) reading.subjects.push_back(s);
  at->second.emplace_back(full_name(reading, predicate),
                          Value{full_name(reading, object), object->type == SERD_LITERAL});
  return SERD_SUCCESS;
}

SerdStatus on_error(void* handle, const SerdError* error) {
  auto& reading = *static_cast<Reading*>(handle);
  if (reading.error.empty())
    reading.error =
        "line " + std::to_string(error->line) + ", column " + std::to_string(error->col);
  return SERD_SUCCESS;
}

const Value* find(const Graph& graph, const std::string& subject, const std::string& predicate) {
  const auto at = graph.find(subject);
  if (at == graph.end()) return nullptr;
  for (const auto& [p, value] : at->second) {
    if (p == predicate) return &value;
  }
  return nullptr;
}

std::string text_of(const Graph& graph, const std::string& subject, const std::string& predicate) {
  const Value* value = find(graph, subject, predicate);
  return value != nullptr ? value->text : "";
}

std::string after_hash(const std::string& name) {
  const auto at = name.find_last_of("#/");
  return at == std::string::npos ? name : name.substr(at + 1);
}

class Back {
 public:
  Back(const Graph& graph, const std::string& file) : graph_(graph), file_(file) {}

  std::string class_name(const std::string& subject) const {
    const std::string label = text_of(graph_, subject, rdfs_space + "label");
    if (!label.empty()) return label;
    std::string name = after_hash(subject);
    std::replace(name.begin(), name.end(), '_', ' ');
    return name;
  }

  std::string clause(const std::string& node) const {
    const std::string words = text_of(graph_, node, sdl_space + "words");
    if (!words.empty()) return words;
    const std::string property = after_hash(text_of(graph_, node, owl_space + "onProperty"));
    const std::string target_class = text_of(graph_, node, owl_space + "onClass");
    const std::string some = text_of(graph_, node, owl_space + "someValuesFrom");
    if (find(graph_, node, owl_space + "hasValue") != nullptr) return property;
    for (const auto& word : feature_vocabulary()) {
      if (word.word == property) return std::string(word.word) + " " + facets(some, word.dimension);
    }
    const std::string& target = target_class.empty() ? some : target_class;
    for (const auto& word : relation_vocabulary()) {
      if (squeezed(std::string(word.words)) != property || target.empty()) continue;
      const bool none = text_of(graph_, node, owl_space + "maxQualifiedCardinality") == "0";
      return (none ? "not " : "") + std::string(word.words) + " a " + target_words(target);
    }
    fail_data(file_, "restriction on " + (property.empty() ? node : property),
              "cannot be said in a class file");
  }

 private:
  /// A class, or "class that is ..." of an intersection of one class with restrictions.
  std::string target_words(const std::string& node) const {
    std::string list = text_of(graph_, node, owl_space + "intersectionOf");
    if (list.empty()) return class_name(node);
    if (depth_ >= deepest_description)
      fail_data(file_, "intersection " + node,
                "lies in itself, or more than " + std::to_string(deepest_description) + " deep");
    ++depth_;
    std::string named;
    std::string said;
    for (int guard = 0; guard < 64 && !list.empty() && list != rdf_space + "nil"; ++guard) {
      const std::string member = text_of(graph_, list, rdf_space + "first");
      const bool is_restriction = !text_of(graph_, member, owl_space + "onProperty").empty();
      if (is_restriction) {
        std::string words = clause(member);
        // What is said of a target further in goes into brackets, or the next words would be its.
        const auto inner = words.find(" that ");
        if (inner != std::string::npos && words.find('(') == std::string::npos)
          words = words.substr(0, inner) + " (" + words.substr(inner + 1) + ")";
        said += (said.empty() ? " that is " : " and ") + words;
      } else if (named.empty()) {
        named = class_name(member);
      } else {
        fail_data(file_, "intersection with " + named, "of two named classes cannot be said",
                  "describe a class of its own");
      }
      list = text_of(graph_, list, rdf_space + "rest");
    }
    --depth_;
    if (named.empty()) fail_data(file_, "intersection", "names no class");
    return named + said;
  }

  static std::string squeezed(const std::string& words) {
    std::string name;
    bool up = false;
    for (const char c : words) {
      if (c == ' ') {
        up = true;
      } else {
        name += up ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
        up = false;
      }
    }
    return name;
  }

  std::string facets(const std::string& datatype, int dimension) const {
    std::string low;
    std::string high;
    std::string list = text_of(graph_, datatype, owl_space + "withRestrictions");
    for (int guard = 0; guard < 16 && !list.empty() && list != rdf_space + "nil"; ++guard) {
      const std::string facet = text_of(graph_, list, rdf_space + "first");
      const auto read = [&](const char* name) {
        const std::string value = text_of(graph_, facet, xsd_space + name);
        return value.empty() ? value : number_text(std::strtod(value.c_str(), nullptr));
      };
      for (const auto* name : {"minInclusive", "minExclusive"})
        low = read(name).empty() ? low : read(name);
      for (const auto* name : {"maxInclusive", "maxExclusive"})
        high = read(name).empty() ? high : read(name);
      list = text_of(graph_, list, rdf_space + "rest");
    }
    const std::string unit = dimension == 2 ? " m2" : dimension == 1 ? " m" : "";
    if (!low.empty() && !high.empty()) return low + ".." + high + unit;
    return (low.empty() ? "at most " + high : "at least " + low) + unit;
  }

  const Graph& graph_;
  const std::string& file_;
  mutable int depth_ = 0;  ///< intersections around the one that is read
};

/// The reader of Turtle calls itself for each bracket: how deep they lie, text and names aside.
int bracket_depth(const std::string& turtle) {
  int depth = 0, most = 0;
  char until = '\0';  // end of a comment, a name or a text
  for (std::size_t i = 0; i < turtle.size(); ++i) {
    const char c = turtle[i];
    if (until != '\0') {
      if (until == '"' && c == '\\') ++i;
      if (c == until) until = '\0';
      continue;
    }
    if (c == '#') until = '\n';
    if (c == '<') until = '>';
    if (c == '"' || c == '\'') until = c;
    if (c == '(' || c == '[') most = std::max(most, ++depth);
    if (c == ')' || c == ']') --depth;
  }
  return most;
}

int order_of(const Graph& graph, const std::string& subject) {
  const Value* order = find(graph, subject, sdl_space + "order");
  return order != nullptr ? std::atoi(order->text.c_str()) : 1 << 20;
}

}  // namespace

Ontology ontology_from_turtle(const std::string& turtle, const std::string& file) {
  if (bracket_depth(turtle) > 4 * deepest_description)
    fail_data(file, "",
              "brackets lie more than " + std::to_string(4 * deepest_description) + " deep");
  Reading reading;
  reading.env = serd_env_new(nullptr);
  SerdReader* reader =
      serd_reader_new(SERD_TURTLE, &reading, nullptr, on_base, on_prefix, on_statement, nullptr);
  serd_reader_set_error_sink(reader, on_error, &reading);
  const SerdStatus status =
      serd_reader_read_string(reader, reinterpret_cast<const std::uint8_t*>(turtle.c_str()));
  serd_reader_free(reader);
  serd_env_free(reading.env);
  if (status != SERD_SUCCESS && status != SERD_FAILURE)
    fail_data(file, reading.error, "is not Turtle");
  if (!reading.error.empty()) fail_data(file, reading.error, "is not Turtle");

  const Graph& graph = reading.graph;
  const Back back(graph, file);
  std::vector<std::string> classes;
  for (const auto& subject : reading.subjects) {
    const bool named = subject.rfind("_:", 0) != 0;
    for (const auto& [p, value] : graph.at(subject)) {
      if (named && p == rdf_space + "type" && value.text == owl_space + "Class")
        classes.push_back(subject);
    }
  }
  std::stable_sort(classes.begin(), classes.end(), [&](const auto& a, const auto& b) {
    return order_of(graph, a) < order_of(graph, b);
  });
  // The text of a class file is the common ground: its reader checks all the rest.
  std::string text;
  for (const auto& subject : classes) {
    text += (text_of(graph, subject, sdl_space + "axiom") == "true" ? "axiom " : "class ") +
            back.class_name(subject);
    std::vector<std::string> clauses;
    std::string parent;
    for (const auto& [p, value] : graph.at(subject)) {
      if (p == alt_label) text += ", " + value.text;
      if (p != rdfs_space + "subClassOf" || value.literal) continue;
      if (value.text.rfind("_:", 0) == 0) {
        clauses.push_back(value.text);
      } else if (value.text != owl_space + "Thing") {
        parent = back.class_name(value.text);
      }
    }
    std::stable_sort(clauses.begin(), clauses.end(), [&](const auto& a, const auto& b) {
      return order_of(graph, a) < order_of(graph, b);
    });
    if (!parent.empty()) text += " is a " + parent;
    const std::string whole = text_of(graph, subject, sdl_space + "partOf");
    if (!whole.empty()) text += " part of " + back.class_name(whole);
    text += ":\n";
    if (text_of(graph, subject, sdl_space + "unique") == "true") text += "    unique\n";
    if (text_of(graph, subject, sdl_space + "severalFaces") == "true")
      text += "    several faces\n";
    for (const auto& node : clauses) text += "    " + back.clause(node) + "\n";
  }
  if (classes.empty()) fail_data(file, "", "has no owl:Class");
  return parse_ontology(text, file);
}

}  // namespace scanchor

#else

namespace scanchor {

Ontology ontology_from_turtle(const std::string&, const std::string& file) {
  fail_data(file, "", "this program was built without the serd library that reads Turtle",
            "install libserd-dev and build again");
}

}  // namespace scanchor

#endif
