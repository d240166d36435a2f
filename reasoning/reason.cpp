#include "reasoning/reason.hpp"

#include "core/error.hpp"
#include "reasoning/assign.hpp"
#include "reasoning/item.hpp"
#include "reasoning/levelled.hpp"
#include "reasoning/matcher.hpp"
#include "reasoning/paper_mode.hpp"

namespace scanchor {

void ReasonOptions::describe(OptionList& list) {
  list.add("mode", mode, "likelihood ratios, or the paper's disparity and product chain",
           {"default", "paper"});
  list.add("up", up, "direction against gravity \"x,y,z\" in the cloud's frame, or \"auto\"");
  list.add("up_sigma_deg", up_sigma_deg, "deg", "standard deviation of the given up direction", 0.0,
           30.0);
  list.add("report_probability", report_probability, "1", "a class is reported from here on", 0.0,
           1.0);
  list.add("ambiguity_margin", ambiguity_margin, "1", "two classes nearer than that are ambiguous",
           0.0, 1.0);
  list.add("alternatives", alternatives,
           "read surfaces anew, cut or joined, where that explains them better by far");
}

Labelling reason(const Surfaces& surfaces, const Ontology& ontology, const ReasonOptions& options) {
  if (options.mode != "default" && options.mode != "paper") {
    fail_usage("unknown mode of reasoning '" + options.mode + "'", "known are: default, paper");
  }
  for (std::size_t i = 0; i < surfaces.surfaces.size(); ++i) {
    const auto& surface = surfaces.surfaces[i];
    const bool finite = surface.plane.normal.allFinite() && surface.plane.centroid.allFinite() &&
                        surface.plane.normal.norm() > 0.5;
    if (!finite) fail_data("surfaces", "surface " + std::to_string(i), "its plane is not finite");
  }
  const Levelled levelled = level(surfaces, options);
  const UpDirection& up = levelled.up;
  if (options.mode == "paper") return reason_as_paper(surfaces, ontology, options, up);

  Labelling labelling;
  labelling.mode = options.mode;
  labelling.ontology = ontology.name;
  labelling.up = up.up;
  labelling.up_sigma = up.sigma;

  const Eigen::Matrix3d& R_level_cloud = levelled.R_level_cloud;
  Matcher matcher(ontology, make_items(surfaces, R_level_cloud), levelled.around);
  matcher.run();
  assign_labels(matcher, surfaces, ontology, options, R_level_cloud.transpose(), up.upright,
                labelling);
  return labelling;
}

}  // namespace scanchor
