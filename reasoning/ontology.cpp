#include "reasoning/ontology.hpp"

#include <algorithm>
#include <functional>
#include <map>

#include "core/data_folder.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/text.hpp"
#include "reasoning/background.hpp"
#include "reasoning/new_classes.hpp"
#include "reasoning/sdl_parser.hpp"

namespace scanchor {

namespace fs = std::filesystem;

namespace {

bool is_file(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

std::vector<std::string> known_ontologies() { return list_data_files("ontologies", ".sdl"); }

/// First place where the name leads to a file; empty: none.
fs::path locate(const std::string& name, const fs::path& beside) {
  std::vector<fs::path> tries;
  for (const auto* suffix : {"", ".sdl"}) {
    if (!beside.empty()) tries.push_back(beside / (name + suffix));
    tries.emplace_back(name + suffix);
  }
  for (const auto& path : tries) {
    if (is_file(path)) return path;
  }
  const std::string stem = name.ends_with(".sdl") ? name.substr(0, name.size() - 4) : name;
  return look_up_data_file("ontologies", stem, ".sdl").value_or(fs::path());
}

struct SourceFile {
  std::string file;
  std::string text;
};

/// Loads `text` and what it imports, imported classes first. `chain`: files that are being read,
/// for the circle's message.
void load(const std::string& text, const std::string& file, std::vector<std::string>& chain,
          std::vector<SourceFile>& sources, Ontology& all) {
  Ontology one = parse_sdl(text, file);
  sources.push_back({file, text});
  chain.push_back(file);
  for (const auto& import : one.imports) {
    const fs::path path = locate(import, fs::path(file).parent_path());
    if (path.empty()) {
      fail_data(file, "", "imports '" + import + "', which is not found",
                suggestion(import, known_ontologies()));
    }
    const std::string name = path.string();
    if (const auto at = std::find(chain.begin(), chain.end(), name); at != chain.end()) {
      std::string circle;
      for (auto i = at; i != chain.end(); ++i) circle += *i + " imports ";
      fail_data(file, "", "imports go in a circle: " + circle + name);
    }
    const bool loaded =
        std::any_of(sources.begin(), sources.end(), [&](const auto& s) { return s.file == name; });
    if (!loaded) load(read_file(path), name, chain, sources, all);
  }
  chain.pop_back();
  for (auto& description : one.classes) {
    for (const auto& name : description.names) {
      const int other = all.find(name);
      if (other < 0) continue;
      if (all.classes[other].file == file) {
        fail_sdl(text, file, description.place,
                 "class '" + name + "' is described twice in this file");
      }
      all.classes.erase(all.classes.begin() + other);  // the importing file has the last word
    }
    all.classes.push_back(std::move(description));
  }
  all.imports = one.imports;
  all.closing_comments = one.closing_comments;
}

void resolve(Ontology& ontology, const std::vector<SourceFile>& sources) {
  const auto fail = [&](const std::string& file, SourcePlace place, const std::string& cause,
                        const std::string& remedy) {
    for (const auto& source : sources) {
      if (source.file == file) fail_sdl(source.text, file, place, cause, remedy);
    }
    fail_data(file, "line " + std::to_string(place.line), cause, remedy);
  };
  for (auto& description : ontology.classes) {
    const auto refer = [&](std::string& name, SourcePlace place, bool plural) {
      const int index = ontology.find(name, plural);
      if (index < 0) {
        fail(description.file, place, "unknown class '" + name + "'",
             suggestion(name, ontology.class_names()));
      } else {
        name = ontology.classes[index].name();
      }
    };
    if (!description.parent.empty()) refer(description.parent, description.place, false);
    if (!description.part_of.empty()) refer(description.part_of, description.place, false);
    const std::function<void(Clause&)> refer_all = [&](Clause& clause) {
      if (!clause.target.empty())
        refer(clause.target, clause.place, clause.kind == ClauseKind::group);
      for (auto& nested : clause.target_clauses) refer_all(nested);
    };
    for (auto& clause : description.clauses) {
      refer_all(clause);
      if (description.axiom && !clause.target.empty()) {
        fail(description.file, clause.place,
             "an axiom depends on no other class, '" + clause_text(clause) + "' does",
             "write 'class " + description.name() + ":'");
      }
    }
  }
}

}  // namespace

int Ontology::find(std::string_view class_name, bool plural) const {
  const auto exact = [&](std::string_view word) {
    for (std::size_t i = 0; i < classes.size(); ++i) {
      const auto& names = classes[i].names;
      if (std::find(names.begin(), names.end(), word) != names.end()) return static_cast<int>(i);
    }
    return -1;
  };
  int index = exact(class_name);
  if (index >= 0 || !plural) return index;
  const std::string word(class_name);
  if (word.ends_with("ves")) index = exact(word.substr(0, word.size() - 3) + "f");
  if (index < 0 && word.ends_with("es")) index = exact(word.substr(0, word.size() - 2));
  if (index < 0 && word.ends_with("s")) index = exact(word.substr(0, word.size() - 1));
  return index;
}

std::vector<std::string> Ontology::class_names() const {
  std::vector<std::string> all;
  for (const auto& description : classes)
    all.insert(all.end(), description.names.begin(), description.names.end());
  return all;
}

Ontology parse_ontology(const std::string& text, const std::string& file) {
  Ontology ontology;
  ontology.file = file;
  ontology.name = fs::path(file).stem().string();
  std::vector<std::string> chain;
  std::vector<SourceFile> sources;
  load(text, file, chain, sources, ontology);
  if (ontology.classes.empty())
    fail_data(file, "", "describes no class", "write 'class desk:' and its clauses");
  resolve(ontology, sources);
  evaluation_order(ontology);
  return ontology;
}

Ontology read_ontology(const fs::path& path) {
  Ontology ontology = parse_ontology(read_file(path), path.string());
  // Counted rates lie beside the class files; those of the importing file have the last word.
  std::vector<std::string> files;
  for (const auto& description : ontology.classes) {
    if (std::find(files.begin(), files.end(), description.file) == files.end())
      files.push_back(description.file);
  }
  if (std::find(files.begin(), files.end(), path.string()) == files.end())
    files.push_back(path.string());
  for (const auto& file : files) {
    const fs::path sidecar = fs::path(file).replace_extension(".background.json");
    if (is_file(sidecar)) apply_background(ontology, read_background(sidecar));
  }
  // Beside what is counted, what is not: weighed as its like, and held against rooms that are
  // known.
  const std::vector<int> uncounted = new_classes(ontology);
  fill_uncounted(ontology);
  if (uncounted.empty() || ontology.fitted_on.empty()) return ontology;
  for (auto file = files.rbegin(); file != files.rend(); ++file) {
    const fs::path rooms = fs::path(*file).replace_extension(".rooms.json");
    if (!is_file(rooms)) continue;
    weigh_new_classes(ontology, uncounted, read_reference_rooms(rooms));
    break;
  }
  return ontology;
}

Ontology find_ontology(const std::string& name_or_path) {
  const fs::path path = locate(name_or_path, {});
  if (path.empty()) {
    fail_data("", "", "there is no ontology '" + name_or_path + "'",
              suggestion(fs::path(name_or_path).stem().string(), known_ontologies()));
  }
  return read_ontology(path);
}

std::vector<int> with_parents(const Ontology& ontology, int class_index) {
  std::vector<int> line;
  for (int c = class_index; c >= 0 && line.size() <= ontology.classes.size();) {
    line.push_back(c);
    const auto& parent = ontology.classes[c].parent;
    c = parent.empty() ? -1 : ontology.find(parent);
  }
  std::reverse(line.begin(), line.end());
  return line;
}

int class_above(const Ontology& ontology, int c) {
  const auto& description = ontology.classes[c];
  if (!description.parent.empty()) return ontology.find(description.parent);
  return description.part_of.empty() ? -1 : ontology.find(description.part_of);
}

bool is_ancestor(const Ontology& ontology, int ancestor, int c) {
  for (std::size_t steps = 0; c >= 0 && steps <= ontology.classes.size(); ++steps) {
    if (c == ancestor) return true;
    c = class_above(ontology, c);
  }
  return false;
}

bool are_akin(const Ontology& ontology, int a, int b) {
  return is_ancestor(ontology, a, b) || is_ancestor(ontology, b, a);
}

bool only_a_member(const Ontology& ontology, int class_index) {
  const auto& description = ontology.classes[class_index];
  if (description.part_of.empty()) return false;
  const int whole = ontology.find(description.part_of);
  for (std::size_t g = 0; g < ontology.classes.size(); ++g) {
    const int group = static_cast<int>(g);
    if (group != whole && ontology.classes[g].part_of != description.part_of) continue;
    for (const auto& clause : all_clauses(ontology, group)) {
      if (clause.kind == ClauseKind::group && clause.target == description.name()) return true;
    }
  }
  return false;
}

std::vector<Clause> all_clauses(const Ontology& ontology, int class_index) {
  std::vector<Clause> clauses;
  for (const int c : with_parents(ontology, class_index)) {
    const auto& own = ontology.classes[c].clauses;
    clauses.insert(clauses.end(), own.begin(), own.end());
  }
  return clauses;
}

std::vector<int> evaluation_order(const Ontology& ontology) {
  const int count = static_cast<int>(ontology.classes.size());
  std::vector<std::vector<int>> needs(count);
  for (int c = 0; c < count; ++c) {
    const auto& description = ontology.classes[c];
    if (!description.parent.empty()) needs[c].push_back(ontology.find(description.parent));
    const std::function<void(const Clause&)> add_targets = [&](const Clause& clause) {
      if (!clause.target.empty()) needs[c].push_back(ontology.find(clause.target));
      for (const auto& nested : clause.target_clauses) add_targets(nested);
    };
    for (const auto& clause : description.clauses) {
      if (!clause.usually) add_targets(clause);
    }
  }
  // Tarjan's strongly connected components come out with what is needed first (Tarjan, SIAM J.
  // Comput. 1, 1972).
  std::vector<int> index(count, -1), low(count, 0), order, stack;
  std::vector<bool> on_stack(count, false);
  int next = 0;
  const std::function<void(int)> visit = [&](int v) {
    index[v] = low[v] = next++;
    stack.push_back(v);
    on_stack[v] = true;
    for (const int w : needs[v]) {
      if (w < 0) continue;
      if (index[w] < 0) {
        visit(w);
        low[v] = std::min(low[v], low[w]);
      } else if (on_stack[w]) {
        low[v] = std::min(low[v], index[w]);
      }
    }
    if (low[v] != index[v]) return;
    std::vector<int> component;
    for (int w = -1; w != v;) {
      w = stack.back();
      stack.pop_back();
      on_stack[w] = false;
      component.push_back(w);
    }
    const bool self = std::find(needs[v].begin(), needs[v].end(), v) != needs[v].end();
    if (component.size() > 1 || self) {
      // Walk along required clauses inside the component until a class repeats: that is the circle
      // in its own words.
      std::vector<int> walk = {*std::min_element(component.begin(), component.end())};
      while (std::count(walk.begin(), walk.end(), walk.back()) < 2) {
        for (const int w : needs[walk.back()]) {
          if (std::find(component.begin(), component.end(), w) != component.end()) {
            walk.push_back(w);
            break;
          }
        }
      }
      const auto first = std::find(walk.begin(), walk.end(), walk.back());
      std::string circle;
      for (auto i = first; i != walk.end(); ++i)
        circle += (i == first ? "" : " needs ") + ontology.classes[*i].name();
      const auto& named = ontology.classes[*first];
      fail_data(named.file, "line " + std::to_string(named.place.line),
                "class '" + named.name() + "' can never be grounded: " + circle,
                "write 'usually' in front of one of these clauses");
    }
    order.push_back(v);
  };
  for (int c = 0; c < count; ++c) {
    if (index[c] < 0) visit(c);
  }
  return order;
}

}  // namespace scanchor
