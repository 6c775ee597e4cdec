"""What is fuzzed: every parser of files that somebody else may have written, with good files to start from."""

from __future__ import annotations

import io
import json
import tempfile
import zipfile
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import cache
from importlib.resources import files
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np
from PIL import features

from cloner.behaviour.guiding import read_message
from cloner.behaviour.language import parse_actions, parse_scenario, read_scenario
from cloner.behaviour.trajectories import pack, read_trajectories
from cloner.behaviour.world import make_world
from cloner.behaviour.written import recorded
from cloner.booth.events.event import Event, read_event, write_event
from cloner.booth.events.recent import recent_events
from cloner.booth.phone.tickets import read_ticket
from cloner.booth.photos.arrivals import read_note
from cloner.booth.photos.check_cache import read_checks
from cloner.booth.visitors.visits import read_visit
from cloner.cloth.drafting.blocks import BLOCKS, draft_block
from cloner.cloth.drafting.cut import triangulate
from cloner.cloth.drafting.freesewing import read_svg_garment
from cloner.cloth.drafting.garmentcode import read_garment
from cloner.cloth.drafting.pattern import pattern_text, read_pattern
from cloner.cloth.drafting.sections import Sections, sections
from cloner.cloth.simulation.fabrics import read_fabric
from cloner.crowd.clones.groups import WORN
from cloner.crowd.packs.files import VERSION
from cloner.crowd.packs.reading import read_casting, read_facts
from cloner.crowd.staged.looks import make_casting
from cloner.crowd.staged.looks import read_looks as read_dyes
from cloner.crowd.staged.scene import make_scene
from cloner.errors import ClonerError, printable
from cloner.exporters.shared.obj_files import read_obj
from cloner.frames import ViewId
from cloner.generic.load import load_generic
from cloner.motion.captures.acclaim import read_acclaim
from cloner.motion.captures.bvh import read_bvh
from cloner.motion.face.faps import read_fap
from cloner.motion.face.score import read_score
from cloner.motion.face.sound import frame_features, read_sound, resampled
from cloner.motion.face.speech import phoneme_visemes, read_phonemes
from cloner.personal_data.leftovers import Traces, tells
from cloner.project.clone_file import load_clone, save_clone
from cloner.project.flow_file import FLOW_FILE, load_flow, save_flow
from cloner.project.folder import read_corrections, read_person
from cloner.project.manifest import find_visitors
from cloner.project.results import foreign_files
from cloner.project.stamps import why_not_current
from cloner.project.values_file import load_values, save_values
from cloner.records.clones import Clone
from cloner.records.flows import Flow
from cloner.records.points import Correction, Corrections
from cloner.scenes.building.reading import read_plan
from cloner.scenes.building.solids import build_room
from cloner.scenes.films.sequence import read_sequence
from cloner.statues.blobs import field_of, read_blobs
from cloner.statues.markers import read_markers
from cloner.vision.photographs.pictures import read_picture
from hostile import cases_motion, cases_photos
from kit.clones import toy_clone
from unit.cloth.test_freesewing import BACK, CAP, FRONT, draft_text
from unit.cloth.test_garmentcode import shirt, skirt, trousers

