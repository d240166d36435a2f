#include "apps/command.hpp"

namespace scanchor::apps {

void add_all_verbs(CLI::App& root, ExitCodeSlot& code) {
  add_run(root, code);
  add_generate(root, code);
  add_label(root, code);
  add_segment(root, code);
  add_score(root, code);
  add_explain(root, code);
  add_find(root, code);
  add_ontology(root, code);
  add_render(root, code);
  add_report(root, code);
  add_figures(root, code);
  add_gallery(root, code);
  add_fit(root, code);
  add_fit_relations(root, code);
  add_check(root, code);
  add_baseline(root, code);
  add_sweep(root, code);
  add_blame(root, code);
  add_shrink(root, code);
}

}  // namespace scanchor::apps
