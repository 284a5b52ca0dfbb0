#!/usr/bin/env bash
# test_slurm.sh PROGRAM COMPARE   a study as an array of four shards on a real Slurm cluster of two nodes on
# this machine; one node is killed while it works and its shards requeued; merged, the study has the same
# bits as run at once, and so has a study of histories after it. Skipped (77) without Slurm or root.
set -euo pipefail

program=$1 compare=$2
here=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")
# shellcheck source=tests/slurm/cluster.sh
source "$here/cluster.sh"
slurm_ready || exit 77

work=$(mktemp -d)
trap 'stop_cluster; rm -rf -- "$work"' EXIT
study=$here/../study/small.ini
size=(--set uq.samples=600)

"$program" study "$study" --out "$work/whole.h5" --quiet "${size[@]}" >/dev/null
"$program" study "$study" --out "$work/array.h5" "${size[@]}" --threads 1 --shard '*/4' \
    --slurm "$work/array.sh" --quiet
start_cluster "$work/cluster" || { echo "skipped: no Slurm cluster can be started on this machine"; exit 77; }
bash "$work/array.sh"
for _ in {1..600}; do # until a shard on the first node has walls
    squeue -h -t R -o %N | grep -q n1 && compgen -G "$work/array_*.h5.parts/000001.h5" >/dev/null && break
    sleep 0.1
done
kill_node 1
echo "node 1 killed; running before: $(squeue -h -t R | wc -l)"
for _ in {1..600}; do # until the controller gives the node up and requeues
    [[ $(sinfo -h -N -n n1 -o %T) == down* ]] && break
    sleep 0.1
done
start_node 1
for _ in {1..600}; do
    [[ -n $(squeue -h) ]] || break
    # requeued jobs wait two minutes; not here
    for job in $(squeue -h -t PD -O JobID,Reason | awk '$2 == "BeginTime" {print $1}'); do
        requeued=$((${requeued-0} + 1))
        scontrol update "JobId=$job" StartTime=now || :
    done
    sleep 0.5
done
[[ -z $(squeue -h) ]] || { squeue; tail -n 5 "$work"/array.h5.logs/*; exit 1; }
cat "$work"/array.h5.logs/merge.log
"$compare" "$work/whole.h5" "$work/array.h5"
((${requeued-0} > 0)) || { echo "nothing was requeued"; exit 1; }

shaken=(--set 'shaking.records=kanai_tajimi(peak 0.3 g, duration 1 s, records 2)' --set 'shaking.intensities=0.2, 0.5 g'
    --set load.mass=floor --set solver.kinematics=finite --set uq.samples=3)
"$program" study "$study" --out "$work/shaken.h5" --quiet "${shaken[@]}" >/dev/null
"$program" study "$study" --out "$work/shaken_array.h5" "${shaken[@]}" --threads 1 --shard '*/3' \
    --slurm "$work/shaken.sh" --quiet
bash "$work/shaken.sh"
for _ in {1..300}; do
    [[ -n $(squeue -h) ]] || break
    sleep 0.2
done
"$compare" "$work/shaken.h5" "$work/shaken_array.h5"
