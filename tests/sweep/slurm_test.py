"""ffgpu sweep --profile slurm, on a real slurmctld and slurmd of the loopback address."""
import os
import pathlib
import random
import signal
import subprocess
import time
import unittest

import slurm_cluster
from sweep_tools import SweepCase

SMALL = "[grid]\ntexel_cache.ways = [1, 2, 4]\n"


class SlurmTest(SweepCase):
    def setUp(self):
        super().setUp()
        if not os.environ.get("FFGPU_SLURM"):
            self.skipTest("FFGPU_SLURM is not set: ./dev sweep_kills runs it, which takes minutes")
        reason = slurm_cluster.missing()
        if reason:
            self.skipTest(reason)
        (self.folder / "slurm").mkdir()
        os.chmod(self.folder, 0o755)
        self.cluster = slurm_cluster.Cluster(self.folder / "slurm")
        self.addCleanup(self.cluster.stop)
        self.cluster.start()

    def start(self, output):
        return subprocess.Popen(self.command(output, "--profile", "slurm", space=SMALL),
                                env=self.cluster.env, stderr=subprocess.PIPE, text=True)

    def finish(self, output):
        sweep = self.start(output)
        _, errors = sweep.communicate(timeout=300)
        self.assertEqual(sweep.returncode, 0, errors)
        return (self.folder / output / "results.csv").read_bytes()

    def test_the_table_is_the_local_one_whatever_is_killed(self):
        local = self.swept("local", space=SMALL)
        choose = random.Random(3)
        begin = time.monotonic()
        self.assertEqual(self.finish("cluster"), local)
        duration = time.monotonic() - begin
        # The jobs were Slurm's, each once.
        logs = list((self.folder / "cluster/log").glob("slurm-*.txt"))
        self.assertEqual(len(logs), 4)
        for victim in ["sweep", "slurmd"]:
            with self.subTest(victim=victim):
                self.kill_and_resume(victim, choose.uniform(0.2, 0.7) * duration, local)

    def kill_and_resume(self, victim, moment, local):
        sweep = self.start(victim)
        time.sleep(moment)
        if victim == "sweep":
            sweep.send_signal(signal.SIGKILL)
        else:
            self.cluster.kill("slurmd")
            self.cluster.restart_node()
        finished = self.results(victim)
        sweep.communicate(timeout=300)
        self.assertEqual(self.finish(victim), local)
        after = self.results(victim)
        self.assertEqual({file: after[file] for file in finished}, finished)

    def test_array_jobs_run(self):
        script = self.write("array.sh", "#!/bin/sh\necho $SLURM_ARRAY_TASK_ID\n")
        done = self.cluster.run("sbatch", "--wait", "--array", "1-3", "--output",
                                str(self.folder / "array_%a.txt"), str(script), timeout=120)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual([(self.folder / f"array_{i}.txt").read_text() for i in (1, 2, 3)],
                         ["1\n", "2\n", "3\n"])


if __name__ == "__main__":
    unittest.main()
