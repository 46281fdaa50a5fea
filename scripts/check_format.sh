#!/usr/bin/env bash
# Fails when a source file is not as clang-format (Debian 12's, with .clang-format of the top folder) would write it. With --write it writes it so.
set -euo pipefail
cd "$(dirname "$0")/.."
how=(--dry-run -Werror)
[ "${1:-}" = --write ] && how=(-i)
find . -path ./build -prune -o -path ./out -prune -o \( -name '*.cpp' -o -name '*.hpp' \) -print0 |
    xargs -0 -P "$(nproc)" -n 60 clang-format "${how[@]}"
