"""An Xvfb of one's own, and what its clients hold."""

import os
import subprocess
import time


class XServer:
    def __init__(self):
        read, write = os.pipe()
        self.process = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write), "-screen", "0", "1280x1024x24", "-noreset",
             "-nolisten", "tcp", "-maxclients", "256"],
            pass_fds=[write], stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(read) as name:
            self.name = ":" + name.readline().strip()
        self.environment = dict(os.environ, DISPLAY=self.name)

    def clients(self):
        """Of each client but the server and xrestop: its name and how many of each kind it holds."""
        text = subprocess.run(["xrestop", "-b", "-m", "1"], env=self.environment, check=True,
                              capture_output=True, text=True).stdout
        clients = []
        for line in text.splitlines():
            key, _, value = line.partition(":")
            if not line.startswith("\t"):
                clients.append({"name": line.split(" - ", 1)[-1].split(" ( PID")[0]})
            elif key.strip() == "res_base":
                clients[-1]["is server"] = int(value, 16) == 0
            elif key.strip() != "res_mask":
                clients[-1][key.strip()] = int(value.strip().lstrip("~"))
        # Who holds most comes first; the server's own part is the one whose numbers begin at 0.
        return [client for client in clients
                if not client.pop("is server") and client["name"] != "xrestop"]

    def wait_for_clients(self, count, seconds=10):
        """Whether there are so many clients before long; the server notices an end in its own time."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            if len(self.clients()) == count:
                return True
            time.sleep(0.2)
        return False

    def kill(self):
        self.process.kill()
        self.process.wait()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.kill()
