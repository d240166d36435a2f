#pragma once
// Several faces that are one thing: the sides of a cabinet, the halves of a desk that a shadow
// parts, a pane and the frame before it.

#include "reasoning/labelling.hpp"
#include "reasoning/matcher.hpp"
#include "reasoning/ontology.hpp"

namespace scanchor {

/// Surfaces of one class that may have `several faces` become one thing where they
///   meet at a right angle,
///   lie in one plane, no further apart than a shadow covers (0.4 m), or
///   lie one before the other or beside it, turned by at most 37 degrees and 0.3 m deep,
/// the last two only while together they are no larger than the class. The largest face stands for
/// the thing: the others get it for their `whole`, and their points go to it. Faces that are
/// already a part or a member of something are left alone.
void gather_faces(const Matcher& matcher, const Ontology& ontology, Labelling& labelling);

/// May the part belong to this thing of the class? Not where both together would be more than a
/// tenth longer, along the longer side of the thing, than the class is at most.
bool part_fits(const Matcher& matcher, int whole_class, std::int32_t whole, std::int32_t part);

}  // namespace scanchor
