#!/usr/bin/env bash
# Installs what is missing. Does nothing, quickly, when nothing is. Where there is no apt it lists what is needed.
set -euo pipefail
cd "$(dirname "$0")/.."

mapfile -t packages < <(grep -v '^#' scripts/packages-debian.txt)

if ! command -v apt-get >/dev/null; then
  # Another system: its owner has installed what is needed if CMake finds it. Say what that is once.
  if ! command -v cmake >/dev/null || ! command -v ninja >/dev/null; then
    printf 'This system has no apt. Scanchor needs these packages (Debian names); install their like and run again:\n' >&2
    printf '  %s\n' "${packages[@]}" >&2
    exit 2
  fi
  exit 0
fi

missing=()
installed=$(dpkg-query -W -f '${Package} ${db:Status-Status}\n' 2>/dev/null | sed -n 's/ installed$//p')
for package in "${packages[@]}"; do
  grep -qxF "$package" <<<"$installed" || missing+=("$package")
done
[ ${#missing[@]} -eq 0 ] && exit 0

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo >/dev/null; then
    printf 'These packages are missing and there is neither root nor sudo to install them:\n  %s\n' "${missing[*]}" >&2
    exit 2
  fi
  as_root=(sudo)
fi
printf 'Installing: %s\n' "${missing[*]}"
"${as_root[@]}" apt-get update -qq
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}"
