"""The booth's self-signed certificate, made for one event; phones ask once whether to trust it."""

from __future__ import annotations

import importlib.util
import ipaddress
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import Final

from cloner.errors import ClonerError
from cloner.machines.cluster_keys import write_keys

CERTIFICATE_FILE: Final = ".phone-certificate.pem"
KEY_FILE: Final = ".phone-key.pem"
DAYS: Final = 30  # taste: longer than any event


def make_certificate(root: Path, address: str) -> tuple[Path, Path]:
    """Create a certificate and key for an address (mode 0600, in the event's folder).

    Raises
    ------
    ClonerError
        If the library is missing, or the folder cannot be written.
    """
    if importlib.util.find_spec("cryptography") is None:
        hint = "Switch encryption off and use a hotspot of the booth's own with a password"
        raise ClonerError("an encrypted page needs a library that is not here", hint, "cryptography")
    from cryptography import x509
    from cryptography.hazmat.primitives import hashes, serialization
    from cryptography.hazmat.primitives.asymmetric import ec
    from cryptography.x509.oid import NameOID

    key = ec.generate_private_key(ec.SECP256R1())
    name, now = x509.Name([x509.NameAttribute(NameOID.COMMON_NAME, "cloner booth")]), datetime.now(UTC)
    made = (
        x509.CertificateBuilder()
        .subject_name(name)
        .issuer_name(name)
        .public_key(key.public_key())
        .serial_number(x509.random_serial_number())
        .not_valid_before(now - timedelta(hours=1))  # telephones' clocks differ
        .not_valid_after(now + timedelta(days=DAYS))
        .add_extension(x509.SubjectAlternativeName([x509.IPAddress(ipaddress.ip_address(address))]), False)
        .sign(key, hashes.SHA256())
    )
    contents = {
        CERTIFICATE_FILE: made.public_bytes(serialization.Encoding.PEM),
        KEY_FILE: key.private_bytes(
            serialization.Encoding.PEM, serialization.PrivateFormat.PKCS8, serialization.NoEncryption()
        ),
    }
    certificate, own_key = write_keys(root, contents)
    return certificate, own_key
