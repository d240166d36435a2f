#include "reasoning/sdl_format.hpp"

#include "reasoning/sdl_parser.hpp"
#include "reasoning/sdl_words.hpp"

namespace scanchor {

namespace {

void put_comments(std::string& out, const std::vector<std::string>& comments,
                  const std::string& indent) {
  bool blank = false;
  for (const auto& comment : comments) {
    if (comment == blank_line) {
      if (!blank) out += "\n";
      blank = true;
      continue;
    }
    blank = false;
    out += indent + (comment.empty() ? "#" : "# " + comment) + "\n";
  }
}

void put_line(std::string& out, const std::string& line, const std::string& comment) {
  out += line + (comment.empty() ? "" : "  # " + comment) + "\n";
}

void put_clause(std::string& out, const Clause& clause) {
  put_comments(out, clause.comments, "    ");
  if (clause.kind != ClauseKind::group) {
    put_line(out, "    " + clause_text(clause), clause.comment);
    return;
  }
  Clause head = clause;
  head.pairwise.clear();
  put_line(out, "    " + clause_text(head), clause.comment);
  for (std::size_t i = 0; i < clause.pairwise.size(); ++i) {
    put_line(out, "        " + pair_text(clause.pairwise[i]),
             i < clause.pair_comments.size() ? clause.pair_comments[i] : "");
  }
}

}  // namespace

std::string ontology_to_sdl(const Ontology& ontology) {
  std::string out;
  for (const auto& import : ontology.imports) out += "import " + import + "\n";
  for (const auto& description : ontology.classes) {
    if (!out.empty()) out += "\n";
    put_comments(out, description.comments, "");
    std::string header = description.axiom ? "axiom " : "class ";
    for (std::size_t i = 0; i < description.names.size(); ++i)
      header += (i == 0 ? "" : ", ") + description.names[i];
    if (!description.parent.empty()) header += " is a " + description.parent;
    if (!description.part_of.empty()) header += " part of " + description.part_of;
    put_line(out, header + ":", description.comment);
    if (description.unique) out += "    unique\n";
    if (description.several_faces) out += "    several faces\n";
    for (const auto& clause : description.clauses) put_clause(out, clause);
  }
  if (!ontology.closing_comments.empty()) {
    out += "\n";
    put_comments(out, ontology.closing_comments, "");
  }
  return out;
}

std::string format_sdl(const std::string& text, const std::string& file) {
  return ontology_to_sdl(parse_sdl(text, file));
}

}  // namespace scanchor
