#!/usr/bin/env bash
# Whether two programs give the same answers: twelve recordings are made by the first and diagnosed by both, and every diagnosis.json has to be
# the same byte for byte, but for the seconds it took. For changes that are to change no answer.
#
#   scripts/same_answers.sh BEFORE [AFTER] [--only PATTERN]
#
# BEFORE and AFTER: a program, or a revision of this repository, which is then built in build/same_answers; AFTER is build/release/railpem where it
# is not given. What one program has made and said is kept in build/same_answers and not asked again. PATTERN: names that grep -E finds.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
work="$root/build/same_answers"
case1="$root/cases/wei2016/case1.toml"
# Believed numbers are off, some within and some at the end of their tolerances, as with every real train.
off=(--set vehicle.body_mass_kg=39300 --set vehicle.primary.stiffness_n_per_m=1.98e6 --set vehicle.secondary.damping_n_s_per_m=2.2e5
    --set track.pads.static_stiffness_n_per_m=30.1e6 --set track.pads.damping_n_s_per_m=6.4e4)

# One line a question: name, speeds in m/s, seconds, and what is hidden.
questions() {
    cat << 'LINES'
null-one-speed 22.2222 60
null-three-speeds 15,22.2222,33 30
pad-exponent 15,33 40 pad-frequency-stiffening:exponent=0.15
compliant-support 22.2222,33 40 support-compliance
failed-fasteners 15,33 30 failed-fasteners:every=8
friction 22.2222 50 suspension-friction:stage=primary,force_n=1000
pair-of-the-paper 15,33 50 pad-frequency-stiffening:exponent=0.1 pad-preload-stiffening:strength=0.8
late-sensor 22.2222 40 timing-skew:channel=axlebox_3,delay_s=0.001
unknown-bump-stop 15,33 30 secondary-bump-stop
unknown-wandering-ground 22.2222 40 wandering-subgrade
LINES
}

# The program of an argument.
program_of() {
    if [ -x "$1" ] && [ -f "$1" ]; then realpath "$1" && return; fi
    local revision
    revision=$(git -C "$root" rev-parse --verify --quiet "$1^{commit}") || { echo "same_answers: '$1' is neither a program nor a revision" >&2; exit 2; }
    local tree="$work/$revision"
    if [ ! -x "$tree/build/release/railpem" ]; then
        [ -d "$tree" ] || git -C "$root" worktree add --quiet --detach "$tree" "$revision"
        (cd "$tree" && cmake --preset release -DRAILPEM_PYTHON=OFF -DRAILPEM_TESTS=OFF && cmake --build build/release --target railpem) > "$work/$revision.log"
    fi
    echo "$tree/build/release/railpem"
}

# Recordings of a question, made where they are not there yet; their folders.
records_of() {
    local name=$1 speeds=$2 seconds=$3 folder speed
    shift 3
    local hide=() seed=4100
    for effect in "$@"; do hide+=(--hide "$effect"); done
    for speed in ${speeds//,/ }; do
        seed=$((seed + 1))
        folder="$made/$name/run_$speed"
        if [ ! -f "$folder/recording.toml" ]; then
            rm -rf "$folder"
            "$before" simulate "$case1" --seconds "$seconds" --seed "$seed" --speed "$speed" --noise 0.02 "${off[@]}" ${hide[@]+"${hide[@]}"} \
                --out "$folder" > /dev/null
        fi
        echo "$folder"
    done
}

# Receptance and decay rates of a track with softer pads and dampers, without a vehicle, as recordings.
scalar_records() {
    local folder="$made/scalar"
    [ -d "$folder" ] && return
    "$before" receptance "$case1" --from 20 --to 2000 --lines 150 --out "$folder.part" --set track.pads.static_stiffness_n_per_m=20e6 \
        --set track.rail.shear_coefficient=0.4 > /dev/null
    awk -F, 'BEGIN {print "frequency_hz,re_m_per_n,im_m_per_n"} !/^#/ && $1 + 0 > 0 {print $1 "," $2 "," $3}' "$folder.part/case1.receptance.csv" > "$folder.part/receptance.csv"
    awk -F, 'BEGIN {print "centre_hz,decay_rate_db_per_m"} !/^#/ && $1 + 0 > 0 && $2 != "" {print $1 "," $2 * ($1 > 800 ? 1.8 : 1)}' "$folder.part/case1.decay.csv" > "$folder.part/decay.csv"
    printf 'kind = "receptance"\ndata = "receptance.csv"\nplace = "over_pad"\n' > "$folder.part/receptance.toml"
    printf 'kind = "decay-rate"\ndata = "decay.csv"\n' > "$folder.part/decay.toml"
    mv "$folder.part" "$folder"
}

# answer PROGRAM NAME RECORDING…: the program's diagnosis.json without its seconds.
answer() {
    local program=$1 name=$2
    shift 2
    local folder kept
    kept="$work/$(sha256sum < "$program" | cut -c1-16)/$name.json"
    if [ ! -f "$kept" ]; then
        folder=$(mktemp -d "$work/answer.XXXXXX")
        mkdir -p "$(dirname "$kept")"
        "$program" diagnose "$case1" "$@" --out "$folder" > /dev/null 2> "$folder/said" || { cat "$folder/said" >&2; exit 1; }
        grep -v '^  "seconds": ' "$folder/diagnosis.json" > "$kept.part"
        mv "$kept.part" "$kept"
        rm -rf "$folder"
    fi
    echo "$kept"
}

compare() {
    local name=$1 old new
    shift
    if [ -n "$only" ] && ! grep -qE -- "$only" <<< "$name"; then return; fi
    old=$(answer "$before" "$name" "$@")
    new=$(answer "$after" "$name" "$@")
    asked=$((asked + 1))
    if cmp -s "$old" "$new"; then
        echo "same       $name: $(sed -n 's/^  "verdict": "\(.*\)",$/\1/p' "$new")"
    else
        echo "DIFFERENT  $name: diff $old $new"
        different=$((different + 1))
    fi
}

only="" arguments=()
while [ $# -gt 0 ]; do
    case "$1" in
    --only) only=${2:?pattern} && shift ;;
    -*) sed -n '2,9s/^# \{0,1\}//p' "$0" >&2 && exit 2 ;;
    *) arguments+=("$1") ;;
    esac
    shift
done
[ "${#arguments[@]}" -gt 0 ] || { sed -n '2,9s/^# \{0,1\}//p' "$0" >&2 && exit 2; }
mkdir -p "$work"
before=$(program_of "${arguments[0]}")
after=$(program_of "${arguments[1]:-$root/build/release/railpem}")
made="$work/made-$(sha256sum < "$before" | cut -c1-16)"
mkdir -p "$made"
asked=0 different=0

while read -r name speeds seconds hidden; do
    if [ -n "$only" ] && ! grep -qE -- "$only" <<< "$name"; then continue; fi
    # shellcheck disable=SC2086 # effects hold no blanks
    mapfile -t records < <(records_of "$name" "$speeds" "$seconds" $hidden)
    compare "$name" "${records[@]}"
done < <(questions)
scalar_records
compare scalar-receptance "$made/scalar/receptance.toml"
compare scalar-decay-rate "$made/scalar/decay.toml"
echo "$((asked - different)) passed, $different failed"
[ "$different" -eq 0 ]
