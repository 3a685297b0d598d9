#!/usr/bin/env python3
"""Prints whether a job of Slurm is running, success or failed, as Snakemake asks."""
import re
import subprocess
import sys

WAITS = {"PENDING", "RUNNING", "CONFIGURING", "COMPLETING", "SUSPENDED", "REQUEUED", "RESIZING",
         "REQUEUE_HOLD", "SIGNALING", "STAGE_OUT", "STOPPED"}

answer = subprocess.run(["scontrol", "--oneliner", "show", "job", sys.argv[-1]],
                        capture_output=True, text=True, check=False)
state = re.search(r"JobState=(\w+)", answer.stdout)
if state:
    print("success" if state[1] == "COMPLETED" else "running" if state[1] in WAITS else "failed")
else:  # A controller that does not answer is asked again; a job that it does not know has failed.
    print("failed" if "Invalid job id" in answer.stderr else "running")