PERSON = b"""format = 1
event = "Fair"
licence = "own"
name = "Anna \\u00e9"
height_cm = 158.5
notes = '''two
lines'''
consent = "cloning, 2026-11-21"
[measures]
waist = 70.2
inside_leg_height = 78
"""
CORRECTIONS = b"""{"format": 1, "views": {"body_front": {"crotch": {"x": 10.5, "y": 20, "photo_sha256": "ab"}},
"face_side": {"nose_tip": {"x": 1e2, "y": -0.4}}}}"""
CSV = b'photos,id,height_cm\nanna,A 1,158\n"anna","b, c",\n'
TOML = b'[[visitor]]\nphotos = "anna"\nid = "A 1"\nheight_cm = 158\n[[visitor]]\nphotos = "./anna"\n'
ASF = b""":version 1.10
:units
  mass 1.0
  length 0.45
  angle deg
:root
  order TX TY TZ RX RY RZ
  axis XYZ
  position 0 0 0
  orientation 0 0 0
:bonedata
  begin
    id 1
    name lowerback
    direction 0 1 0
    length 2.0
    axis 0 0 0 XYZ
    dof rx ry rz
  end
:hierarchy
  begin
    root lowerback
  end
"""
AMC = b":FULLY-SPECIFIED\n:DEGREES\n1\nroot 0 1 0 0 0 0\nlowerback 1 2 3\n2\nroot 0 1 0 0 5 0\nlowerback 1 2 4\n"
SCORE = b'[[emotion]]\nexpression = "joy"\nstart = 0.5\nattack = 0.2\nstrength = 0.7\n[[head]]\nexpression = "nod"\n'
VISIT = b'{"name": "Anna", "state": "cloned"}'
LOOKS = b'{"ab": {"view": "body_front", "troubles": []}}'
MARKERS = b'{"format": 1, "markers": [{"at": "nose_tip", "px": [612, 800.5]}, {"at": 5130, "px": [5e2, 7]}]}'
BLOBS = b"""{"format": 1, "made_by": "Cloner", "blobs": [{"name": "l", "from": "l_hip", "to": "l_knee",
"radius_m": [0.09, 0.06], "off_m": [[0, 0, 0], [0, 0, 0.01]], "wide": [1, 1, 1.1]},
{"from": "vl3", "radius_m": [0.14]}]}"""
OBJ = b"""# a lump
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 1
vt 0 0
vt 1 0
vt 1 1
f 1/1 2/2 3/3 -1/1
f 1 3 2
f 1//1 4//1 3//1
"""
REPORT = b'{"stamp": {"cloner": "0.1.0", "photos": {"body_front": "ab"}}, "outputs": {"clone.npz": "cd"}}'
NEWER = b"""{"format": 3, "stamp": {"photos": {"body_front": "ab"}, "beside": {"person.toml": "ef"}}, "source": "01",
"outputs": {"clone.npz": "cd", "previews/face.jpg": "cd"}}"""
_JOINTS = np.zeros((94, 3))
TRACES = Traces({"ab": 3, "cd": None}, ("zacharias",), ("0123456789abcdef",))


@dataclass(frozen=True, slots=True)
class Target:
    """One parser.

    Attributes
    ----------
    file : str
        Name of the file it reads.
    seeds : callable
        Returns good files.
    read : callable
        Reads the file; may raise ClonerError only.
    """

    file: str
    seeds: Callable[[], tuple[bytes, ...]]
    read: Callable[[Path], Any]


@cache
def clone_bytes() -> bytes:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "clone.npz"
        save_clone(toy_clone(), path)
        return path.read_bytes()


