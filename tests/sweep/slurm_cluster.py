"""A Slurm cluster of one node on the loopback address, for a test: munged, slurmctld, slurmd, with
folders and ports of their own."""
import os
import pathlib
import pwd
import shutil
import signal
import socket
import subprocess
import time

CONFIG = """
ClusterName=ffgpu_test
SlurmctldHost={host}(127.0.0.1)
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket={folder}/munge/socket
CryptoType=crypto/munge
SlurmctldPort={controller_port}
SlurmdPort={node_port}
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerParameters=sched_interval=1,batch_sched_delay=0,defer
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
MpiDefault=none
ReturnToService=2
MinJobAge=600
KillWait=1
SlurmdTimeout=30
NodeName={host} NodeAddr=127.0.0.1 CPUs={cpus} State=UNKNOWN
PartitionName=test Nodes=ALL Default=YES MaxTime=INFINITE State=UP OverSubscribe=FORCE:4
"""


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def missing():
    """What keeps a cluster from being started here; empty: nothing."""
    if os.geteuid() != 0:
        return "Slurm's daemons need root"
    for program in ["munged", "slurmctld", "slurmd", "sbatch"]:
        if not shutil.which(program, path=os.environ["PATH"] + ":/usr/sbin"):
            return program + " is not installed"
    return ""


class Cluster:
    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        self.processes = {}
        self.host = socket.gethostname().split(".")[0]
        self.env = dict(os.environ, SLURM_CONF=str(self.folder / "slurm.conf"),
                        PATH=os.environ["PATH"] + ":/usr/sbin")

    def start(self):
        os.chmod(self.folder, 0o755)
        for name in ["state", "spool", "munge"]:
            (self.folder / name).mkdir()
        (self.folder / "slurm.conf").write_text(CONFIG.format(
            host=self.host, folder=self.folder, controller_port=free_port(), node_port=free_port(),
            cpus=os.cpu_count()))
        self.start_munge()
        self.start_daemon("slurmctld", "-D", "-c")
        self.start_daemon("slurmd", "-D", "-N", self.host)
        self.wait(lambda: "idle" in self.run("sinfo", "--noheader", "--format", "%T").stdout,
                  "the node to be idle")

    def start_munge(self):
        folder, user = self.folder / "munge", pwd.getpwnam("munge")
        (folder / "key").write_bytes(os.urandom(128))
        os.chmod(folder / "key", 0o400)
        for path in [folder, folder / "key"]:
            os.chown(path, user.pw_uid, user.pw_gid)
        os.chmod(folder, 0o755)

        def become_munge():
            os.setgroups([])
            os.setgid(user.pw_gid)
            os.setuid(user.pw_uid)
        self.processes["munged"] = subprocess.Popen(
            [shutil.which("munged", path=self.env["PATH"]), "--foreground", "--force",
             f"--socket={folder}/socket", f"--key-file={folder}/key",
             f"--pid-file={folder}/pid", f"--seed-file={folder}/seed",
             f"--log-file={folder}/log"],
            preexec_fn=become_munge, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.wait(lambda: (folder / "socket").exists(), "munged")

    def start_daemon(self, name, *arguments):
        program = shutil.which(name, path=self.env["PATH"])
        self.processes[name] = subprocess.Popen([program, *arguments], env=self.env,
                                                stdout=subprocess.DEVNULL,
                                                stderr=subprocess.DEVNULL)

    def run(self, *words, **named):
        return subprocess.run(words, env=self.env, capture_output=True, text=True, check=False,
                              **named)

    def wait(self, holds, what, seconds=60):
        end = time.monotonic() + seconds
        while not holds():
            if time.monotonic() > end:
                logs = "".join(log.read_text()[-800:] for log in self.folder.glob("*.log"))
                raise RuntimeError("waited in vain for " + what + "\n" + logs)
            time.sleep(0.1)

    def kill(self, name):
        self.processes[name].send_signal(signal.SIGKILL)
        self.processes[name].wait()

    def restart_node(self):
        self.start_daemon("slurmd", "-D", "-N", self.host)

    def stop(self):
        self.run("scancel", "--user", "root")
        for name in ["slurmd", "slurmctld", "munged"]:
            if name in self.processes:
                self.processes[name].send_signal(signal.SIGTERM)
        for process in self.processes.values():
            try:
                process.wait(10)
            except subprocess.TimeoutExpired:
                process.kill()
