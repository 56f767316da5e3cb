"""The program `crease`: python -m crease_normals VERB, or the command crease that the wheel installs."""

import signal
import sys

from ._native import program


def main() -> int:
    """Runs the program with the arguments of the process and returns its exit code."""
    # Python's handler waits until the program returns. The default one ends the process, as for the program alone.
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    return program(sys.argv[1:])


if __name__ == "__main__":
    sys.exit(main())
