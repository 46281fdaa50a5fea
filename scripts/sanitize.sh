#!/usr/bin/env bash
# The tests under the address and undefined-behaviour sanitizers: all of them (hours of one core), or with --within SECONDS what fits into that time, building
# included, those that take least first. With --races the threads of everything under clang's thread sanitizer instead (Debian: clang-14, libomp-14-dev).
set -euo pipefail
source "$(dirname "$0")/setup.sh"
export RAILPEM_RECORDINGS="${RAILPEM_RECORDINGS:-$root/../shared/recordings}"
cd "$root"

preset=sanitize
within=0
# What is installed, what fails on purpose, and what reads sources only.
excluded='^(install_|faults|structure_)'
while [ $# -gt 0 ]; do
    case "$1" in
    --within) within=${2:?seconds} && shift ;;
    --races)
        preset=races
        export TSAN_OPTIONS="ignore_noninstrumented_modules=1 halt_on_error=1" OMP_NUM_THREADS=4
        ;;
    *)
        echo "sanitize.sh [--within SECONDS] [--races]" >&2
        exit 2
        ;;
    esac
    shift
done
folder=build/$preset
cmake --preset "$preset" > /dev/null
if [ "$within" -eq 0 ]; then
    cmake --build "$folder"
    ctest --test-dir "$folder" --output-on-failure -j "$(nproc)" -E "$excluded"
    exit
fi
# A machine too slow to build everything in three quarters of the time runs what it has built.
status=0
timeout $((within * 3 / 4)) cmake --build "$folder" > "$folder/build.log" 2>&1 || status=$?
if [ "$status" -ne 0 ] && [ "$status" -ne 124 ]; then
    tail -n 40 "$folder/build.log"
    exit 1
fi
echo "built in $SECONDS s of $within"
scripts/test_within.py "$folder" $((within - SECONDS)) "$excluded"