@cache
def kept_bytes() -> tuple[bytes, bytes]:
    """Return good files of values and of an event's settings."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder)
        points = Corrections({ViewId.BODY_FRONT: {"crotch": Correction(1.0, 2.0, "ab")}})
        save_values({"corrections": points, "digests": {"body_front": "ab"}}, path / "values.npz")
        write_event(path, Event())
        return (path / "values.npz").read_bytes(), (path / "event.json").read_bytes()


def pictures() -> tuple[bytes, ...]:
    small = [cases_photos.encoded(kind, (70, 80)) for kind in ("JPEG", "PNG", "TIFF", "WEBP", "BMP", "GIF")]
    return (*small, cases_photos.heic(), cases_photos.animated(), *modern())


def modern() -> tuple[bytes, ...]:
    """Return small AVIF and HEIF photos, as far as this machine can write them."""
    found = []
    for kind, there in (("AVIF", features.check("avif")), ("HEIF", find_spec("pillow_heif") is not None)):
        if there:
            found.append(cases_photos.encoded(kind, (70, 80)))
    return tuple(found)


@cache
def pack_bytes() -> bytes:
    """Return a pack as a visitor takes it home or is handed out."""
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED) as pack:
        pack.writestr("anna/photos/body_front.jpg", cases_photos.JPEG)
        pack.writestr("anna/result/report.json", REPORT)
    return stream.getvalue()


def _beside(name: str, content: bytes) -> Callable[[Path], Any]:
    """Return a reader of a capture whose other half lies beside it."""

    def read(path: Path) -> Any:
        (path.parent / name).write_bytes(content)
        return read_acclaim(path.parent / "01_01.amc")

    return read


def _looks(path: Path) -> Any:
    (path.parent / "work").mkdir(exist_ok=True)
    path.replace(path.parent / "work" / "looks.json")
    return read_checks(path.parent)


def crowd_bytes() -> bytes:
    """Return what a pack of two clones says of itself, short of its other files."""
    shapes = {
        "vertices": ("uint16", [2, 4]), "loose": ("uint16", [2, 4]), "corners": ("uint16", [3]),
        "bones": ("int16", [1, 2, 3, 4]), "table": ("float32", [64, 4]), "tiles": ("float32", [2, 4]),
    }  # fmt: skip
    arrays = {name: {"at": 0, "type": kind, "shape": shape} for name, (kind, shape) in shapes.items()}
    clip = {"name": "walk", "seconds": 1.0, "speed_m_s": 1.3, "frames": 48}
    facts = {
        "format": "cloner-crowd", "version": VERSION, "scene": "walk", "people_count": 40,
        "people": [{"id": name, "arrays": arrays, "clips": [clip]} for name in ("ada", "ben")],
        "tiers": [{"largest_px": size} for size in (900, 400, 200, 90)],
        "switch": {"texels_per_px": 1.5, "texels_per_m": 33.0, "metres_per_focal_px": 0.045},
        "impostors": {"views": 22, "rings_deg": [5.0], "classic": False},
        "looks": {"clones": 2, "palettes": {"top": [255, 65280]}, "wardrobe": {"top": [[1], [0]]},
                  "own_share": 0.3, "dyed_share": 0.45},
        "player": {"sha256": "ab"}, "files": {"people/ada/numbers.bin": "cd"},
    }  # fmt: skip
    return json.dumps(facts).encode()


def walk_bytes() -> bytes:
    """Return what two people did in a second."""
    scenario = parse_scenario(
        "floor 0, 0 to 9, 9\nobstacle box at 4, 4 size 1 x 1\nthing vase at 4, 4\ncrowd 2 guests: wanders\n"
    )
    return pack(recorded(make_world(scenario), 1.0))


PLAN = b"""name = "hall"
[sun]
towards_deg = 90
elevation_deg = 40
light = [4, 3.6, 3]
[[photo]]
name = "oil"
file = "oil.png"
corners = [[10, 10], [400, 20], [390, 300], [20, 310]]
size = [2.4, 1.6]
[[floor]]
from = [0, 0]
to = [8, 6]
look = "flags"
[[wall]]
from = [8, 0]
to = [8.3, 6]
high = 3
look = "plaster"
openings = [{ at = 3, wide = 2, low = 0, high = 2.5 }]
[[pillar]]
names = ["a", "b"]
at = [[2, 2], [4, 4]]
size = [0.7, 0.7]
high = 3
look = "stone"
[[vault]]
from = [0, 0]
to = [8, 6]
spring = 3
rise = 2
look = "white"
[[lamp]]
at = [1, 1, 2]
light = [1, 1, 1]
radius = 0.1
"""


GUIDE = (b'{"token": "abcdefgh"}', b'{"do": "order", "text": "school goes to west"}')
CAMERA = b'{"folder": "/media/card", "known": {"IMG_0001.JPG": 512000}}'
TICKET = b'{"token": "0123456789abcdef", "expires": "2026-11-24T14:00:00+00:00"}'
RECENT = b'["/home/booth/fair", "/tmp"]'
DYES = b"""own_share = 0.3
dyed_share = 0.45
wardrobe = true
[palette]
top = ["#2F3B52", "#7C2D2F"]
hair = "natural"
"""
FILM = b"""film "Awake" for 9 s, 320 x 180, 25 frames a second
actor first is boris at 6.3, 9 facing 180 in stone, .12 m deep
rows left of 3 x 6 from .9, 9 to 3.4, 19 facing 180 in stone, .12 m deep
at 0 s: light .004, .007, .016
at 0 s: camera at 7, -6, 3.4 looks at 7, 14, 9, lens 50
at 1 s: camera moves to 7, -2.5, 2.6 looks at 7, 12, 1.2, lens 46 in 9 s
at 2 s: caption "Under the earth" for 6 s
"""
DRAWING = b"""<svg xmlns="http://www.w3.org/2000/svg" width="800mm" viewBox="0 0 800 800"
data-seams="front.left back.left; front.right back.right">
<path id="front" data-edges="top left hem right" d="M 0,0 L 400,0 V 600 H 0 Z"/>
<path id="back" data-edges="top right hem left" d="m 0 0 h 400 c 50,200 50,400 0 600 l -400 0 z"/></svg>"""
SCENARIO = b"""floor 0, 0 to 20, 12
obstacle box at 4, 4 size 1 x 1
point east at 18, 6 region 3 x 6
point west at 2, 6 region 3 x 6
group school: 4 people, starts at east
crowd 6 guests: wanders
at 3 s: school goes to west
"""
_SCHOOL = parse_scenario("floor 0, 0 to 9, 9\npoint west at 2, 6\ngroup school: 4 people, starts at west\n")


FABRIC = (files("cloner.cloth.simulation") / "fabrics" / "wool.toml").read_bytes()
_BARE = {garment: np.zeros((1, 1), np.bool_) for garment in WORN}


def _wish(path: Path) -> None:
    """Read what a guide says as the server does; an order's text goes on to the language."""
    try:
        said = read_message(path.read_bytes())
    except ValueError:
        return
    if said.get("do") == "order":
        parse_actions(str(said.get("text", "")), _SCHOOL)


