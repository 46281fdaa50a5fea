#!/usr/bin/env bash
# The tests under the address and undefined-behaviour sanitizers: all of them (more than an hour of one core), or with --short those that take seconds
# (every folder, the readers and the ways to write an input wrong, but no search of the diagnosis and no comparison with marched records).
# With --races the threads of everything under clang's thread sanitizer instead (Debian: clang-14, libomp-14-dev).
set -euo pipefail
source "$(dirname "$0")/setup.sh"
export RAILPEM_RECORDINGS="${RAILPEM_RECORDINGS:-$root/../shared/recordings}"
cd "$root"

preset=sanitize
short=(unit_app unit_lanes unit_pem unit_prove unit_ranks unit_recordings unit_simulate unit_spectra unit_track unit_vehicle verification_pem
    verification_spectra verification_track verification_vehicle cases_shipped cases_sweep input_errors_cases fuzz_corpus)
targets=()
tests=(-E '^(install_|faults|structure_)')
for option in "$@"; do
    case "$option" in
    --short)
        targets=(--target railpem "${short[@]}")
        tests=(-R "^($(IFS='|'; echo "${short[*]}"))\$")
        ;;
    --races) preset=races ;;
    *)
        echo "sanitize.sh [--short] [--races]" >&2
        exit 2
        ;;
    esac
done
cmake --preset "$preset" -DRAILPEM_BENCHMARKS=OFF > /dev/null
cmake --build "build/$preset" "${targets[@]}"
ctest --preset "$preset" -j "$(nproc)" "${tests[@]}"
