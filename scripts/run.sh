#!/usr/bin/env bash
# The main job from a clean clone: installs what is missing, builds the release program, solves the cases of the paper,
# draws its figures, diagnoses a recording in which something is concealed, opens the truth, and says where everything is.
# Results go to out/ (or to the folder given as argument).
set -euo pipefail
source "$(dirname "$0")/setup.sh"
out=$(realpath -m "${1:-$root/out}")

configure > /dev/null
cmake --build "$build" --target railpem railpem_python
program="$build/railpem"

# `import railpem` of the system's interpreter finds the module where it was built.
site=$(/usr/bin/python3 -c 'import site; print(site.getusersitepackages())')
mkdir -p "$site" && echo "$build/python" > "$site/railpem.pth"

cases=("$root"/cases/wei2016/case{1,2,3,3_consistent}.toml)
"$program" solve "${cases[@]}" --out "$out/wei2016" --bands
for case in "${cases[@]}"; do
    "$program" static "$case" --out "$out/wei2016"
done
/usr/bin/python3 "$root/scripts/plot_paper.py" --tables "$out/wei2016" --out "$out/wei2016/figures"

"$program" diagnose "$root/cases/wei2016/case1.toml" "$root/cases/concealed" --out "$out/concealed"
/usr/bin/python3 "$root/scripts/plot_diagnosis.py" "$out/concealed" > /dev/null
/usr/bin/python3 "$root/scripts/open_truth.py" "$root/cases/concealed/truth.json" "$out/concealed/diagnosis.json"

cat <<MESSAGE

The program:  $program
From Python:  import railpem   (/usr/bin/python3; found through $site/railpem.pth)
Tables:       $out/wei2016/*.psd.csv, *.bands.csv, *.static.csv, *.summary.json
Figures:      $out/wei2016/figures/*.png, *.svg (2 to 5 and 7 to 10 of Wei et al. 2016)
Diagnosis:    $out/concealed/report.html of the recording in cases/concealed; *.png, diagnosis.json beside it
MESSAGE
