#!/usr/bin/env bash
# The tests under the address and undefined-behaviour sanitizers: all of them (more than an hour of one core), or with --short those that take seconds
# (the readers, the ways to write an input wrong, the solutions; no search of the diagnosis, no marched records).
# With --races the threads of everything under clang's thread sanitizer instead (Debian: clang-14, libomp-14-dev).
set -euo pipefail
source "$(dirname "$0")/setup.sh"
export RAILPEM_RECORDINGS="${RAILPEM_RECORDINGS:-$root/../shared/recordings}"
cd "$root"

preset=sanitize
folder=build/sanitize
flags=()
short=(unit_app unit_lanes unit_pem unit_ranks unit_spectra unit_track unit_vehicle verification_pem verification_vehicle verification_spectra cases_shipped
    input_errors_cases fuzz_corpus)
statistics='-Faults.*:SpectralLines.*:WheelbaseSpeed.*:Delay.*:CrossSpectra.*:Inspection.*' # of recordings: long, and they read nothing
targets=()
tests=(-E '^(install_|faults|structure_)')
for option in "$@"; do
    case "$option" in
    --short)
        # Without optimisation: built in half the time, and these tests are quick all the same.
        folder=build/sanitize_short
        flags=("-DCMAKE_CXX_FLAGS=-O0 -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer")
        targets=(--target railpem unit_recordings "${short[@]}")
        tests=(-R "^($(IFS='|'; echo "${short[*]}"))\$")
        ;;
    --races)
        preset=races
        folder=build/races
        export TSAN_OPTIONS="ignore_noninstrumented_modules=1 halt_on_error=1" OMP_NUM_THREADS=4
        ;;
    *)
        echo "sanitize.sh [--short] [--races]" >&2
        exit 2
        ;;
    esac
done
cmake --preset "$preset" -B "$folder" "${flags[@]}" > /dev/null
cmake --build "$folder" "${targets[@]}"
ctest --test-dir "$folder" --output-on-failure -j "$(nproc)" "${tests[@]}"
if [ "$folder" = build/sanitize_short ]; then "$folder/tests/unit_recordings" --gtest_brief=1 --gtest_filter="$statistics"; fi
