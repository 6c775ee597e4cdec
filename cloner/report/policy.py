"""What the pages may load: a browser refuses everything else, whatever a name or a note may have smuggled in.

References
----------
W3C Content Security Policy, level 3. From the disk only pages with a policy of their own are held back.
"""

from __future__ import annotations

from typing import Final

#: The viewer runs the script inside it; textures of the clone are blobs of the page.
VIEWER: Final = (
    "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src blob: data:; "
    "connect-src blob:; base-uri 'none'; form-action 'none'"
)
#: Pages to read run no script at all; pictures lie beside them. "file:" because 'self' means nothing on the disk.
PAGE: Final = (
    "default-src 'none'; style-src 'unsafe-inline'; img-src 'self' file: data:; frame-src 'self' file:; "
    "base-uri 'none'; form-action 'none'"
)


def policy(content: str) -> str:
    """Return the element of a page's head that sets a policy."""
    return f'<meta http-equiv="Content-Security-Policy" content="{content}">'
