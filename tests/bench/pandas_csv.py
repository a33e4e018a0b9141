#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The CSV reader beside pandas on the same file: pandas_csv.py PATH/bench_csv [ROUNDS]

Both read one file of 518 400 lines in turn, best round of each. pandas only reads (default C engine,
one thread, no pivot); bench_csv's part is the file to the verified table.
"""
import json
import os
import subprocess
import sys
import tempfile
import time


def own_seconds(bench, sample):
    out = subprocess.run(
        [bench, "--benchmark_filter=^fileToTable$", "--benchmark_format=json",
         "--benchmark_min_time=0.3"],
        env=dict(os.environ, AXISCOMP_BENCH_CSV=sample), check=True, capture_output=True, text=True)
    result = json.loads(out.stdout)["benchmarks"][0]
    if "error_message" in result:
        sys.exit("bench_csv: " + result["error_message"])
    return result["cpu_time"] / 1e3, result["peak_memory_per_file_size"]


def pandas_seconds(pandas, sample):
    begin = time.process_time()
    table = pandas.read_csv(sample, skiprows=1)  # the comment line
    seconds = time.process_time() - begin
    assert table.shape == (518400, 4), table.shape
    return seconds


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    bench, rounds = sys.argv[1], int(sys.argv[2]) if len(sys.argv) == 3 else 3
    try:
        import pandas
    except ImportError:
        print("pandas is not installed (Debian: python3-pandas): only bench_csv is measured")
        pandas = None
    with tempfile.TemporaryDirectory() as folder:
        sample = os.path.join(folder, "sample.csv")
        subprocess.run([bench, "--sample", sample], check=True)
        megabytes = os.path.getsize(sample) / 1e6
        own, theirs, memory = [], [], 0.0
        for _ in range(rounds):
            seconds, memory = own_seconds(bench, sample)
            own.append(seconds)
            if pandas:
                theirs.append(pandas_seconds(pandas, sample))
    print(f"file              {megabytes:8.1f} MB")
    print(f"axiscomp          {megabytes / min(own):8.0f} MB/s   peak memory {memory:.2f} x file")
    if theirs:
        print(f"pandas {pandas.__version__:10} {megabytes / min(theirs):8.0f} MB/s")
        print(f"ratio             {min(theirs) / min(own):8.1f}")


if __name__ == "__main__":
    main()
