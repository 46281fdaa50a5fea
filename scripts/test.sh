#!/usr/bin/env bash
# Every test from a clean clone: installs what is missing, builds, runs, and ends with one line that says what ran.
# With CI=true warnings are errors.
set -euo pipefail
source "$(dirname "$0")/setup.sh"
export RAILPEM_RECORDINGS="${RAILPEM_RECORDINGS:-$root/../shared/recordings}"

warnings=OFF
[ "${CI:-}" = true ] && warnings=ON
configure -DRAILPEM_TESTS=ON -DRAILPEM_MPI=ON -DRAILPEM_WARNINGS_AS_ERRORS=$warnings > /dev/null
cmake --build "$build"

status=0
# Programs side by side: most compute on one core, and those that use all share them.
ctest --test-dir "$build" --output-on-failure -j "$(nproc)" || status=$?

# A program of GoogleTest holds many tests; CTest counts it as one.
tests=0
for program in "$build"/tests/{unit,verification,cases,input_errors,structure}_*; do
    [ -x "$program" ] && [ -f "$program" ] && tests=$((tests + $("$program" --gtest_list_tests | grep -c '^  ')))
done
if [ "$status" -eq 0 ]; then echo "all passed: $tests tests in the programs above"; else echo "FAILED, of $tests tests"; fi
exit "$status"
