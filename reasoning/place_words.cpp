// Questions for room: how they are read, and their answers in words and JSON.

#include <fmt/format.h>

#include <cstdlib>

#include "core/error.hpp"
#include "core/json.hpp"
#include "core/math.hpp"
#include "core/text.hpp"
#include "reasoning/places.hpp"

namespace scanchor {
namespace {

/// Reads from the front of the question, in small letters.
class Words {
 public:
  explicit Words(const std::string& text) : text_(text) {
    for (char& c : text_) {
      if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    while (!text_.empty() && (text_.back() == '?' || text_.back() == ' ')) text_.pop_back();
  }
  bool accept(std::string_view words) {
    skip();
    if (text_.compare(at_, words.size(), words) != 0) return false;
    const std::size_t end = at_ + words.size();
    if (end < text_.size() && text_[end] != ' ') return false;
    at_ = end;
    return true;
  }
  std::optional<double> number() {
    skip();
    const char* from = text_.c_str() + at_;
    if (at_ >= text_.size() || !((*from >= '0' && *from <= '9') || *from == '.'))
      return std::nullopt;
    char* end = nullptr;
    const double value = std::strtod(from, &end);
    at_ += static_cast<std::size_t>(end - from);
    return value;
  }
  bool times() {
    skip();
    if (accept("by")) return true;
    if (at_ >= text_.size() || text_[at_] != 'x') return false;
    ++at_;
    return true;
  }
  double unit() {
    for (const auto& [word, metres] :
         {std::pair{"mm", 0.001}, std::pair{"cm", 0.01}, std::pair{"m", 1.0}}) {
      if (accept(word)) return metres;
    }
    fail("a size needs its unit: m, cm or mm");
  }
  [[noreturn]] void fail(const std::string& cause, const std::string& remedy = "") const {
    fail_usage(fmt::format("question:1:{}: {}", at_ + 1, cause), remedy);
  }
  /// In its place, so that columns of messages are those of the whole question.
  [[nodiscard]] std::string rest() const { return std::string(at_, ' ') + text_.substr(at_); }

 private:
  void skip() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
  }
  std::string text_;
  std::size_t at_ = 0;
};

double side(Words& words, double value, double metres) {
  const double length = value * metres;
  if (!(length > 0.0 && length <= 10.0)) words.fail("a size is above 0 and at most 10 m");
  return length;
}

void free_size(Words& words, PlaceQuestion& question) {
  const auto first = words.number();
  if (!first) words.fail("a place of what size?", "write 'free place of 30 x 40 cm on a desk'");
  if (!words.times()) words.fail("a free place has two sides", "write 'of 30 x 40 cm'");
  const auto second = words.number();
  if (!second) words.fail("a free place has two sides", "write 'of 30 x 40 cm'");
  const double metres = words.unit();
  question.length = side(words, std::max(*first, *second), metres);
  question.width = side(words, std::min(*first, *second), metres);
}

void robot_size(Words& words, PlaceQuestion& question) {
  const auto across = words.number();
  if (!across) words.fail("a robot of what width?", "write 'of 60 cm'");
  question.diameter = side(words, *across, words.unit());
}

bool in_front(Words& words) {
  return words.accept("in front of") || words.accept("before") || words.accept("at");
}

std::string size_text(const PlaceQuestion& question) {
  return question.kind == PlaceQuestion::Kind::free_place
             ? fmt::format("{:g} x {:g} cm", 100.0 * question.length, 100.0 * question.width)
             : fmt::format("{:g} cm", 100.0 * question.diameter);
}

}  // namespace

std::optional<PlaceQuestion> parse_place_question(const std::string& text,
                                                  const Ontology& ontology) {
  PlaceQuestion question;
  question.text = text;
  Words words(text);
  const bool asked = words.accept("find") || words.accept("where is") || words.accept("show") ||
                     words.accept("is there");
  static_cast<void>(asked);
  if (!words.accept("a")) words.accept("the");
  if (words.accept("free place") || words.accept("free space")) {
    if (words.accept("of")) free_size(words, question);
    if (!words.accept("on"))
      words.fail("a free place is on a thing", "write 'free place of 30 x 40 cm on a desk'");
  } else {
    question.kind = PlaceQuestion::Kind::standing_place;
    if (words.accept("place to stand") || words.accept("standing place")) {
      if (words.accept("of")) robot_size(words, question);
    } else if (words.accept("where could") || words.accept("where can")) {
      if (!words.accept("a")) words.accept("the");
      if (!words.accept("robot")) words.fail("who is to stand there?", "write 'a robot'");
      if (words.accept("of")) robot_size(words, question);
      if (!words.accept("stand")) words.fail("a robot stands", "write 'stand in front of ...'");
    } else {
      return std::nullopt;
    }
    if (!in_front(words))
      words.fail("a robot stands in front of a thing",
                 "write 'place to stand in front of the cabinet'");
  }
  question.thing = parse_query(words.rest(), ontology);
  if (question.thing.kind != Query::Kind::find)
    words.fail("a place is at a thing, not at a number or a distance");
  return question;
}

std::string place_question_text(const PlaceQuestion& question) {
  const bool free = question.kind == PlaceQuestion::Kind::free_place;
  return fmt::format("{} of {} {} {}", free ? "a free place" : "a place to stand",
                     size_text(question), free ? "on" : "in front of", query_text(question.thing));
}

std::string places_text(const PlaceAnswer& answer, const SceneThings& scene) {
  std::string out = "read as: " + place_question_text(answer.question) + "\n";
  if (answer.thing.things.empty()) {
    // Why there is no such thing is the answer.
    const std::string miss = answer_text(answer.thing, scene);
    return out + miss.substr(miss.find('\n') + 1);
  }
  if (answer.status == Answer::Status::ambiguous)
    out += "ambiguous" + (answer.thing.ask.empty() ? "" : ": " + answer.thing.ask) + "\n";
  if (answer.status == Answer::Status::not_found) out += "there is no room\n";
  if (answer.status == Answer::Status::not_seen) out += "only where the scan has not looked:\n";
  const bool free = answer.question.kind == PlaceQuestion::Kind::free_place;
  for (const auto& place : answer.places) {
    const Eigen::Vector3d at = place.T_cloud_place.translation();
    const Eigen::Vector3d x = place.T_cloud_place.linear().col(0);
    out += fmt::format("{} {} ({}): {:.2f} {:.2f} {:.2f}, turned {:.0f} deg",
                       free ? "on" : "before", place.thing, scene.entity(place.thing).label, at.x(),
                       at.y(), at.z(), degrees(std::atan2(x.y(), x.x())));
    if (free) {
      out += fmt::format(", {:.0f} cm free around it", 100.0 * place.margin);
    } else {
      out += fmt::format(", {:.2f} m before it", place.distance);
    }
    if (place.unseen >= 0.01) out += fmt::format(", {:.0f} % of it not seen", 100.0 * place.unseen);
    out += "\n";
  }
  return out;
}

nlohmann::ordered_json places_to_json(const PlaceAnswer& answer, const SceneThings& scene) {
  Json json;
  json["format"] = "scanchor answer 1";
  json["query"] = answer.question.text;
  json["read_as"] = place_question_text(answer.question);
  const bool free = answer.question.kind == PlaceQuestion::Kind::free_place;
  json["kind"] = free ? "free_place" : "standing_place";
  json["status"] = status_word(answer.status);
  json["frame"] = "cloud";
  json["places"] = Json::array();
  for (const auto& place : answer.places) {
    Json one;
    one[free ? "on" : "before"] = place.thing;
    one["class"] = scene.entity(place.thing).label;
    one["pose"] = to_json(place.T_cloud_place);
    one["size"] = {place.size.x(), place.size.y()};
    if (free) {
      one["margin"] = place.margin;
      one["corners"] = Json::array();
      for (const auto& [u, v] : {std::pair{-0.5, -0.5}, std::pair{0.5, -0.5}, std::pair{0.5, 0.5},
                                 std::pair{-0.5, 0.5}}) {
        one["corners"].push_back(to_json(Eigen::Vector3d(
            place.T_cloud_place * Eigen::Vector3d(u * place.size.x(), v * place.size.y(), 0.0))));
      }
    } else {
      one["distance"] = place.distance;
    }
    one["unseen"] = place.unseen;
    json["places"].push_back(std::move(one));
  }
  json["thing"] = answer_to_json(answer.thing, scene);
  return json;
}

}  // namespace scanchor
