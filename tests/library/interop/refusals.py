"""Which files dcf-tools and python-canopen refuse: a line of JSON for each path on standard input."""

import json
import logging
import sys
import warnings

import canopen
import dcf

logging.disable(logging.CRITICAL)
warnings.simplefilter("ignore")


def refusal(read):
    try:
        read()
    except Exception as error:  # a crash refuses the file too
        return f"{type(error).__name__}: {error}" or "refused"
    return None


for path in sys.stdin.read().splitlines():
    print(
        json.dumps(
            {
                "path": path,
                "dcf-tools": refusal(lambda: dcf.Device.from_dcf(path, {"NODEID": 5})),
                "python-canopen": refusal(lambda: canopen.import_od(path, 5)),
            }
        )
    )
