"""`python -m oracle.peers`: answers the questions of `ancf error-time --peer`; `--check`: compares the element with ours."""

import argparse
import sys

MISSING = "Exudyn is not installed: pip install -r oracle/peers/requirements.txt; nothing was measured"


def main():
    """Command line; exit code 1 when a check fails or Exudyn is not installed."""
    parser = argparse.ArgumentParser(prog="python -m oracle.peers", description=__doc__)
    parser.add_argument("--check", action="store_true", help="compare with our own element and measure nothing")
    arguments = parser.parse_args()
    try:
        from . import program  # noqa: F401
    except ImportError as error:
        if error.name and error.name.split(".")[0] not in ("exudyn", "numpy"):
            raise
        print(MISSING, file=sys.stderr)
        return 1
    if arguments.check:
        from .check import check

        return 0 if check() else 1
    from .serve import serve

    serve()
    return 0


if __name__ == "__main__":
    sys.exit(main())
