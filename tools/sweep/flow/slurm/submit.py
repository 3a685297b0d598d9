#!/usr/bin/env python3
"""Submits a job of a sweep to Slurm and prints its number. A job that an earlier, killed sweep left
in the queue is taken over instead: it has the same name."""
import hashlib
import json
import os
import shlex
import subprocess
import sys


def properties_in(script):
    """What Snakemake tells of a job in its script."""
    mark = "# properties = "
    with open(script) as file:
        return next(json.loads(line[len(mark):]) for line in file if line.startswith(mark))


def job_name(properties):
    sweep = hashlib.sha256(os.getcwd().encode()).hexdigest()[:12]
    return "ffgpu-%s-%s" % (sweep, "-".join([properties["rule"], *properties["wildcards"].values()]))


def in_queue(name):
    listed = subprocess.run(
        ["squeue", "--noheader", "--name", name, "--states", "PENDING,RUNNING,CONFIGURING,REQUEUED",
         "--format", "%i"],
        capture_output=True, text=True, check=False)
    return listed.stdout.split()[0] if listed.returncode == 0 and listed.stdout.strip() else None


def submit(name, script):
    os.makedirs("log", exist_ok=True)
    command = ["sbatch", "--parsable", "--job-name", name, "--output", "log/slurm-%j.txt",
               "--cpus-per-task", "1", *shlex.split(os.environ.get("FFGPU_SBATCH", "")), script]
    answer = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=False)
    if answer.returncode != 0:
        sys.exit(answer.returncode)
    return answer.stdout.strip().split(";")[0]


script = sys.argv[-1]
name = job_name(properties_in(script))
print(in_queue(name) or submit(name, script))