def _folded(name: str, read: Callable[[Path], Any]) -> Callable[[Path], Any]:
    """Return a reader of a folder's own note, which lies under another name than ours."""

    def moved(path: Path) -> Any:
        path.replace(path.parent / name)
        return read(path.parent)

    return moved


def _crowd(path: Path) -> Any:
    facts = read_facts(path.parent)
    return make_scene(facts["scene"], min(facts["people_count"], 300), read_casting(facts))


def _visitors(path: Path) -> None:
    (path.parent / "anna").mkdir(exist_ok=True)
    find_visitors(path)


@cache
def _measured() -> Sections:
    return sections(toy_clone())


@cache
def _skirted() -> Clone:
    clone = toy_clone()
    return replace(clone, shells=(replace(clone.shells[0], kind="cloth"),))


@cache
def _flow_bytes() -> bytes:
    generic, count = load_generic(), len(_skirted().shells[0].vertices_m)
    turns = np.zeros((2, len(generic.joint_parents), 3), np.float32)
    flow = Flow(np.zeros((2, count, 3), np.float32), turns[:, 0], turns, np.zeros(len(generic.vertices_m), np.bool_))
    with tempfile.TemporaryDirectory() as folder:
        save_flow(flow, Path(folder) / FLOW_FILE)
        return (Path(folder) / FLOW_FILE).read_bytes()


