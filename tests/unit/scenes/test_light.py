"""Light against what is known: a closed box, a lamp, the sun's borders, a flat surface cut in two, and a figure."""

from __future__ import annotations

import numpy as np
import pytest

from cloner.crowd.staged.rooms import light_at
from cloner.scenes.building.charts import make_grid
from cloner.scenes.building.reading import parse_plan
from cloner.scenes.building.solids import Room, build_room
from cloner.scenes.lighting.direct import lamp_share_at, sun_direction
from cloner.scenes.lighting.light import Lit, cells_at, light_room
from cloner.scenes.lighting.probes import make_probes
from cloner.scenes.lighting.rays import RayQuads, hemisphere_directions, sphere_directions

ALBEDO = 0.8  # of the look "white"
SIZE = (5.0, 4.0, 3.0)


def wall(low, high, more: str = "", tall: float = 3.0) -> str:
    return f'[[wall]]\nfrom = {list(low)}\nto = {list(high)}\nhigh = {tall}\nlook = "white"\n{more}\n'


def box(more: str = "", hole: str = "") -> str:
    floor = '[[floor]]\nfrom = [0, 0]\nto = [5, 4]\nlook = "white"\n'
    roof = '[[ceiling]]\nfrom = [-0.3, -0.3]\nto = [5.3, 4.3]\nat = 3\nlook = "white"\n'
    sides = wall((-0.3, -0.3), (5.3, 0)) + wall((-0.3, 4), (5.3, 4.3)) + wall((-0.3, 0), (0, 4))
    sides += wall((5, 0), (5.3, 4), hole)
    return floor + sides + roof + more


LAMP = "[[lamp]]\nat = [1.5, 2.5, 1.9]\nlight = [1, 1, 1]\nradius = 0.02\n"
WINDOW = "openings = [{ at = 2, wide = 1.4, low = 0.9, high = 2.4 }]"
SKY = "[sky]\nlight = [2, 2, 2]\n"
SUN = "[sun]\ntowards_deg = 90\nelevation_deg = 35\nlight = [4, 4, 4]\n"


def lit(text: str, texel_m: float = 0.05, rays: int = 400) -> tuple[Room, Lit]:
    room = build_room(parse_plan(text, "test"))
    return room, light_room(room, texel_m=texel_m, rays=rays)


def own(room: Room, light: Lit, k: int) -> tuple[np.ndarray, np.ndarray, object]:
    """A chart's light, whether it is there, and its grid."""
    chart = light.charts[k]
    grid = make_grid(room, chart.panel, chart.size)
    return light.map[chart.y : chart.y + chart.size[1], chart.x : chart.x + chart.size[0], 0], grid.there, grid


def test_a_closed_white_box_keeps_what_its_lamp_gives() -> None:
    """Flux on the walls is what the lamp gives over 1 - albedo: 4 pi I / (1 - a)."""
    room, light = lit(box(LAMP))
    flux = 0.0
    for k, chart in enumerate(light.charts):
        values, there, _ = own(room, light, k)
        half = [np.where((np.arange(n) == 0) | (np.arange(n) == n - 1), 0.5, 1.0) for n in values.shape]
        weight = np.outer(*half) * there
        sides = zip((SIZE[0], SIZE[2], SIZE[1]), chart.panel.normal, strict=True)
        area = np.prod([long for long, n in sides if abs(n) < 0.5])
        flux += (values * weight).sum() / weight.sum() * area
    assert flux == pytest.approx(4.0 * np.pi / (1.0 - ALBEDO), rel=0.03)


def test_straight_light_below_a_lamp_is_what_the_law_of_squares_says() -> None:
    lamp = "[[lamp]]\nat = [2, 2, 2]\nlight = [3, 3, 3]\nradius = 0.01\n"
    room, light = lit('[[floor]]\nfrom = [0, 0]\nto = [4, 4]\nlook = "white"\n' + lamp)
    values, _, grid = own(room, light, 0)
    far = (grid.places[..., 0] - 2.0) ** 2 + (grid.places[..., 2] + 2.0) ** 2 + 4.0
    assert values == pytest.approx(3.0 * 2.0 / far**1.5, rel=0.01)


