"""How long loading a description of 500 KB and reading 1018h:01 takes, with canopen_objdict and with python-canopen.

    python benches/python/load.py 498k.eds

`benches/instructions` makes such a file; any other EDS does too. The interpreter needs both modules. Each is measured in
turn, and the shortest of several times counts. Exits with 1 below a ratio of 50.
"""

import logging
import sys
import time

import canopen
import canopen_objdict


def ours(path):
    return canopen_objdict.load(path)[0x1018, 1].value


def theirs(path):
    return canopen.import_od(path)[0x1018][1].default


def shortest(run, path, count):
    times = []
    for _ in range(count):
        start = time.perf_counter()
        run(path)
        times.append(time.perf_counter() - start)
    return min(times)


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    path = sys.argv[1]
    logging.disable(logging.CRITICAL)
    if ours(path) != theirs(path):
        sys.exit("both read different values")
    our, their = shortest(ours, path, 20), shortest(theirs, path, 3)
    print(f"canopen_objdict  {our * 1000:8.2f} ms")
    print(f"python-canopen   {their * 1000:8.2f} ms")
    print(f"ratio            {their / our:8.0f}")
    sys.exit(their / our < 50)


main()
