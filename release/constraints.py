"""Print the exact versions that this environment has of everything Cloner stands on: ``make constraints``.

``pip install photo-cloner -c constraints.txt`` then gives the very set that all tests ran with.
"""

from __future__ import annotations

import sys

from closure import closure
from packaging.utils import canonicalize_name


def main() -> None:
    lines = [f"{canonicalize_name(one.metadata['Name'])}=={one.version}\n" for one in closure()]
    sys.stdout.write("# Made by: make constraints\n" + "".join(lines))


if __name__ == "__main__":
    main()
