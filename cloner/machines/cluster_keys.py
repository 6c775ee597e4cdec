"""Certificates of a cluster: one authority per folder, whose private key is discarded, and a key pair for each role.

Only who holds a pair of the folder may speak with a scheduler, a worker or a client that was started with it, and only
encrypted. The authority's key is never written: nobody can make further certificates for the same cluster.
"""

from __future__ import annotations

import importlib.util
import json
import os
from collections.abc import Mapping
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

from cloner.errors import ClonerError

if TYPE_CHECKING:
    from cryptography import x509
    from cryptography.hazmat.primitives.asymmetric import ec

ROLES: Final = ("scheduler", "worker", "client")
AUTHORITY: Final = "ca.pem"
#: Dask reads its settings here when DASK_CONFIG names this file.
SETTINGS: Final = "dask.yaml"
DAYS: Final = 90  # taste: longer than any event; then new ones are made


def certificate(role: str) -> str:
    """Return the name of a role's certificate."""
    return f"{role}.pem"


def key(role: str) -> str:
    """Return the name of a role's private key."""
    return f"{role}-key.pem"


def make_keys(folder: Path) -> tuple[Path, ...]:
    """Make the certificates and Dask's settings for them in a new folder, 0600, and return all files.

    Raises
    ------
    ClonerError
        If the library is missing, or the folder exists or cannot be made.
    """
    if importlib.util.find_spec("cryptography") is None:
        raise ClonerError("cryptography is not installed", 'pip install "photo-cloner[cluster]"', "cloner cluster keys")
    folder = folder.resolve()
    try:
        folder.mkdir(mode=0o700, parents=True)
    except FileExistsError as error:
        hint = "Choose a new folder: keys are never replaced"
        raise ClonerError("this is there already", hint, folder.name) from error
    except OSError as error:
        raise ClonerError("the folder cannot be made", "Check permissions", folder.name) from error
    return write_keys(folder, _contents(folder))


def write_keys(folder: Path, contents: Mapping[str, bytes]) -> tuple[Path, ...]:
    """Write files that only their owner may read, in place of those of their names, and return their paths.

    Raises
    ------
    ClonerError
        If they cannot be written.
    """
    try:
        for name, content in contents.items():
            (folder / name).unlink(missing_ok=True)
            descriptor = os.open(folder / name, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600)
            with os.fdopen(descriptor, "wb") as stream:
                stream.write(content)
    except OSError as error:
        raise ClonerError("the keys cannot be written", "Check permissions and space", folder.name) from error
    return tuple(folder / name for name in contents)


def _contents(folder: Path) -> dict[str, bytes]:
    """Return all files of a folder of keys."""
    from cryptography.hazmat.primitives import serialization
    from cryptography.hazmat.primitives.asymmetric import ec

    authority_key = ec.generate_private_key(ec.SECP256R1())
    authority = _signed("authority", authority_key.public_key(), None, authority_key)
    contents = {AUTHORITY: authority.public_bytes(serialization.Encoding.PEM)}
    for role in ROLES:
        own = ec.generate_private_key(ec.SECP256R1())
        contents[certificate(role)] = _signed(role, own.public_key(), authority, authority_key).public_bytes(
            serialization.Encoding.PEM
        )
        contents[key(role)] = own.private_bytes(
            serialization.Encoding.PEM, serialization.PrivateFormat.PKCS8, serialization.NoEncryption()
        )
    return {**contents, SETTINGS: _settings(folder).encode()}


def _signed(
    role: str, public: ec.EllipticCurvePublicKey, authority: x509.Certificate | None, signing: Any
) -> x509.Certificate:
    """Return a role's certificate, signed by the authority; the authority's own where there is none yet."""
    from cryptography import x509
    from cryptography.hazmat.primitives import hashes
    from cryptography.x509.oid import ExtendedKeyUsageOID, NameOID

    name = x509.Name([x509.NameAttribute(NameOID.COMMON_NAME, f"cloner {role}")])
    now = datetime.now(UTC)
    made = (
        x509.CertificateBuilder()
        .subject_name(name)
        .issuer_name(name if authority is None else authority.subject)
        .public_key(public)
        .serial_number(x509.random_serial_number())
        .not_valid_before(now - timedelta(hours=1))  # clocks of two machines differ
        .not_valid_after(now + timedelta(days=DAYS))
        .add_extension(x509.BasicConstraints(ca=authority is None, path_length=0 if authority is None else None), True)
    )
    if authority is not None:  # every role listens and calls
        both = x509.ExtendedKeyUsage([ExtendedKeyUsageOID.SERVER_AUTH, ExtendedKeyUsageOID.CLIENT_AUTH])
        made = made.add_extension(both, False)
    return made.sign(signing, hashes.SHA256())


def _settings(folder: Path) -> str:
    """Return Dask's settings: certificates on both sides, nothing plain, and no page that tells of the work."""

    def path(name: str) -> str:
        return json.dumps(str(folder / name))  # JSON's strings are YAML's

    roles = "".join(f"      {role}: {{cert: {path(certificate(role))}, key: {path(key(role))}}}\n" for role in ROLES)
    return (
        "# Made by: cloner cluster keys. Use it as DASK_CONFIG=THIS_FILE dask scheduler, dask worker\n"
        "distributed:\n"
        f"  comm:\n    require-encryption: true\n    tls:\n      ca-file: {path(AUTHORITY)}\n{roles}"
        "  scheduler: {http: {routes: []}}\n"
        "  worker: {daemon: false, http: {routes: []}, profile: {enabled: false}}\n"
        "  nanny: {pre-spawn-environ: {OMP_NUM_THREADS: 1, OPENBLAS_NUM_THREADS: 1, MKL_NUM_THREADS: 1,"
        " LP_NUM_THREADS: 1, OPENCV_FOR_THREADS_NUM: 1}}\n"
    )
