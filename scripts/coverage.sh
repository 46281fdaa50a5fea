#!/usr/bin/env bash
# Which lines the tests reach: builds with counters in build/coverage, runs every test, prints a table per folder and writes
# build/coverage/coverage.txt (lines per file) and uncovered.txt (the lines that no test reaches). Debian: gcovr.
set -euo pipefail
source "$(dirname "$0")/setup.sh"
folder="$root/build/coverage"

cmake -S "$root" -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE= -DCMAKE_CXX_FLAGS="-O1 -g --coverage -fprofile-update=atomic" \
    -DRAILPEM_PYTHON=ON -DRAILPEM_MPI=ON -DRAILPEM_BENCHMARKS=OFF > /dev/null
cmake --build "$folder"
find "$folder" -name '*.gcda' -delete
# Tests of time and of the machine tell nothing here, and take long with counters. A program that may write no file to its end cuts off the counters of all tests before it.
(cd "$folder" && ctest --output-on-failure -E '^(install_|faults|notebook_|structure_|input_errors_cases)' "$@") || echo "some tests failed; their lines count all the same"
GTEST_FILTER='-RefusedFiles.DiskFull*' "$folder/tests/input_errors_cases" > /dev/null || echo "refusals: some tests failed"
gcovr --root "$root" --object-directory "$folder" --filter "$root/(parameters|lanes|spectra|vehicle|track|pem|simulate|recordings|diagnosis|ranks|app|python)/" \
    --exclude-unreachable-branches --exclude-throw-branches --json -o "$folder/coverage.json" --txt "$folder/coverage.txt"
/usr/bin/python3 "$root/scripts/coverage_table.py" "$folder/coverage.json" "$folder/uncovered.txt"
