#!/usr/bin/env bash
# bash bench/active.sh [REPETITIONS]   writes docs/bench/active.md: active learning on limit states of known probability and on walls
# DRYSTONE_BENCH: the folder of the benchmarks.
set -euo pipefail
cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/.."
"${DRYSTONE_BENCH:-build/release/bench}/active" docs/bench/active.md "${1:-50}"
