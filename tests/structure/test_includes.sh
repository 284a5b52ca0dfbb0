#!/usr/bin/env bash
# test_includes.sh ROOT   includes point one way: each folder of sources knows itself and those listed here, no others; only
# commands print; no folder has more files than a reader takes in.
# Exit code 0: so it is, 1: the lines that break it.
set -euo pipefail
cd -- "$1"

declare -A knows=(
    [core]=""
    [dem/scene]="core dem/contact dem/scene/geometry"
    [dem/scene/geometry]="core dem/contact"
    [dem/scene/mechanism]="core dem/contact dem/scene dem/scene/geometry"
    [dem/block]="core dem/scene/ dem/contact"
    [dem/contact]="core"
    [dem/kinematics]="core dem/scene/ dem/contact"
    [dem/shaking]="core dem/scene/ dem/block dem/contact dem/kinematics dem/solver/"
    [dem/solver]="core dem/scene/ dem/block dem/contact dem/kinematics dem/solver/"
    [dem/solver/state]="core dem/scene/ dem/block dem/contact dem/kinematics"
    [dem/solver/step]="core dem/scene/ dem/block dem/contact dem/kinematics dem/solver/state"
    [fragility/codes]="core"
    [fragility/curve]="core fragility/codes"
    [fragility/laws]="core"
    [fragility/fits]="core fragility/curve fragility/laws"
    [fragility/limits]="core fragility/laws fragility/fits"
    [fragility/modes]="core fragility/laws fragility/limits"
    [fragility/intensity]="core fragility/laws fragility/fits fragility/limits"
    [ground]=""
    [uq/marginals]="core uq/marginals/shapes"
    [uq/marginals/shapes]="core"
    [uq/designs]="core uq/marginals"
    [uq/fields]="core uq/marginals uq/designs"
    [uq/estimates]="core uq/marginals uq/designs"
    [uq/inference]="core uq/marginals uq/designs"
    [uq/sensitivity]="core uq/marginals uq/designs uq/estimates"
    [uq/surrogates]="core uq/marginals uq/designs uq/estimates uq/sensitivity"
    [uq/reliability/limit_state]="core uq/marginals uq/designs uq/estimates"
    [uq/reliability/design_point]="core uq/marginals uq/designs uq/estimates uq/reliability/limit_state"
    [uq/reliability/active]="core uq/marginals uq/designs uq/estimates uq/surrogates uq/reliability/limit_state"
    [uq/reliability/simulation]="core uq/marginals uq/designs uq/estimates uq/surrogates uq/reliability/limit_state uq/reliability/active"
    [uq/reliability]="core uq/marginals uq/designs uq/estimates uq/sensitivity uq/surrogates uq/reliability/"
    [app/store]="app/store/hdf5"
    [app/store/hdf5]=""
    [app/reading]="dem/ fragility/"
    [app/text]=""
    [app/input/study]="app/text app/drawing/ dem/ fragility/ app/reading uq/marginals uq/designs uq/reliability/"
    [app/input/wall]="app/text app/drawing/ dem/ fragility/ app/reading uq/marginals uq/designs app/input/study"
    [app/input/keys]="app/text app/drawing/ dem/ fragility/ app/reading uq/marginals uq/designs uq/reliability/ app/input/study app/input/wall"
    [app/input]="app/text app/drawing/ dem/ fragility/ app/reading uq/marginals uq/designs uq/reliability/ app/input/"
    [app/drawing/outlines]="dem/ app/text"
    [app/drawing/trace]="dem/ app/text app/drawing/outlines"
    [app/drawing]="dem/ app/text app/drawing/outlines app/drawing/trace"
    [app/output]="app/text dem/ fragility/ app/input/"
    [app/output/picture]="app/text dem/ fragility/ app/input/ app/output"
    [app/output/table]="app/text dem/ fragility/ app/input/ app/output app/output/picture"
    [app/sampling]="core app/text dem/ uq/ app/input/"
    [app/study/pushed]="core app/text dem/ fragility/ uq/ app app/reading app/store/ app/input/ app/output/ app/sampling"
    [app/study/stored]="core app/text dem/ fragility/ ground uq/ app app/reading app/store/ app/input/ app/output/ app/sampling app/study/pushed"
    [app/study/answers]="core app/text dem/ fragility/ uq/ app app/reading app/store/ app/input/ app/output/ app/sampling app/study/pushed app/study/stored"
    [app/study]="core app/text dem/ fragility/ uq/ app app/reading app/store/ app/input/ app/output/ app/sampling app/study/"
    [app/reliability]="core app/text dem/ fragility/ uq/ app app/reading app/input/ app/output/ app/store/ app/sampling app/study/"
    [app/serve]="app/text dem/ fragility/ uq/ app app/reading app/store/ app/input/ app/output/ app/sampling app/study/ app/reliability app/surrogate"
    [app/scene]="app/text app/drawing/ dem/ app app/input/ app/output/ app/sampling app/study/"
    [app/record]="app/text app/input/ app/output/ app ground"
    [app/shake]="app/text dem/ fragility/ ground app app/input/ app/output/ app/store/ app/sampling app/study/"
    [app/photograph]="app/text app/drawing/ app app/output/"
    [app/new]="app/text app app/input/ app/output/"
    [app/choices]="app/text dem/ fragility/ app/reading app/input/ app/output/ app/sampling app/study/"
    [app/compare]="app/text fragility/ app/reading app/input/ app/output/ app/study/ app/push"
    [app/sheet]="core app/text app/drawing/ fragility/ app app/reading app/input/ app/output/ app/sampling app/scene app/study/ app/push app/fragility/"
    [app/push]="app/text dem/ fragility/ app app/reading app/store/ app/input/ app/output/ app/sampling app/study/"
    [app/report]="core app/text dem/ fragility/ uq/ app app/reading app/store/ app/input/ app/output/ app/sampling app/shake app/study/ app/fragility/ app/surrogate"
    [app/surrogate]="core app/text dem/ fragility/ uq/ app app/reading app/store/ app/input/ app/output/ app/sampling app/study/"
    [app/calibration]="core app/text dem/ fragility/ uq/ app app/reading app/store/ app/input/ app/output/ app/sampling app/study/ app/fragility/"
    [app/fragility/numbers]="core app/text dem/ fragility/ ground uq/ app app/reading app/store/ app/input/ app/output/ app/sampling app/study/"
    [app/fragility/intensity]="core app/text dem/ fragility/ ground uq/ app app/reading app/store/ app/input/ app/output/ app/sampling app/study/ app/fragility/numbers"
    [app/fragility]="core app/text dem/ fragility/ ground uq/ app app/reading app/store/ app/input/ app/output/ app/sampling app/study/ app/fragility/"
    [try/wasm]="app/text app/drawing/ dem/ fragility/ app/reading app/input/ app/sampling app/study/ app/push"
    [python/src]="core app/text dem/ fragility/ uq/ app app/reading app/store/ app/input/ app/output/ app/sampling app/scene app/shake app/study/ app/push app/fragility/ app/surrogate"
)

