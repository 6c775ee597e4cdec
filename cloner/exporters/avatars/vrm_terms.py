"""Licence terms of a person as VRM metadata.

References
----------
VRM Consortium 2022, VRMC_vrm 1.0, meta: every field below is the format's own.
"""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Any, Final

from cloner.exporters.shared.credits import CREDITS, GENERIC_CREDITS
from cloner.records.terms import Terms

_LICENCE: Final = "https://vrm.dev/licenses/1.0/"  # the one address that the format allows here
#: Whoever the likeness belongs to and gave no name.
NAMELESS: Final = "The person shown"
_FIELDS: Final = ("avatarPermission", "commercialUsage", "allowRedistribution", "modification", "creditNotation")
_ALWAYS: Final = dict.fromkeys(
    ("allowExcessivelyViolentUsage", "allowExcessivelySexualUsage", "allowPoliticalOrReligiousUsage",
     "allowAntisocialOrHateUsage"), False,
)  # fmt: skip
#: What each licence of a consent says in the format's words; "" is what holds without any consent.
PERMISSIONS: Final[Mapping[str, Mapping[str, Any]]] = MappingProxyType({
    licence: dict(zip(_FIELDS, row, strict=True))
    for licence, row in {
        "": ("onlyAuthor", "personalNonProfit", False, "prohibited", "required"),
        "own": ("onlySeparatelyLicensedPerson", "personalNonProfit", False, "allowModification", "required"),
        "event": ("onlySeparatelyLicensedPerson", "corporation", False, "allowModification", "required"),
        "everyone": ("everyone", "personalNonProfit", True, "allowModificationRedistribution", "required"),
    }.items()
})  # fmt: skip


def vrm_meta(terms: Terms, title: str) -> dict[str, Any]:
    """Return the ``meta`` of a VRM file.

    The person is the first author: "only the author" means the person shown, nobody else.

    Parameters
    ----------
    terms : Terms
    title : str
        What to call the avatar of a person who gave no name.
    """
    return {
        "name": terms.name or title,
        "version": "1",
        "authors": [terms.name or NAMELESS, *([terms.event] if terms.event else [])],
        "copyrightInformation": CREDITS,
        "thirdPartyLicenses": GENERIC_CREDITS,
        "licenseUrl": _LICENCE,
        **PERMISSIONS[terms.licence],
        **_ALWAYS,
    }
