#!/usr/bin/env python3
"""The process ends by exit() while another thread is inside of a call, at twenty moments: exit 0, without a word.

    exit_test.py HOSTILE-CALLS
"""
import subprocess
import sys

for number in range(20):
    moment = 0.02 + 0.03 * number
    done = subprocess.run([sys.argv[1], "--exit", "--seed", str(number), "--seconds", str(moment)], capture_output=True,
                          text=True, timeout=100, check=False)
    if (done.returncode, done.stdout, done.stderr) != (0, "", ""):
        sys.exit(f"seed {number}, {moment:.2f} s: exit {done.returncode}\n{done.stdout}{done.stderr}")
print("20 exits")
