#!/usr/bin/env bash
# bash bench/active.sh [REPETITIONS]   writes docs/bench/uq/active.md, active_walls.md and active_openturns.md: active learning on limit states of known probability and on walls
# DRYSTONE_BENCH: the folder of the benchmarks.
set -euo pipefail
cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/.."
bench=${DRYSTONE_BENCH:-build/release/bench}
"$bench/active" problems docs/bench/uq/active.md "${1:-50}"
"$bench/active" walls docs/bench/uq/active_walls.md
python3 -c "import openturns" 2>/dev/null && python3 bench/active_openturns.py "${1:-50}" || echo "OpenTURNS is missing: docs/bench/uq/active_openturns.md stays"