def test_a_floor_under_the_open_sky_gets_all_of_it() -> None:
    room, light = lit('[[floor]]\nfrom = [0, 0]\nto = [4, 4]\nlook = "white"\n' + SKY + SUN)
    values, _, _ = own(room, light, 0)
    assert values == pytest.approx(2.0 + 4.0 * np.sin(np.radians(35.0)), rel=1e-5)


def test_sky_through_a_window_is_the_windows_form_factor() -> None:
    """Light on the opposite wall, black walls: the window's point-to-area form factor, by quadrature here."""
    room, light = lit(box(SKY, WINDOW).replace('"white"', '"timber"'), rays=64)
    k = next(k for k, one in enumerate(light.charts) if one.panel.normal[0] > 0.9 and one.panel.size[1] > 2.9)
    place = np.array([0.0, 0.6, -1.0])
    values, _, grid = own(room, light, k)
    at = np.abs(grid.places - place).sum(axis=-1)
    y, z = np.meshgrid(np.linspace(0.9, 2.4, 201)[:-1] + 0.00375, np.linspace(-2.7, -1.3, 201)[:-1] + 0.0035)
    to = np.stack([np.full(y.shape, 5.3), y, z], axis=-1) - place
    far = (to**2).sum(axis=-1)
    inner = place + to * (5.0 / 5.3)  # what the reveal lets through
    free = (inner[..., 1] > 0.9) & (inner[..., 1] < 2.4) & (inner[..., 2] > -2.7) & (inner[..., 2] < -1.3)
    want = 2.0 * (free * to[..., 0] ** 2 / far**2).mean() * 1.5 * 1.4 / np.pi
    got = values.ravel()[at.argmin()]
    assert want < got < 1.6 * want, "the window's light, and some more over dark walls"


