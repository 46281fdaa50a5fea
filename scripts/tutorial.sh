#!/usr/bin/env bash
# Runs every command of docs/tutorial.md in order, from its ```sh blocks, so that page and script cannot differ. Results go to
# out/tutorial (or to the folder given as argument), what the commands print to the screen. Some two minutes on two cores.
# The program is build/release/railpem, or the one that RAILPEM_PROGRAM names.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
out=$(realpath -m "${1:-$root/out/tutorial}")
program=$(realpath "${RAILPEM_PROGRAM:-$root/build/release/railpem}")
[ -x "$program" ] || { echo "there is no program at $program: run scripts/run.sh first" >&2; exit 2; }
cd "$root"
railpem() { "$program" "$@"; }
commands=$(awk '/^```sh$/ { inside = 1; next } /^```/ { inside = 0 } inside' docs/tutorial.md)
while IFS= read -r line; do
    [ -n "$line" ] || continue
    printf '\n$ %s\n' "$line"
    line=${line//build\/release\/railpem/railpem}
    eval "${line//out\/tutorial/$out}" < /dev/null
done <<< "$commands"
