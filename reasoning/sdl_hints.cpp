#include "reasoning/sdl_hints.hpp"

#include <algorithm>
#include <string_view>

#include "core/text.hpp"
#include "reasoning/sdl_words.hpp"

namespace scanchor {

namespace {

/// Words of every day and what the language says; several words first.
struct Everyday {
  std::string_view words;
  std::string_view means;
};

/// Relations to a thing: what follows is the target.
constexpr Everyday everyday_relations[] = {
    {"next to", "near"},
    {"close to", "near"},
    {"adjacent to", "touching"},
    {"attached to", "touching"},
    {"connected to", "touching"},
    {"mounted on", "coplanar within 10 cm with"},
    {"recessed in", "set back 3..35 cm behind"},
    {"let into", "set back 3..35 cm behind"},
    {"hanging on", "coplanar within 10 cm with"},
    {"on top of", "on"},
    {"standing on", "on"},
    {"placed on", "on"},
    {"perpendicular to", "orthogonal to"},
    {"beside", "near"},
    {"by", "near"},
    {"at", "near"},
    {"around", "near"},
    {"under", "below"},
    {"beneath", "below"},
    {"underneath", "below"},
    {"over", "above"},
    {"touches", "touching"},
    {"against", "touching"},
    {"supports", "supporting"},
    {"holds", "supporting"},
    {"carries", "supporting"},
    {"contains", "supporting"},
    {"within", "inside"},
    {"in", "inside"},
    {"parallel", "parallel to"},
    {"orthogonal", "orthogonal to"},
    {"perpendicular", "orthogonal to"},
    {"coplanar", "coplanar with"},
    {"higher", "higher than"},
    {"lower", "lower than"},
    {"without", "not near"},
};

constexpr Everyday everyday_features[] = {
    {"length", "extension"},   {"long", "extension"},    {"size", "extension"},
    {"diameter", "extension"}, {"depth", "width"},       {"deep", "width"},
    {"wide", "width"},         {"breadth", "width"},     {"thickness", "width"},
    {"tall", "height"},        {"high", "height"},       {"surface", "area"},
    {"ratio", "elongation"},   {"aspect", "elongation"}, {"altitude", "elevation"},
};

constexpr Everyday everyday_directions[] = {
    {"flat", "horizontal"},          {"level", "horizontal"},      {"upright", "vertical"},
    {"standing", "vertical"},        {"rectangle", "rectangular"}, {"square", "elongation 1..1.15"},
    {"round", "elongation 1..1.15"}, {"biggest", "largest"},       {"top", "highest"},
};

constexpr std::string_view unmeasured[] = {"color",    "colour",  "red",   "blue",    "green",
                                           "white",    "black",   "brown", "grey",    "gray",
                                           "yellow",   "wooden",  "metal", "plastic", "glass",
                                           "material", "texture", "soft",  "shiny",   "wood"};

constexpr std::string_view maybe[] = {"optional",  "optionally", "maybe",    "sometimes", "often",
                                      "typically", "mostly",     "probably", "should"};

constexpr std::string_view filler[] = {"is", "are", "it", "must", "be", "has", "have", "to"};

template <typename List>
bool holds(const List& list, const std::string& word) {
  return std::find(std::begin(list), std::end(list), word) != std::end(list);
}

/// Words from the cursor on, up to `ahead` of them left out.
std::string words_from(const SdlCursor& cursor, std::size_t ahead) {
  std::string words;
  for (std::size_t i = ahead; cursor.peek(i).kind != Token::Kind::end; ++i) {
    const auto& token = cursor.peek(i);
    const bool joined = words.empty() || token.kind == Token::Kind::comma ||
                        token.kind == Token::Kind::dots || words.ends_with("..");
    words += (joined ? "" : " ") + token.text;
  }
  return words;
}

std::string article_before(const std::string& words) {
  if (words.empty()) return "a desk";
  for (const auto* article : {"a ", "an ", "the "}) {
    if (words.starts_with(article)) return words;
  }
  return with_article(words);
}

std::string write_this(const std::string& words) { return "write '" + words + "'"; }

}  // namespace

std::string clause_hint(const SdlCursor& cursor) {
  const Token& first = cursor.peek();
  if (first.kind == Token::Kind::end) return "write for example: horizontal";
  if (first.kind == Token::Kind::number)
    return "a clause begins with what is measured: 'height 0.4..0.5 m' or 'elevation 0.4..0.5 m "
           "above a floor'";
  if (first.kind == Token::Kind::other && first.text == "-") return "leave the '-' out";
  if (holds(maybe, first.text)) {
    const std::string rest = words_from(cursor, 1);
    return write_this("usually " + (rest.empty() ? "near a desk" : rest));
  }
  if (holds(unmeasured, first.text))
    return "colours and materials are not measured; sizes, directions and relations are";
  std::size_t skip = 0;
  while (holds(filler, cursor.peek(skip).text)) ++skip;
  if (skip > 0) {
    const std::string rest = words_from(cursor, skip);
    for (const auto* article : {"a ", "an ", "the "}) {
      if (rest.starts_with(article))
        return "a thing is no clause: say how it lies to this one, 'supporting " + rest +
               "' or 'near " + rest + "'; for 'is a' see the header, 'class x is a y:'";
    }
    return rest.empty() ? "" : write_this(rest);
  }
  if (first.text == "with" || first.text == "contains")
    return "say how the two lie to each other: 'supporting " +
           article_before(words_from(cursor, 1)) + "' or 'near " +
           article_before(words_from(cursor, 1)) + "'";
  if (first.text == "if" || first.text == "or" || first.text == "and" || first.text == "either")
    return "every line holds by itself; for 'or' describe two classes, one a kind of the other";
  for (const auto& word : everyday_features) {
    if (first.text != word.words) continue;
    const std::string rest = words_from(cursor, 1);
    return write_this(std::string(word.means) + " " + (rest.empty() ? "0.4..0.5 m" : rest));
  }
  for (const auto& word : everyday_directions) {
    if (first.text == word.words && cursor.peek(1).kind == Token::Kind::end)
      return write_this(std::string(word.means));
  }
  for (const auto& word : everyday_relations) {
    if (!cursor.at_words(word.words)) continue;
    return write_this(std::string(word.means) + " " +
                      article_before(words_from(cursor, split_words(word.words).size())));
  }
  return "";
}

std::string denial_hint(const SdlCursor& cursor) {
  for (const auto* word : {"horizontal", "vertical", "rectangular"}) {
    if (cursor.at_word(word))
      return "'not' denies a relation, as in 'not near a desk'; of directions say the one that "
             "holds";
  }
  for (const auto& feature : feature_vocabulary()) {
    if (cursor.at_word(feature.word))
      return "'not' denies a relation, as in 'not near a desk'; of sizes say the range that holds";
  }
  // "chair above": the relation is the last word, the thing in front of it.
  std::string thing;
  for (std::size_t i = 0; cursor.peek(i).kind == Token::Kind::word; ++i) {
    for (const auto& word : relation_vocabulary()) {
      const auto parts = split_words(word.words);
      if (i == 0 || cursor.peek(i).text != parts.front()) continue;
      return write_this("not " + std::string(word.words) + " " + article_before(thing));
    }
    thing += (i == 0 ? "" : " ") + cursor.peek(i).text;
  }
  if (!thing.empty()) return "say how: 'not near " + article_before(thing) + "', 'not on ...'";
  return "write for example: not near a desk";
}

std::string target_hint(const SdlCursor& cursor) {
  if (cursor.at_words("top of")) return write_this("on " + article_before(words_from(cursor, 2)));
  if (cursor.peek().kind == Token::Kind::word)
    return write_this(article_before(words_from(cursor, 0)));
  if (cursor.peek().kind == Token::Kind::number)
    return "how many is no matter of a relation; write 'a ...'";
  return "";
}

std::string range_hint(const SdlCursor& cursor, const std::string& what) {
  const Token& first = cursor.peek();
  // What the range would be, made of the numbers and the unit that follow.
  std::vector<std::string> numbers;
  std::string unit;
  for (std::size_t i = 0; cursor.peek(i).kind != Token::Kind::end; ++i) {
    const auto& token = cursor.peek(i);
    const bool dash = token.kind == Token::Kind::word && token.text.size() > 1 &&
                      token.text.front() == '-' && token.text[1] >= '0' && token.text[1] <= '9';
    if (token.kind == Token::Kind::number) {
      numbers.push_back(token.text);
    } else if (dash) {  // "40-50"
      numbers.push_back(token.text.substr(1));
    } else if (token.kind == Token::Kind::word && find_unit(token.text) != nullptr) {
      unit = " " + token.text;
    }
  }
  if (numbers.empty()) return write_this(what + " 0.4..0.5 m");
  const std::string& a = numbers.front();
  if (numbers.size() > 1) return write_this(what + " " + a + ".." + numbers[1] + unit);
  if (first.text == ">" || first.text == "above" || first.text == "more" || first.text == "min" ||
      first.text == "minimum" || first.text == "larger" || first.text == "from")
    return write_this(what + " at least " + a + unit);
  if (first.text == "<" || first.text == "below" || first.text == "less" || first.text == "max" ||
      first.text == "maximum" || first.text == "smaller" || first.text == "up")
    return write_this(what + " at most " + a + unit);
  return write_this(what + " about " + a + unit);
}

std::string end_hint(const SdlCursor& cursor) {
  const Token& first = cursor.peek();
  if (first.kind == Token::Kind::comma || first.text == "and" || first.text == ";")
    return "one clause a line";
  if (first.text == "or") return "there is no 'or': describe two classes, one a kind of the other";
  return "";
}

std::string question_hint(const SdlCursor& cursor) {
  const Token& first = cursor.peek();
  if (holds(unmeasured, first.text))
    return "colours and materials are not measured; sizes, directions and relations are";
  if (cursor.at_words("how big") || cursor.at_words("how large") || cursor.at_words("how wide") ||
      cursor.at_words("how high") || cursor.at_words("how long"))
    return "ask for the thing: the answer has its size; in numbers with --json";
  if (first.text == "me" || first.text == "where's" || first.text == "what's")
    return "ask for the thing alone: 'the desk', or 'where is the desk'";
  if (first.text == "is" || first.text == "are" || first.text == "does" || first.text == "do")
    return "write 'is there a chair near a desk'";
  if (first.text == "or") return "there is no 'or': ask twice";
  if (first.text == "larger" || first.text == "bigger" || first.text == "smaller")
    return "write 'with area at least 1 m2', or ask for 'the largest'";
  if (first.text == "in")
    return "rooms and parts of rooms cannot be named; of things there are 'inside a', 'in front of "
           "a'";
  if (cursor.at_word("of")) return "'on top of' is 'on'";
  for (const auto& word : everyday_relations) {
    if (first.text != "without" && cursor.at_words(word.words)) {
      const std::string rest = words_from(cursor, split_words(word.words).size());
      return write_this(std::string(word.means) + " " + article_before(rest));
    }
  }
  std::vector<std::string> known = {"that", "of", "with", "without", "between", "not", "and"};
  for (const auto& word : relation_vocabulary()) known.push_back(split_words(word.words).front());
  return nearest_word(first.text, known) && first.text != "in" ? suggestion(first.text, known) : "";
}

}  // namespace scanchor
