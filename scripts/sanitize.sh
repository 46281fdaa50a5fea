#!/usr/bin/env bash
# The tests under the address and undefined-behaviour sanitizers: all of them (hours of one core), or
#   --within SECONDS  what fits into that time, building included, those that take least first;
#   --changed         of the folders that the last commits touched, and a share of the others that turns with the days;
#   --races           the threads of everything under clang's thread sanitizer (Debian: clang-14, libomp-14-dev).
set -euo pipefail
source "$(dirname "$0")/setup.sh"
export RAILPEM_RECORDINGS="${RAILPEM_RECORDINGS:-$root/../shared/recordings}"
cd "$root"

preset=sanitize
within=0
changed=false
# What is installed, what fails on purpose, and what reads sources only.
excluded='^(install_|faults|structure_)'
while [ $# -gt 0 ]; do
    case "$1" in
    --within) within=${2:?seconds} && shift ;;
    --changed) changed=true ;;
    --races)
        preset=races
        export TSAN_OPTIONS="ignore_noninstrumented_modules=1 halt_on_error=1" OMP_NUM_THREADS=4
        ;;
    *)
        sed -n '2,5s/^# \{0,1\}//p' "$0" >&2
        exit 2
        ;;
    esac
    shift
done
folder=build/$preset
cmake --preset "$preset" > /dev/null

# Test programs of the folders that the last twenty commits touched, then every fourth of the others, another each day.
programs_of_today() {
    local touched all own name
    touched=$(git log -20 --name-only --format= -- '*.cpp' '*.hpp' | sed -E 's#^tests/[a-z_]+/([a-z_]+)/.*#\1#; s#/.*##' | sort -u)
    all=$(ctest --test-dir "$folder" -N -E "$excluded" | sed -nE 's/^ *Test +#[0-9]+: ((unit|verification)_[a-z_]+)$/\1/p')
    local place=0 today
    today=$((10#$(date +%j) % 4))
    for name in $all; do
        own=${name#*_}
        if grep -qx "$own" <<< "$touched"; then
            echo "$name"
        else
            [ $((place % 4)) -eq "$today" ] && echo "$name"
            place=$((place + 1))
        fi
    done
}

targets=() selection=(-E "$excluded")
if $changed; then
    mapfile -t targets < <(programs_of_today)
    echo "under sanitizers today: ${targets[*]}"
    selection=(-R "^($(IFS='|' && echo "${targets[*]}"))\$")
fi
if [ "$within" -eq 0 ]; then
    cmake --build "$folder" ${targets[@]+--target "${targets[@]}"}
    ctest --test-dir "$folder" --output-on-failure -j "$(nproc)" "${selection[@]}"
    exit
fi
# A machine too slow to build everything in three quarters of the time runs what it has built.
status=0
timeout $((within * 3 / 4)) cmake --build "$folder" ${targets[@]+--target "${targets[@]}"} > "$folder/build.log" 2>&1 || status=$?
if [ "$status" -ne 0 ] && [ "$status" -ne 124 ]; then
    tail -n 40 "$folder/build.log"
    exit 1
fi
echo "built in $SECONDS s of $within"
scripts/test_within.py "$folder" $((within - SECONDS)) "${selection[@]}"
