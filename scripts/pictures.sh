#!/usr/bin/env bash
# Draws every picture of the docs anew: the demo's first room, the paper's figures, the gallery.
set -euo pipefail
cd "$(dirname "$0")/.."
scanchor=${SCANCHOR:-build/release/bin/scanchor}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$scanchor" run --scenes 1 --out "$work/demo" --quiet
"$scanchor" figures --out "$work/figures" --quiet
mkdir -p docs/pictures
for picture in scene cloud planes labels; do
  cp "$work/demo/00/$picture.png" "docs/pictures/office-$picture.png"
done
cp "$work"/figures/*.png docs/pictures/
"$scanchor" gallery --out docs/gallery --quiet
ls -l docs/pictures docs/gallery/rooms
