"""Make a pack: clones as levels, impostors and looks, with the page that shows them."""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from cloner import __version__
from cloner.crowd.clones import stock
from cloner.crowd.clones.cast import CrowdClone, make_crowd_clone
from cloner.crowd.clones.faces import FEELINGS, STEP_M, TARGETS, face_rows
from cloner.crowd.clones.glb import levels_glb
from cloner.crowd.clones.groups import GROUPS, STEP, grey_atlas, sorted_by_group
from cloner.crowd.clones.levels import FLOWING, LOOSE, BodyLevels, body_levels
from cloner.crowd.clones.people import find_people, load_person
from cloner.crowd.clones.vat import vat_files
from cloner.crowd.drawing.impostors import BakeSettings, bake
from cloner.crowd.drawing.player import BODY_FILE, FACE_FILE, player_page
from cloner.crowd.drawing.theatre import DEPTH_RANGE_M, SUN
from cloner.crowd.packs.files import (
    FORMAT,
    MARK,
    SHELL_QUALITY,
    VERSION,
    digest,
    encode_webp,
    pack_arrays,
    pack_folder,
    shell_bytes,
    small_png,
    tile_files,
)
from cloner.crowd.packs.wanted import PackOptions, check_options
from cloner.crowd.staged import scene
from cloner.crowd.staged.looks import exchangeable_garments, make_casting, read_looks
from cloner.project.flow_file import FLOW_FILE, load_flow
from cloner.records.clones import Clone

#: Width of the walking chest with arms against its depth from which arms and coats need 40 views. The source gives no
#: number; chests of 18 clones that walk lie between 1.6 and 2.3.
WIDE_RATIO: Final = 3.0
FEW_VIEWS, MANY_VIEWS = 22, 40
MIRRORED_VIEWS: Final = 30  # of which 16 are baked, as Tecchia does
#: Tallest person, pixels, that each level is good for: SSIM .98 against every triangle, mean of each of 20 clones; no
#: end for the finest. Patterns on cloth decide, which slide where triangles are fewer.
LARGEST_PX: Final = (0, 166, 96, 50)
ATLAS_QUALITY: Final = 85


def make_pack(
    results: Sequence[Path], out: Path, wanted: PackOptions, report: Callable[[str, int, int], None] = lambda *_: None
) -> dict[str, Any]:
    """Write a pack of clones and return the contents of its ``crowd.json``.

    Parameters
    ----------
    results : sequence of Path
        Result folders, or folders of results.
    out : Path
        The pack's folder; an older pack there is replaced when all went well.
    wanted : Wanted
    report : callable
        Gets each clone's name, its number from 1 and how many there are.

    Raises
    ------
    ClonerError
        If no clone can be used, one may not be shown, or the disk refuses.
    """
    check_options(wanted)
    looks = read_looks(wanted.looks)
    make_casting([], looks)  # nobody waits for a bake to hear that a colour is none, or that the last clone is refused
    found, body, generic, first_bone = find_people(results), body_levels(mouth=wanted.faces), "", 0
    for one in found:
        _, generic = load_person(one, generic)
    budgets = FLOWING if any((one.folder / FLOW_FILE).is_file() for one in found) else LOOSE
    files: dict[str, str] = {}
    rows, masks, tones = [], [], []
    with pack_folder(out) as folder:
        for number, one in enumerate(found, start=1):
            report(one.identifier, number, len(found))
            clone, _ = load_person(one, generic)
            cast = make_crowd_clone(
                one.identifier, clone, body, poses=wanted.poses, walks=wanted.walks, feelings=wanted.feelings,
                carved=wanted.carved, flow=load_flow(one.folder, clone), faces=wanted.faces,
                budgets=budgets,
            )  # fmt: skip
            row, first_bone = _write_person(folder, cast, clone, body, wanted, budgets, first_bone, files)
            rows.append(row)
            if cast.stone is not None:
                tones.append(cast.stone[cast.codes > 0].mean(axis=0) / 255.0)
            masks.append(exchangeable_garments(cast))
        casting = make_casting(masks, looks)
        arrays = body_arrays(body) | ({"face": face_rows(body)} if wanted.faces else {})
        data, body_told = pack_arrays(arrays)
        _write(folder, BODY_FILE, data, files)
        facts = _facts(wanted, rows, body, budgets, casting, body_told, files)
        if wanted.compressed:
            facts["compressed"] = True
        if wanted.faces:
            facts["faces"] = {"targets": list(TARGETS), "feelings": list(FEELINGS), "step_m": STEP_M}
        if tones:
            facts["statues"] = {"colour": np.mean(tones, axis=0).round(4).tolist()}
        page = player_page(folder, facts)
        facts["player"] = {"sha256": digest(page), "bytes": len(page)}
        (folder / "player.html").write_bytes(page)
        (folder / MARK).write_text(json.dumps(facts, indent=1, sort_keys=True) + "\n", encoding="utf-8")
    return facts


