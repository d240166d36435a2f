#include "core/error.hpp"
#include "core/json.hpp"
#include "reasoning/background.hpp"

namespace scanchor {

nlohmann::ordered_json background_to_json(const Background& background) {
  Json json;
  json["format"] = "scanchor background 1";
  json["fitted_on"] = background.fitted_on;
  json["unknown_prior"] = background.unknown_prior;
  json["temperature"] = background.temperature;
  Json priors = Json::object();
  for (const auto& [name, prior] : background.priors) priors[name] = prior;
  json["priors"] = priors;
  Json rates = Json::array();
  for (const auto& rate : background.rates) {
    rates.push_back({{"class", rate.class_name},
                     {"clause", rate.clause},
                     {"hit_rate", rate.hit_rate},
                     {"background", rate.background},
                     {"weight", rate.weight}});
  }
  json["clauses"] = rates;
  return json;
}

Background background_from_json(const nlohmann::ordered_json& json, const std::string& file) {
  const JsonReader reader(json, file);
  reader.only({"format", "fitted_on", "unknown_prior", "temperature", "priors", "clauses"});
  if (reader.at("format").text() != "scanchor background 1") {
    reader.at("format").fail("is not 'scanchor background 1'", "fit it again with 'scanchor fit'");
  }
  Background background;
  background.fitted_on = reader.at("fitted_on").text();
  background.unknown_prior = reader.at("unknown_prior").number_in(1e-9, 1.0);
  background.temperature = reader.at("temperature").number_in(1e-3, 10.0);
  const auto priors = reader.at("priors");
  for (const auto& name : priors.keys()) {
    background.priors.emplace_back(name, priors.at(name).number_in(1e-12, 1.0));
  }
  const auto rates = reader.at("clauses");
  for (std::size_t i = 0; i < rates.size(); ++i) {
    const auto rate = rates.at(i);
    background.rates.push_back(
        {rate.at("class").text(), rate.at("clause").text(),
         rate.at("hit_rate").number_in(1e-9, 1.0 - 1e-9),
         rate.at("background").number_in(1e-9, 1.0 - 1e-9),
         rate.has("weight") ? rate.at("weight").number_in(0.0, 100.0) : 1.0});
  }
  return background;
}

Background read_background(const std::filesystem::path& path) {
  return background_from_json(read_json(path), path.string());
}

void write_background(const std::filesystem::path& path, const Background& background) {
  write_json(path, background_to_json(background));
}

}  // namespace scanchor
