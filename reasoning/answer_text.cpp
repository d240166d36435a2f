#include <fmt/format.h>

#include "core/json.hpp"
#include "reasoning/answer.hpp"

namespace scanchor {

namespace {

std::string measured(double value, double sigma, const std::string& unit) {
  const int digits = unit == "deg" ? 1 : 2;
  std::string text = fmt::format("{:.{}f}", value, digits);
  if (sigma > 0.0) text += fmt::format(" +- {:.{}f}", sigma, digits);
  return unit == "1" ? text : text + " " + unit;
}

std::string named(const SceneThings& scene, std::int32_t id) {
  return fmt::format("{} ({})", id, scene.entity(id).label);
}

void put_steps(std::string& out, const std::vector<AnswerStep>& steps, const SceneThings& scene,
               int indent) {
  for (const auto& step : steps) {
    out += std::string(static_cast<std::size_t>(indent), ' ') + step.text + ": ";
    if (!step.unit.empty()) out += measured(step.measured, step.sigma, step.unit) + ", ";
    out += step.unseen ? "not seen, cannot tell"
                       : fmt::format("{} ({:.2f})", step.likelihood >= 0.5 ? "holds" : "fails",
                                     step.likelihood);
    for (std::size_t i = 0; i < step.targets.size(); ++i)
      out += (i == 0 ? " on " : ", ") + named(scene, step.targets[i]);
    if (step.needed) out += "; it would hold from " + measured(*step.needed, 0.0, step.unit);
    out += "\n";
    put_steps(out, step.because, scene, indent + 2);
  }
}

void put_thing(std::string& out, const AnswerThing& thing, const SceneThings& scene) {
  const Entity& entity = scene.entity(thing.id);
  out += fmt::format("{:>4}  {:<16} {:>5.2f}  {:>7.2f} {:>7.2f} {:>7.2f}  {:>6.2f}{:>7.2f}\n",
                     thing.id, thing.label, thing.probability, entity.center.x(), entity.center.y(),
                     entity.center.z(), entity.size.x(), entity.size.y());
  put_steps(out, thing.steps, scene, 6);
}

void put_miss(std::string& out, const Answer& answer, const SceneThings& scene) {
  if (!answer.closest) {
    if (!answer.failing.empty()) out += "nothing in the scene " + answer.failing + "\n";
    return;
  }
  out += "closest: " + named(scene, answer.closest->id) + " fails at '" + answer.failing + "'\n";
  if (answer.closest->of_class < 0.5)
    out += fmt::format("      {} ({:.2f})\n", answer.failing, answer.closest->of_class);
  put_steps(out, answer.closest->steps, scene, 6);
}

Json step_to_json(const AnswerStep& step) {
  Json json;
  json["clause"] = step.text;
  json["likelihood"] = step.likelihood;
  if (!step.unit.empty()) {
    json["measured"] = step.measured;
    json["sigma"] = step.sigma;
    json["unit"] = step.unit;
  }
  if (step.needed) json["needed"] = *step.needed;
  if (step.unseen) json["seen"] = false;
  if (!step.targets.empty()) json["targets"] = step.targets;
  if (!step.because.empty()) {
    json["because"] = Json::array();
    for (const auto& inner : step.because) json["because"].push_back(step_to_json(inner));
  }
  return json;
}

Json place_to_json(const SceneThings& scene, std::int32_t id) {
  const Entity& entity = scene.entity(id);
  Json json;
  json["id"] = id;
  json["class"] = entity.label;
  json["center"] = to_json(entity.center);
  json["size"] = to_json(entity.size);
  json["pose"] = to_json(entity.pose);
  return json;
}

Json thing_to_json(const AnswerThing& thing, const SceneThings& scene) {
  Json json = place_to_json(scene, thing.id);
  json["probability"] = thing.probability;
  json["of_class"] = thing.of_class;
  const Item& item = scene.item(thing.id);
  json["completeness"] = 1.0 - item.area.hidden;
  json["anchors"] = Json::array();
  for (const auto a : thing.anchors) json["anchors"].push_back(place_to_json(scene, a));
  json["why"] = Json::array();
  for (const auto& step : thing.steps) json["why"].push_back(step_to_json(step));
  return json;
}

const char* kind_word(Query::Kind kind) {
  switch (kind) {
    case Query::Kind::find:
      return "find";
    case Query::Kind::count:
      return "count";
    case Query::Kind::exists:
      return "exists";
    case Query::Kind::distance:
      return "distance";
  }
  return "";
}

}  // namespace

std::string answer_text(const Answer& answer, const SceneThings& scene) {
  std::string out = "read as: " + query_text(answer.query) + "\n";
  const bool found = !answer.things.empty();
  switch (answer.query.kind) {
    case Query::Kind::find:
      if (answer.status == Answer::Status::ok)
        out += answer.things.size() == 1 ? "found one:\n"
                                         : fmt::format("found {}:\n", answer.things.size());
      break;
    case Query::Kind::count: {
      out += fmt::format("there {} {} (expected {:.1f}", answer.count == 1 ? "is" : "are",
                         answer.count, answer.expected);
      for (std::size_t k = 0; k < answer.distribution.size(); ++k) {
        if (answer.distribution[k] >= 0.05)
          out += fmt::format("; {}: {:.2f}", k, answer.distribution[k]);
      }
      out += ")\n";
      break;
    }
    case Query::Kind::exists:
      out += fmt::format("{} (probability of at least one: {:.2f})\n", found ? "yes" : "no",
                         answer.exists);
      break;
    case Query::Kind::distance:
      if (answer.distance)
        out += measured(answer.distance->measured, answer.distance->sigma, "m") + "\n";
      break;
  }
  if (answer.status == Answer::Status::ambiguous)
    out += "ambiguous" + (answer.ask.empty() ? "" : ": " + answer.ask) + "\n";
  if (answer.status == Answer::Status::not_found) out += "not found\n";
  if (answer.status == Answer::Status::not_seen)
    out += "not seen: where it would be, the scan has not looked\n";
  for (const auto& thing : answer.things) put_thing(out, thing, scene);
  if (answer.things.empty() || answer.status == Answer::Status::not_found ||
      answer.status == Answer::Status::not_seen)
    put_miss(out, answer, scene);
  return out;
}

nlohmann::ordered_json answer_to_json(const Answer& answer, const SceneThings& scene) {
  Json json;
  json["format"] = "scanchor answer 1";
  json["query"] = answer.query.text;
  json["read_as"] = query_text(answer.query);
  json["kind"] = kind_word(answer.query.kind);
  json["status"] = status_word(answer.status);
  json["frame"] = "cloud";
  if (answer.query.kind == Query::Kind::count) {
    json["count"] = answer.count;
    json["expected"] = answer.expected;
    json["distribution"] = answer.distribution;
  }
  if (answer.query.kind == Query::Kind::exists) {
    json["exists"] = !answer.things.empty();
    json["probability"] = answer.exists;
  }
  if (answer.distance) {
    json["distance"] = answer.distance->measured;
    json["sigma"] = answer.distance->sigma;
    json["unit"] = "m";
  }
  json["answers"] = Json::array();
  for (const auto& thing : answer.things) json["answers"].push_back(thing_to_json(thing, scene));
  if (!answer.ask.empty()) json["ask"] = answer.ask;
  if (!answer.failing.empty()) json["fails_at"] = answer.failing;
  if (answer.closest) {
    json["closest_miss"] = thing_to_json(*answer.closest, scene);
  }
  return json;
}

}  // namespace scanchor