def _write_person(
    folder: Path,
    cast: CrowdClone,
    clone: Clone,
    body: BodyLevels,
    wanted: PackOptions,
    budgets: tuple[int, ...],
    first_bone: int,
    files: dict[str, str],
) -> tuple[dict[str, Any], int]:
    """Write one clone's files and return its row of ``crowd.json`` and the next clone's first bone."""
    plan = replace(bake_settings(wanted, cast), fine=budgets == FLOWING)
    own = stock.clone_arrays(cast, budgets)
    tiles = bake(cast, body, make_stock(body, [cast], [own], [stock.sets_without_impostors(cast)], plan, budgets), plan)
    table = stock.table_row(cast, tiles.sets, plan.texels_per_m, tiles.views, first_bone)
    arrays: dict[str, NDArray[Any]] = {
        "vertices": own.vertices, "loose": own.loose, "corners": own.corners, "bones": own.bones, "table": table,
        "tiles": tiles.rows,
    }  # fmt: skip
    data, layout = pack_arrays(arrays)
    place = f"people/{cast.identifier}"
    content = {
        "numbers.bin": data,
        **tile_files(tiles),
        "atlas.webp": encode_webp(cast.atlas, ATLAS_QUALITY),
        "codes.webp": encode_webp(cast.marks, None),
        "shell.webp": shell_bytes(cast.shell),
        "grey.png": small_png(grey_atlas(cast.atlas, cast.codes, cast.looks)),
        f"{cast.identifier}.glb": levels_glb(cast, clone, body),
    }
    if cast.stone is not None and cast.stone_shell is not None:
        content["stone.webp"] = encode_webp(cast.stone, ATLAS_QUALITY)
        content["stone_shell.webp"] = encode_webp(cast.stone_shell, SHELL_QUALITY)
    faced: dict[str, Any] = {}
    if cast.face is not None:
        content[FACE_FILE], faced = pack_arrays({"moves": cast.face})
    if wanted.vat:
        content |= vat_files(cast, body)
    for name, one in content.items():
        _write(folder, f"{place}/{name}", one, files)
    row = {
        "id": cast.identifier,
        "consent": "recorded",
        "stature_m": round(cast.stature_m, 4),
        "width_to_depth": round(cast.width_to_depth, 3),
        "views": tiles.views,
        "stamp": clone.stamp,
        "arrays": layout,
        **({"face": faced} if faced else {}),
        "clips": [
            {"name": clip.name, "seconds": clip.seconds, "speed_m_s": round(clip.speed_m_s, 4),
             "frames": len(clip.frames), "poses": clip.poses, "impostors": seen.name.lower()}
            for clip, (_, seen) in zip(cast.clips, tiles.sets, strict=True)
        ],
        "outfit": {name: [round(value) for value in look.colour] for name, look in cast.looks.items()},
        "loose_triangles": [len(triangles) for triangles in cast.loose.triangles],
        "groups": [sorted_by_group(t, body.uv, cast.codes)[1] for t in body.triangles],
    }  # fmt: skip
    return row, first_bone + len(own.bones)


