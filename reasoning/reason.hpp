#pragma once
// The stage from surfaces to labels.

#include <optional>
#include <string>

#include "core/options.hpp"
#include "perception/surface.hpp"
#include "reasoning/labelling.hpp"
#include "reasoning/ontology.hpp"

namespace scanchor {

struct ReasonOptions {
  std::string mode =
      "default";  ///< "default" (likelihood ratios) or "paper" (disparity and product chain)
  std::string up =
      "0,0,1";  ///< direction "x,y,z" in the cloud's frame, or "auto": found from the surfaces
  double up_sigma_deg =
      2.0;  ///< how far the given direction may be off before the floor and walls refine it
  double report_probability = 0.5;  ///< a class is reported from here on, below it is "unknown"
  double ambiguity_margin = 0.1;    ///< two classes nearer than that are "ambiguous"
  bool alternatives = true;  ///< surfaces may be cut or joined where that explains them better
  void describe(OptionList& list);
};

/// Names the surfaces by the descriptions. Deterministic; independent of the order of the surfaces.
Labelling reason(const Surfaces& surfaces, const Ontology& ontology, const ReasonOptions& options);

}  // namespace scanchor
