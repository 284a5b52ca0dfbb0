#!/usr/bin/env bash
# A Slurm cluster on this machine: controller and two nodes on loopback, in a directory of its own.
# Sourced; needs root. start_cluster DIR; stop_cluster; kill_node N; start_node N.

slurm_ready() { # whether all of it is here
    local tool
    for tool in slurmctld slurmd sbatch munged; do command -v "$tool" >/dev/null || return 1; done
    [[ $(id -u) == 0 ]]
}

write_slurm_conf() {
    local memory
    memory=$(awk '/MemTotal/ {print int($2 / 2048)}' /proc/meminfo)
    cat >"$SLURM_CONF" <<CONF
ClusterName=loopback
SlurmctldHost=$(hostname -s)(127.0.0.1)
SlurmctldPort=$((port))
AuthType=auth/munge
AuthInfo=socket=$cluster/munge.socket
CryptoType=crypto/munge
SlurmUser=root
StateSaveLocation=$cluster/state
SlurmdSpoolDir=$cluster/spool.%n
SlurmctldPidFile=$cluster/slurmctld.pid
SlurmdPidFile=$cluster/slurmd.%n.pid
SlurmctldLogFile=$cluster/slurmctld.log
SlurmdLogFile=$cluster/slurmd.%n.log
ProctrackType=proctrack/pgid
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
SlurmdTimeout=10
SlurmctldTimeout=10
KillWait=5
MinJobAge=300
JobRequeue=1
SchedulerParameters=sched_interval=2,bf_interval=2
NodeName=n[1-2] NodeHostname=$(hostname -s) NodeAddr=127.0.0.1 Port=[$((port + 1))-$((port + 2))] CPUs=2 RealMemory=$memory State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE OverSubscribe=YES State=UP
CONF
}

start_node() { slurmd -N "n$1" -f "$SLURM_CONF"; }

kill_own() { # $1: line of its environment; $2: begin of its command; of this cluster and of no other, at once
    local process
    for process in $(grep -lzxF "SLURM_CONF=$SLURM_CONF" /proc/[0-9]*/environ 2>/dev/null); do
        process=${process%/environ}
        grep -qzx "$1" "$process/environ" 2>/dev/null && grep -qa "^$2" "$process/cmdline" 2>/dev/null || continue
        kill -KILL "${process#/proc/}" 2>/dev/null || :
    done
}

kill_node() { # $1: number; the node and all its jobs die at once
    local job
    for job in $(squeue -h -t R -w "n$1" -o %A); do kill_own ".*" "slurmstepd: .$job\\."; done
    kill -KILL "$(cat "$cluster/slurmd.n$1.pid")"
    kill_own "SLURMD_NODENAME=n$1" ""
}

start_cluster() { # $1: directory
    cluster=$1
    port=$((20000 + RANDOM % 20000))
    export SLURM_CONF=$cluster/slurm.conf
    mkdir -p "$cluster/state"
    dd if=/dev/urandom of="$cluster/munge.key" bs=1024 count=1 status=none
    chmod 400 "$cluster/munge.key"
    chmod 755 "$cluster"
    munged --force --key-file="$cluster/munge.key" --socket="$cluster/munge.socket" \
        --pid-file="$cluster/munged.pid" --log-file="$cluster/munged.log" --seed-file="$cluster/munge.seed" \
        --num-threads=2
    write_slurm_conf
    slurmctld -f "$SLURM_CONF"
    start_node 1
    start_node 2
    local _
    for _ in {1..60}; do
        [[ $(sinfo -h -N -o %T 2>/dev/null | grep -c idle) == 2 ]] && return
        sleep 0.5
    done
    tail -n 20 "$cluster"/*.log
    return 1
}

stop_cluster() {
    local file
    kill_own ".*" "slurmstepd: "
    for file in "$cluster"/*.pid; do
        [[ ! -e $file ]] || kill -KILL "$(cat "$file")" 2>/dev/null || :
    done
}
