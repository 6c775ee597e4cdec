"""The export formats; each row's ``export`` loads on first use.

``export(clone, folder, *, name="clone") -> tuple[Path, ...]`` writes the
files and returns their paths. ``small`` is a packed glTF, ``lods`` one with coarser levels, ``mixamo`` one with
Mixamo's bones, ``unity`` and ``unreal`` with those engines', ``vrma`` a motion
alone, ``wrl`` a seamless VRML, ``hanim`` one of rigid pieces on H-Anim 1.1's
prototypes, ``flat`` one that stands still.
"""

from __future__ import annotations

from collections.abc import Sequence

from cloner.errors import ClonerError
from cloner.registry import Registry

EXPORTERS = Registry("format")
EXPORTERS.add("glb", "cloner.exporters.gltf.gltf:export")
EXPORTERS.add("small", "cloner.exporters.gltf.gltf_small:export")
EXPORTERS.add("lods", "cloner.crowd.clones.lods:export")
EXPORTERS.add("mixamo", "cloner.exporters.avatars.mixamo:export")
EXPORTERS.add("unity", "cloner.exporters.avatars.engines:export_unity")
EXPORTERS.add("unreal", "cloner.exporters.avatars.engines:export_unreal")
EXPORTERS.add("wrl", "cloner.exporters.vrml.vrml97:export")
EXPORTERS.add("hanim", "cloner.exporters.vrml.vrml_hanim:export")
EXPORTERS.add("flat", "cloner.exporters.vrml.vrml_flat:export")
EXPORTERS.add("x3d", "cloner.exporters.vrml.x3d:export")
EXPORTERS.add("vrm", "cloner.exporters.avatars.vrm:export")
EXPORTERS.add("vrma", "cloner.exporters.avatars.vrma:export")
EXPORTERS.add("usdz", "cloner.exporters.usd:export")
EXPORTERS.add("obj", "cloner.exporters.meshes:export_obj")
EXPORTERS.add("regions", "cloner.exporters.shared.regions:export")
EXPORTERS.add("ply", "cloner.exporters.meshes:export_ply")


def check_formats(formats: Sequence[str]) -> None:
    """Refuse formats nobody can write, before any work.

    USD's library is loaded here, before other threads compute: its loading waits for Python's lock inside the dynamic
    loader's, and NumPy asks the loader under Python's lock (its stack walk for temporaries): both would wait for ever.

    Raises
    ------
    ClonerError
        If a name is not in the table, or USD is asked for and its library is not installed.
    """
    for name in formats:
        if name not in EXPORTERS:
            hint = f"The formats are {', '.join(EXPORTERS)}"
            raise ClonerError(f"the format {name!r} is not known", hint, "--format")
    if "usdz" in formats:
        from cloner.exporters.usd import usd_library

        usd_library()