def bake_settings(wanted: PackOptions, cast: CrowdClone) -> BakeSettings:
    """Return the settings for baking a clone's impostors."""
    views = wanted.views or (MANY_VIEWS if cast.width_to_depth > WIDE_RATIO else FEW_VIEWS)
    elevations = tuple(float(np.radians(ring)) for ring in wanted.rings_deg)
    plan = BakeSettings(views, (wanted.views or MIRRORED_VIEWS) if wanted.mirror else 0, elevations)
    return replace(plan, texels_per_m=plan.texels_per_m / stock.TEXELS_PER_PX) if wanted.classic else plan


def make_stock(
    body: BodyLevels,
    casts: Sequence[CrowdClone],
    numbers: Sequence[stock.CloneArrays],
    sets: Sequence[stock.Sets],
    plan: BakeSettings,
    budgets: tuple[int, ...] = LOOSE,
) -> stock.CrowdArrays:
    """Return the stock of some clones without impostors."""
    first = stock.first_frame_rows([cast.clips for cast in casts])
    rows = [
        stock.table_row(cast, own, plan.texels_per_m, plan.views, bone)
        for cast, own, bone in zip(casts, sets, first, strict=True)
    ]
    return stock.CrowdArrays(
        body, budgets, tuple(numbers), np.stack(rows), np.stack([np.dstack([c.atlas, c.marks]) for c in casts]),
        np.stack([cast.shell for cast in casts]),
    )  # fmt: skip


def body_arrays(body: BodyLevels) -> dict[str, NDArray[Any]]:
    """Return the arrays of the body that all clones share."""
    arrays: dict[str, NDArray[Any]] = {
        "uv": body.uv.astype(np.float32), "joints": body.joints.astype(np.uint8),
        "weights": body.weights.astype(np.float32),
    }  # fmt: skip
    return arrays | {f"level_{k}": triangles.astype(np.uint16) for k, triangles in enumerate(body.triangles)}


def _facts(
    wanted: PackOptions,
    rows: list[dict[str, Any]],
    body: BodyLevels,
    budgets: tuple[int, ...],
    casting: scene.Casting,
    body_told: dict[str, Any],
    files: dict[str, str],
) -> dict[str, Any]:
    per_px = 1.0 if wanted.classic else stock.TEXELS_PER_PX
    texels = stock.TEXELS_PER_M * per_px / stock.TEXELS_PER_PX
    tiers = [
        {"level": k, "body_triangles": len(triangles), "loose_triangles": budgets[k], "vertices": body.counts[k],
         "largest_px": LARGEST_PX[k]}
        for k, triangles in enumerate(body.triangles)
    ]  # fmt: skip
    return {
        "format": FORMAT, "version": VERSION, "made_with": f"Cloner {__version__}", "scene": wanted.scene,
        "people_count": wanted.people, "people": rows, "tiers": tiers,
        "switch": {"texels_per_px": per_px, "texels_per_m": texels, "metres_per_focal_px": per_px / texels},
        "impostors": {"views": max(row["views"] for row in rows), "rings_deg": list(wanted.rings_deg),
                      "poses": wanted.poses, "depth_range_m": DEPTH_RANGE_M, "baked_from_m": stock.BAKED_FROM_M,
                      "classic": wanted.classic},
        "regions": {"names": list(GROUPS), "codes": {name: STEP * (k + 1) for k, name in enumerate(GROUPS)}},
        "looks": scene.facts(casting), "body_arrays": body_told, "files": files,
        "numbers": {"box_min_m": list(stock.BOX_MIN_M), "box_step_m": stock.BOX_STEP_M,
                    "bone_reach_m": stock.BONE_REACH_M, "loose": list(budgets), "code_step": STEP, "sun": list(SUN)},
    }  # fmt: skip


def _write(folder: Path, name: str, data: bytes, files: dict[str, str]) -> None:
    path = folder / name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(data)
    files[name] = digest(data)
