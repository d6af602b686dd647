"""How commands end that Ctrl-C strikes while they compile, and how soon.

    python -m benchmarks.interrupted

Each run of `nonsmooth digits --quick` starts with an empty cache of kernels and is struck
once, or twice in quick succession, within its first six seconds.
"""

import os
import random
import signal
import subprocess
import sys
import tempfile
import time
from collections import Counter
from concurrent.futures import ThreadPoolExecutor

RUNS, AT_ONCE, SECONDS = 160, 4, 6.0

#: Seconds between two strikes.
BETWEEN = (0.0, 0.001, 0.01, 0.05)


def end(number: int) -> tuple[int, str, float]:
    """Return status, last line of stderr and seconds from the first strike to the end."""
    rng = random.Random(number)
    command = [sys.executable, "-m", "nonsmooth", "digits", "--quick"]
    pipe = subprocess.PIPE
    with tempfile.TemporaryDirectory() as folder:
        environment = os.environ | {"NUMBA_CACHE_DIR": folder}
        process = subprocess.Popen(
            command, stdout=pipe, stderr=pipe, text=True, env=environment
        )
        time.sleep(rng.uniform(0.02, SECONDS))
        start = time.perf_counter()
        process.send_signal(signal.SIGINT)
        if number % 2:
            time.sleep(rng.choice(BETWEEN))
            process.send_signal(signal.SIGINT)
        _, err = process.communicate()
        return (
            process.returncode,
            (err.splitlines() or [""])[-1],
            time.perf_counter() - start,
        )


def main() -> None:
    """Strike, and count the ends."""
    # what runs in the background of a script hands on that Ctrl-C is ignored
    signal.signal(signal.SIGINT, signal.default_int_handler)
    with ThreadPoolExecutor(AT_ONCE) as pool:
        found = list(pool.map(end, range(RUNS)))
    for (status, line), count in Counter(outcome[:2] for outcome in found).most_common():
        print(f"{count} runs: status {status}, {line!r}")
    print(f"slowest: {max(seconds for *_, seconds in found):.2f} s")


if __name__ == "__main__":
    main()
