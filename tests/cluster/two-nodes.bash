# SPDX-License-Identifier: GPL-3.0-or-later
#
# A Slurm of two nodes on this one machine, for tests: own munge key and socket, everything in one
# folder, ports on 127.0.0.1 only. To be sourced.
#
#   two_nodes_missing        prints the name of a program that is not installed, if any
#   two_nodes_start FOLDER   starts all of it; exports SLURM_CONF; returns when both nodes are idle
#   node_start N             starts the daemon of node N (1 or 2)
#   node_kill N              kills the daemon of node N, its step daemons and all that they run
#   two_nodes_stop           ends all that was started here
#
# Only processes that have FOLDER in their environment are ended, each by its number.

PATH=$PATH:/usr/sbin:/sbin

two_nodes_missing() {
  local program
  for program in munged slurmctld slurmd sbatch scontrol sinfo python3; do
    command -v "$program" >/dev/null || { echo "$program"; return; }
  done
}

# Three ports that are free now.
free_ports() {
  python3 - <<'PYTHON'
import socket
taken = [socket.socket() for _ in range(3)]
for one in taken:
    one.bind(("127.0.0.1", 0))
print(*(one.getsockname()[1] for one in taken))
PYTHON
}

# write_slurm_conf CONTROLLER_PORT NODE1_PORT NODE2_PORT. No cgroups, so that it runs in a container;
# cred_expire is also how long a requeued job waits before it starts again, SlurmdTimeout how long a
# silent node counts as alive. JobRequeue=0: only jobs that ask for it are requeued.
write_slurm_conf() {
  local user host
  user=$(id -un)
  host=$(hostname -s)
  cat >"$two_nodes/slurm.conf" <<CONF
ClusterName=gonogo
SlurmctldHost=$host(127.0.0.1)
SlurmUser=$user
SlurmdUser=$user
SlurmctldPort=$1
CommunicationParameters=NoCtldInAddrAny,NoInAddrAny
AuthType=auth/munge
CredType=cred/munge
AuthInfo=socket=$two_nodes/munge/socket,cred_expire=20
StateSaveLocation=$two_nodes/state
SlurmdSpoolDir=$two_nodes/%n
SlurmctldPidFile=$two_nodes/slurmctld.pid
SlurmdPidFile=$two_nodes/%n.pid
SlurmctldLogFile=$two_nodes/slurmctld.log
SlurmdLogFile=$two_nodes/%n.log
SlurmdParameters=config_overrides
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
MpiDefault=none
SwitchType=switch/none
SchedulerType=sched/builtin
SchedulerParameters=batch_sched_delay=0,sched_interval=1
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
JobRequeue=0
ReturnToService=2
SlurmdTimeout=15
KillWait=2
MinJobAge=600
NodeName=node1 NodeHostname=$host NodeAddr=127.0.0.1 Port=$2 CPUs=1 RealMemory=1000
NodeName=node2 NodeHostname=$host NodeAddr=127.0.0.1 Port=$3 CPUs=1 RealMemory=1000
PartitionName=main Nodes=node1,node2 Default=YES MaxTime=INFINITE State=UP
CONF
}

# until_true SECONDS COMMAND...: waits for it, looking ten times a second.
until_true() {
  local tries=$(($1 * 10))
  shift
  until "$@"; do
    [ $((tries -= 1)) -gt 0 ] || return 1
    sleep 0.1
  done
}

nodes_are_idle() { [ "$(sinfo -h -N -o '%T' 2>/dev/null | grep -c '^idle$')" = 2 ]; }

node_start() {
  GONOGO_TEST_NODE=$two_nodes/node$1 slurmd -D -N "node$1" -f "$SLURM_CONF" >/dev/null 2>&1 &
  disown
}

two_nodes_start() {
  two_nodes=$1
  mkdir -p "$two_nodes"/{state,node1,node2}
  mkdir -m 0755 "$two_nodes/munge"
  (umask 077 && dd if=/dev/urandom of="$two_nodes/munge/key" bs=128 count=1 status=none)
  # --force: the folders above this one may be writable by all, as /tmp is.
  GONOGO_TEST_NODE=$two_nodes/munge munged --foreground --force --key-file="$two_nodes/munge/key" \
    --socket="$two_nodes/munge/socket" --pid-file="$two_nodes/munge/pid" \
    --log-file="$two_nodes/munge/log" --seed-file="$two_nodes/munge/seed" >/dev/null 2>&1 &
  disown
  until_true 60 test -S "$two_nodes/munge/socket" || return 1
  export SLURM_CONF=$two_nodes/slurm.conf
  # Another program may take a port between the look for a free one and the start.
  daemons_start || { daemons_stop; daemons_start; }
}

daemons_start() {
  # shellcheck disable=SC2046
  write_slurm_conf $(free_ports)
  GONOGO_TEST_NODE=$two_nodes/controller slurmctld -D -i -f "$SLURM_CONF" >/dev/null 2>&1 &
  disown
  node_start 1
  node_start 2
  until_true 90 nodes_are_idle
}

daemons_stop() {
  kill_all node_processes 1
  kill_all node_processes 2
  kill_all processes_with "SLURM_CONF=$SLURM_CONF"
}

# processes_with LINE...: the processes whose environment has all of these lines NAME=VALUE.
processes_with() {
  local files line
  files=$(echo /proc/[0-9]*/environ)
  for line in "$@"; do
    # shellcheck disable=SC2086
    files=$(grep -lzxF -- "$line" $files /dev/null 2>/dev/null)
  done
  grep -oE '[0-9]+' <<<"$files"
}

# The daemon of node N has the marker; what a task runs has Slurm's variables; the step daemon, which
# has neither, is the task's parent.
node_processes() {
  local task parent
  processes_with "GONOGO_TEST_NODE=$two_nodes/node$1"
  for task in $(processes_with "SLURM_CONF=$SLURM_CONF" "SLURMD_NODENAME=node$1"); do
    echo "$task"
    parent=$(sed -n 's/^PPid:[[:space:]]*//p' "/proc/$task/status" 2>/dev/null)
    ! grep -qx slurmstepd "/proc/${parent:-0}/comm" 2>/dev/null || echo "$parent"
  done
}

# kill_all COMMAND...: ends the processes that COMMAND lists, until it lists none. They are stopped
# first, so that none sees the end of another one.
kill_all() {
  local processes
  while processes=$("$@") && [ -n "$processes" ]; do
    # shellcheck disable=SC2086
    kill -STOP $processes 2>/dev/null
    # shellcheck disable=SC2086
    kill -KILL $processes 2>/dev/null
    sleep 0.05
  done
}

node_kill() { kill_all node_processes "$1"; }

two_nodes_stop() {
  [ -n "${SLURM_CONF:-}" ] || return 0
  daemons_stop
  kill_all processes_with "GONOGO_TEST_NODE=$two_nodes/munge"
}