TARGETS: Mapping[str, Target] = {
    "person": Target("person.toml", lambda: (PERSON,), lambda path: read_person(path.parent)),
    "corrections": Target("corrections.json", lambda: (CORRECTIONS,), lambda path: read_corrections(path.parent)),
    "csv": Target("list.csv", lambda: (CSV,), _visitors),
    "toml": Target("list.toml", lambda: (TOML,), _visitors),
    "bvh": Target("walk.bvh", lambda: ((cases_motion.HEAD + cases_motion.MOTION).encode(),), read_bvh),
    "fap": Target("face.fap", lambda: (cases_motion.FAP.encode(),), read_fap),
    "phonemes": Target("talk.txt", lambda: (b"AA1 0.1\nSIL 0.2\n",), lambda path: phoneme_visemes(read_phonemes(path))),
    "wav": Target("talk.wav", lambda: (cases_motion.wav(data=cases_motion.SOUND[:4000]),),
                  lambda path: frame_features(resampled(*read_sound(path)))),
    "report": Target("report.json", lambda: (REPORT,), lambda path: why_not_current(path.parent, {})),
    "asf": Target("01.asf", lambda: (ASF,), _beside("01_01.amc", AMC)),
    "amc": Target("01_01.amc", lambda: (AMC,), _beside("01.asf", ASF)),
    "score": Target("score.toml", lambda: (SCORE,), lambda path: read_score(path, ("jawOpen",))),
    "event": Target("event.json", lambda: (kept_bytes()[1],), lambda path: read_event(path.parent)),
    "visit": Target("visit.json", lambda: (VISIT,), lambda path: read_visit(path.parent)),
    "looks": Target("looks.json", lambda: (LOOKS,), _looks),
    "values": Target("values.npz", lambda: (kept_bytes()[0],), load_values),
    "avif": Target("body_front.avif", lambda: modern() or (cases_photos.heic(),), read_picture),
    "walk": Target("museum.walk", lambda: (walk_bytes(),), read_trajectories),
    "plan": Target("plan.toml", lambda: (PLAN,), lambda path: build_room(read_plan(path)[0])),
    "crowd": Target("crowd.json", lambda: (crowd_bytes(),), _crowd),
    "pack": Target("pack.zip", lambda: (pack_bytes(),), lambda path: tells(path, TRACES)),
    "manifest": Target("report.json", lambda: (REPORT, NEWER), lambda path: foreign_files(path.parent)),
    "photo": Target("body_front.jpg", pictures, read_picture),
    "markers": Target("markers.json", lambda: (MARKERS,), lambda path: read_markers(path).vertices(named=True)),
    "blobs": Target("blobs.json", lambda: (BLOBS,), lambda path: field_of(read_blobs(path), _JOINTS).at(_JOINTS)),
    "obj": Target("mesh.obj", lambda: (OBJ,), read_obj),
    "scenario": Target("museum.crowd", lambda: (SCENARIO,), read_scenario),
    "guide": Target("said.json", lambda: GUIDE, _wish),
    "film": Target("awakening.film", lambda: (FILM,), read_sequence),
    "dyes": Target("looks.toml", lambda: (DYES,), lambda path: make_casting([_BARE, _BARE], read_dyes(path))),
    "pattern": Target("skirt.json", lambda: (pattern_text(draft_block(BLOCKS["skirt"], 0.7, 0.5)).encode(),),
                      lambda path: triangulate(read_pattern(path), 0.2)),
    "garmentcode": Target("mine.json", lambda: tuple(json.dumps(told()).encode() for told in (skirt, shirt, trousers)),
                          lambda path: triangulate(read_garment(path, _measured()), 0.2)),
    "fabric": Target("wool.toml", lambda: (FABRIC,), read_fabric),
    "cloth": Target("cloth.npz", lambda: (_flow_bytes(),), lambda path: load_flow(path.parent, _skirted())),
    "drawing": Target("skirt.svg", lambda: (DRAWING,),
                      lambda path: triangulate(read_svg_garment(path, _measured()), 0.2)),
    "freesewing": Target("tee.svg", lambda: (draft_text({"front": FRONT, "back": BACK, "sleeve": CAP}).encode(),),
                         lambda path: triangulate(read_svg_garment(path, _measured()), 0.2)),
    "ticket": Target("phone.json", lambda: (TICKET,), lambda path: read_ticket(path.parent)),
    "camera": Target("camera.json", lambda: (CAMERA,),
                     _folded(".camera.json", lambda folder: read_note(folder, Path("/media/card")))),
    "recent": Target("recent.json", lambda: (RECENT,), recent_events),
    "clone": Target("clone.npz", lambda: (clone_bytes(),), load_clone),
}  # fmt: skip


def check(name: str, data: bytes, folder: Path) -> None:
    """Give a parser some bytes; whatever it raises but a proper ClonerError comes through."""
    target = TARGETS[name]
    path = folder / target.file
    path.write_bytes(data)
    try:
        target.read(path)
    except ClonerError as error:
        if not (error.message and error.hint and error.where) or str(folder) in str(error):
            raise AssertionError(f"no proper sentence: {error}") from error
        if printable(error.message) != error.message:
            raise AssertionError("a sentence that a terminal would obey") from error
