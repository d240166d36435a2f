#pragma once
// Groups that are parts of a thing hold the rest of it together.

#include <vector>

#include "reasoning/item.hpp"
#include "reasoning/labelling.hpp"
#include "reasoning/ontology.hpp"

namespace scanchor {

/// The frame of a desk is a group and a part. Pieces of the desk (and its other parts) whose middle
/// lies within the box of the frame are one desk with it, the largest piece in front. Where no
/// piece has a name of its own, the frame stands for the desk: who sees it sees a desk, and what
/// has no name and lies wholly within its box is the desk's as well. A group within the box that is
/// such a thing already, the boards of a shelf between its panels, is one with it too. `groups`:
/// entities that own their members.
void hold_together(const std::vector<std::int32_t>& groups, const std::vector<Item>& items,
                   const Ontology& ontology, Labelling& labelling);

}  // namespace scanchor