broken=0
shopt -s globstar
for folder in core dem/**/ fragility/**/ ground uq/**/ app/*/**/ python/src try/wasm; do
    folder=${folder%/}
    compgen -G "$folder/*.?pp" >/dev/null || continue
    if [[ -z ${knows[$folder]+listed} ]]; then
        echo "$folder: not listed in tests/structure/test_includes.sh"
        broken=1
        continue
    fi
    while IFS=: read -r file line text; do
        IFS='"' read -r _ to _ <<<"$text"
        [[ $to == */* ]] && to=${to%/*} || to=.
        for known in "$folder" ${knows[$folder]}; do
            [[ $to == "$known" || ($known == */ && $to/ == "$known"*) ]] && continue 2
        done
        echo "$file:$line: $folder must not know $to"
        broken=1
    done < <(grep -nE '^#include "' "$folder"/*.?pp)
done

# Only commands speak to people; everything below them returns what there is to say.
for folder in core dem/**/ fragility/**/ ground uq/**/ app/{text,store,reading,input,drawing,output,sampling}/**/; do
    compgen -G "$folder/*.?pp" >/dev/null || continue
    if grep -nE 'std::c(out|err|log) *<<' "${folder%/}"/*.?pp; then
        echo "${folder%/} must not print: return the text, and let the command print it"
        broken=1
    fi
done

most=30
for folder in app/**/ bench/**/ core dem/**/ docs/**/ fragility/**/ ground python/**/ report tests/**/ uq/**/; do
    files=$(find "$folder" -maxdepth 1 -type f | wc -l)
    if ((files > most)); then
        echo "${folder%/} has $files files, at most $most: put what belongs together into a folder of its own"
        broken=1
    fi
done
exit "$broken"
