#!/usr/bin/env bash
# Writes docs/results.md: what both methods find in rooms that were never used to choose a number. Takes some minutes.
set -euo pipefail
cd "$(dirname "$0")/.."
scanchor=${SCANCHOR:-build/release/bin/scanchor}
scenes=${SCENES:-20}
seed=7001
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

measure() {  # title, folder, arguments...
  local title=$1 folder=$2
  shift 2
  "$scanchor" run --family office --scenes "$scenes" --seed "$seed" --no-pictures --out "$work/$folder" "$@" >"$work/$folder.txt"
  printf '\n## %s\n\n`scanchor run --family office --scenes %s --seed %s --no-pictures %s`\n\n```\n' "$title" "$scenes" "$seed" "$*"
  sed -n '/^class/,/^all/p' "$work/$folder.txt"
  printf '\n'
  grep -E 'could hardly be seen|has no word for|^Times per' "$work/$folder.txt" || true
  printf '```\n'
}

# suite, ontology, title, arguments...: the table of all methods that this build has.
compare() {
  local suite=$1 ontology=$2 title=$3
  shift 3
  local methods=(--method default --method paper)
  for peer in $peers; do methods+=(--method "$peer"); done
  printf '\n## %s\n\n`scanchor score --suite %s --ontology %s %s %s`\n\n```\n' "$title" "$suite" "$ontology" "${methods[*]}" "$*"
  "$scanchor" score --suite "$suite" --ontology "$ontology" "${methods[@]}" "$@" 2>/dev/null | sed '/^$/d'
  printf '```\n'
}

# Peers are there where the command was built with -DSCANCHOR_PEERS=ON.
peers=${PEERS:-}

{
  cat <<EOF
# Results

Written by \`scripts/results.sh\` on $(date -u +%Y-%m-%d) with $("$scanchor" --version); no number here is typed by hand.
$scenes simulated offices, seed $seed, 100,000 beams each. What "found" and "wrong" mean is in
[the metrics](reference/metrics.md): a claim finds a thing when more than half of the claim's points lie on it and they cover at least a
quarter of it. Things with fewer than 50 points or less than a tenth of their faces in view do not count on either side.
EOF
  measure "Default method, 1 cm range noise" default
  measure "Default method, 1 cm range noise, each room from three places, only what is plainly in view" plain --scans 3 --protocol protocols/plain-view.yaml
  measure "Default method, 2 cm range noise" noisy --set lidar.range_sigma=0.02
  measure "The paper's method, the same descriptions, 1 cm" paper --set perceive.method=paper --set reason.mode=paper
  cat <<EOF

# Test parts of the suites

All things of all classes together: precision, recall and F1 of things, panoptic quality, mean IoU of points, F1 of planes, expected
calibration error of the labels, and time of a scan on a machine that did other things as well (compare within one table). Rates of the
descriptions were counted on other rooms ([semantics](why/semantics.md#what-is-counted)).
EOF
  compare quick office "Suite quick, 1 cm"
  (peers= compare office office "Suite office, 1 cm")
  (peers= compare home home "Suite home, 1 cm")
  (peers= compare storage storage "Suite storage, 1 cm")
  for sigma in 0 0.005 0.02 0.04; do
    compare quick office "Suite quick, range noise $sigma m" --set lidar.range_sigma=$sigma
  done
  measure "The paper's method and the paper's descriptions, 1 cm" verbatim --set perceive.method=paper --set reason.mode=paper --ontology paper
} >docs/results.md
printf 'docs/results.md\n'
