# SPDX-License-Identifier: GPL-3.0-or-later
"""docs/plant.ipynb on a scheduler and two workers, one of which is ended in the middle."""

import os
import re
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest
from pathlib import Path

import notebook

PLANT = Path(os.environ["AXISCOMP_SOURCE"]) / "docs/plant.ipynb"
MEASUREMENTS = "200"


def start(*words):
    return subprocess.Popen(
        [sys.executable, "-P", "-m", *words],
        stderr=subprocess.PIPE,
        stdout=subprocess.DEVNULL,
        text=True,
        env={**os.environ, "LD_PRELOAD": os.environ.get("AXISCOMP_PRELOAD", "")},
    )


def drain(process, seen):
    """Reads what a process says, so that it can go on; lines are kept in seen."""

    def read():
        for line in process.stderr:
            seen.append(line)

    thread = threading.Thread(target=read, daemon=True)
    thread.start()
    return thread


class Plant(unittest.TestCase):
    def setUp(self):
        self.processes = []
        os.environ["PLANT_MEASUREMENTS"] = MEASUREMENTS
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def tearDown(self):
        # The scheduler last: a worker whose scheduler ends meanwhile may wait for it.
        for process in reversed(self.processes):
            if process.poll() is None:
                process.terminate()
            process.wait(60)
            process.stderr.close()
        os.environ.pop("PLANT_SCHEDULER", None)

    def process(self, *words):
        process = start(*words)
        self.processes.append(process)
        seen = []
        drain(process, seen)
        return process, seen

    def wait_for(self, seen, pattern):
        end = time.monotonic() + 300
        while time.monotonic() < end:
            for line in list(seen):
                if found := re.search(pattern, line):
                    return found
            time.sleep(0.05)
        self.fail("".join(seen))

    def test_a_worker_that_ends_changes_no_bit(self):
        _, said = self.process(
            "distributed.cli.dask_scheduler", "--host", "127.0.0.1", "--port", "0", "--no-dashboard"
        )
        address = self.wait_for(said, r"(tcp://127\.0\.0\.1:\d+)").group(1)
        workers = []
        for number in range(2):
            worker, said = self.process(
                "distributed.cli.dask_worker", address, "--nthreads", "1", "--nworkers", "1", "--no-nanny",
                "--no-dashboard", "--local-directory", f"{self.folder}/{number}",
            )
            self.wait_for(said, r"Registered to")
            workers.append(worker)
        os.environ["PLANT_SCHEDULER"] = address

        from dask.distributed import Client

        watched = {}

        def end_one_in_the_middle():
            with Client(address) as client:
                while not watched.get("killed"):
                    done = sum(
                        state == "memory" for state in client.run_on_scheduler(states).values()
                    )
                    if done >= 3:
                        workers[0].send_signal(signal.SIGKILL)
                        watched.update(killed=True, done=done)
                    time.sleep(0.01)

        def states(dask_scheduler=None):
            return {str(key): task.state for key, task in dask_scheduler.tasks.items()}

        killer = threading.Thread(target=end_one_in_the_middle, daemon=True)
        killer.start()
        cluster = notebook.run(PLANT)
        killer.join(60)
        self.assertTrue(watched.get("killed"))
        self.assertLess(watched["done"], int(MEASUREMENTS) // 20)

        alone = notebook.run(PLANT, stop_before="def assess_batch")
        results = [alone["assess"](number) for number in range(int(MEASUREMENTS))]
        self.assertEqual(repr(cluster["results"]), repr(results))
        self.assertTrue(all(len(result) == 5 for result in results))


if __name__ == "__main__":
    unittest.main()
