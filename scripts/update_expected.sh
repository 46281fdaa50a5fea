#!/usr/bin/env bash
# Writes the expected outputs of every shipped case anew: third-octave levels and the static state. Run it after a change of the physics
# that is meant, look at `git diff cases`, and say in the commit why they changed.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
program="${1:-$root/build/release/railpem}"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
for case in "$root"/cases/*/*.toml; do
    case "$case" in *.sweep.toml | *recording.toml) continue ;; esac
    expected="$(dirname "$case")/expected"
    mkdir -p "$expected"
    "$program" solve "$case" --out "$work" --bands > /dev/null
    "$program" static "$case" --out "$work"
    name=$(basename "$case" .toml)
    for table in bands static; do
        grep -v '^#' "$work/$name.$table.csv" > "$expected/$name.$table.csv"  # where it comes from is of this machine
    done
done