def test_the_suns_border_lies_where_the_window_casts_it() -> None:
    room, light = lit(box(SUN, WINDOW), texel_m=0.04, rays=64)
    k = next(k for k, one in enumerate(light.charts) if one.panel.normal[1] > 0.9 and one.panel.size[1] > 3.9)
    values, _, grid = own(room, light, k)
    way = sun_direction(room.plan.sun)
    slope = way[0] / way[1]
    line = values[len(grid.v) // 2]
    bright = grid.u[line > line.min() + 1.0]
    assert bright.max() == pytest.approx(5.0 - 0.9 * slope, abs=0.04), "the sill's inner edge"
    assert bright.min() == pytest.approx(5.3 - 2.4 * slope, abs=0.04), "the lintel's outer edge"


def test_a_wall_of_two_pieces_shows_no_seam() -> None:
    """Two walls end to end are one panel; the same light within 2 % on both sides of where they meet."""
    whole = box(LAMP + SUN + SKY, WINDOW)
    cut = whole.replace(wall((-0.3, 4), (5.3, 4.3)), wall((-0.3, 4), (2.2, 4.3)) + wall((2.2, 4), (5.3, 4.3)))
    for text in (whole, cut):
        room, light = lit(text, rays=200)
        k = next(k for k, one in enumerate(light.charts) if one.panel.normal[2] > 0.9 and one.panel.size[1] > 2.9)
        values, _, grid = own(room, light, k)
        here = np.searchsorted(grid.u, 2.5)
        step = np.abs(np.diff(values[5:-5, here - 3 : here + 3], axis=1)) / values[5:-5, here - 3 : here + 2]
        assert step.max() < 0.02
        assert len(light.charts[k].panel.parts) == (2 if text is cut else 1)


def figure(place) -> tuple[np.ndarray, np.ndarray]:
    """Places and normals all over a standing figure of 1.75 m: a round body on the plan's place."""
    angles, heights = np.meshgrid(np.linspace(0, 2 * np.pi, 12, endpoint=False), np.linspace(0.08, 1.67, 10))
    normals = np.stack([np.sin(angles), 0 * angles, np.cos(angles)], axis=-1).reshape(-1, 3)
    rise = np.column_stack([0 * angles.ravel(), heights.ravel(), 0 * angles.ravel()])
    places = np.array([place[0], 0.0, -place[1]]) + 0.2 * normals + rise
    return places, normals


@pytest.mark.parametrize("place", [(1.2, 1.1), (2.5, 2.0), (4.1, 3.2), (3.4, 1.0)])
def test_a_grey_figure_in_the_light_of_probes_is_lit_as_rays_light_it(place) -> None:
    """Means over the figure within 10 %: its own shadow is left to the contact shadow."""
    room, light = lit(box(LAMP + SKY, WINDOW), rays=300)
    probes = make_probes(room, light)
    places, normals = figure(place)
    held, _ = light_at(probes, np.array([[place[0], 1.1, -place[1]]]))
    by_probes = np.maximum(held[0, 0, 0] + normals @ held[0, 0, 1:], 0.0)
    traced = np.array([traced_at(room, light, p, n) for p, n in zip(places, normals, strict=True)])
    assert by_probes.mean() == pytest.approx(traced.mean(), rel=0.1)


def traced_at(room: Room, light: Lit, place: np.ndarray, normal: np.ndarray, rays: int = 600) -> float:
    """Irradiance by rays alone: surfaces, sky, and the lamp where it is seen."""
    up = np.array([0.0, 1.0, 0.0])
    turned = hemisphere_directions(rays) @ np.array([np.cross(up, normal), up, normal])
    quad, _, where = light.stops.first_hits(place, turned)
    given = light.patches.given[cells_at(light.patches, quad, where)][:, 0]
    given[(quad < 0) & (turned[:, 1] > 0)] = room.plan.sky.light[0]
    lamps = sum(one.light[0] * lamp_share_at(place[None], normal, light.stops, one)[0] for one in room.plan.lamps)
    return float(given.mean() + lamps)


def test_rays_agree_with_a_slow_look_at_every_quad() -> None:
    room = build_room(parse_plan(box(hole=WINDOW), "test"))
    stops, origin = RayQuads(room.stops), np.array([2.2, 1.1, -1.7])
    ways = sphere_directions(500)
    found, away, _ = stops.first_hits(origin, ways)
    for way, quad, far in zip(ways, found, away, strict=True):
        best = np.inf
        for one in room.stops:
            falls = way @ one.normal
            if falls >= 0:
                continue
            t = (one.corner - origin) @ one.normal / falls
            at = origin + t * way - one.corner
            a, b = at @ one.along / (one.along @ one.along), at @ one.up / (one.up @ one.up)
            if t > 0 and 0 <= a <= 1 and 0 <= b <= 1:
                best = min(best, t)
        assert far == pytest.approx(best, rel=1e-4), quad


def test_a_floor_is_not_lighter_where_it_goes_on_below_a_wall() -> None:
    """The museum's fault once: places exactly on a wall's face saw the sky through it."""
    yard = '[[floor]]\nfrom = [5.3, -1]\nto = [8, 5]\nlook = "white"\n'
    yard += '[[floor]]\nfrom = [5, 1.5]\nto = [5.3, 2.5]\nlook = "white"\n'
    door = "openings = [{ at = 2, wide = 1, low = 0, high = 2.2 }]"
    room, light = lit(box(yard + SKY, door), texel_m=0.1, rays=200)
    k = next(k for k, one in enumerate(light.charts) if one.panel.normal[1] > 0.9 and one.panel.size[0] > 7.9)
    values, _, grid = own(room, light, k)
    row = np.abs(grid.places[:, 0, 2] + 3.5).argmin()
    inner = (grid.u > 0.3) & (grid.u <= 4.96)
    assert values[row][inner].max() < 2.0 * np.median(values[row][inner])
