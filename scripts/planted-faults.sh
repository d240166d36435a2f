#!/usr/bin/env bash
# Does the gate catch what it should? Plants three faults and shows what `scanchor check` says of each: the paper's delta doubled,
# its k halved, and two labels swapped in the descriptions. Some minutes; the scenes are those of the training part.
set -euo pipefail
cd "$(dirname "$0")/.."
scanchor=${SCANCHOR:-build/release/bin/scanchor}
scenes=${SCENES:-100}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
sed -e "s/^scenes: .*/scenes: $((2 * scenes))/" -e 's/^name: .*/name: faults/' suites/quick.yaml >"$work/faults.yaml"
# With the rates that were counted, so that nothing but the names changes.
for file in office.sdl office.background.json; do
  sed -e 's/\bdesk\b/DESK/g' -e 's/\bcabinet\b/desk/g' -e 's/\bDESK\b/cabinet/g' ontologies/$file >"$work/${file/office/swapped}"
done

"$scanchor" baseline "$work/faults.yaml" --split train --method paper --baseline "$work/paper.json" --quiet
"$scanchor" baseline "$work/faults.yaml" --split train --baseline "$work/default.json" --quiet

missed=0
plant() {  # title, arguments of check...
  local title=$1 code=0
  shift
  printf '\n%s: scanchor check %s\n' "$title" "$(printf '%s ' "$@" | sed "s#$work/##g")"
  "$scanchor" check "$work/faults.yaml" --split train "$@" || code=$?
  [ "$code" -eq 1 ] || { printf 'NOT CAUGHT (exit code %s)\n' "$code"; missed=1; }
}
# delta bounds a mean square: 9 instead of 2.25 squared sigmas is twice the distance.
plant "delta doubled" --method paper --baseline "$work/paper.json" --set perceive.paper_delta=9
plant "k halved" --method paper --baseline "$work/paper.json" --set perceive.paper_neighbours=10
plant "two labels swapped" --baseline "$work/default.json" --ontology "$work/swapped.sdl"
exit "$missed"
