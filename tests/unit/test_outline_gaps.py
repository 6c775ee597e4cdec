"""Distances between clone and photo outline, on a person whose outlines are exact."""

import numpy as np

from cloner.frames import BODY_VIEWS, ViewId
from cloner.interactive.outline_gaps import outline_gaps_mm
from kit import fitted


def gaps_of(vertices_m):
    person, _, outlines = fitted.fitted_person()
    return outline_gaps_mm(vertices_m, person.joints_m, person.views, outlines.views)


def test_a_person_who_fits_has_hardly_any_gap():
    person, _, _ = fitted.fitted_person()
    gaps = gaps_of(person.vertices_m)
    assert np.isfinite(gaps).mean() > 0.9, "three photos show an outline near almost all skin"
    assert np.nanpercentile(gaps, 90) < 3.0, "two pixels"


def test_a_swollen_flank_shows_its_gap_there_and_nowhere_else():
    person, _, _ = fitted.fitted_person()
    place = person.features_m["waist_left"]
    away = np.linalg.norm(person.vertices_m - place, axis=1)
    swollen = person.vertices_m + 0.02 * np.exp(-0.5 * (away / 0.06) ** 2)[:, None] * np.array([1.0, 0.0, 0.0])
    before, after = gaps_of(person.vertices_m), gaps_of(swollen)
    assert 8.0 < after[np.argmin(away)] < 25.0, "20 mm, a little smoothed"
    far = away > 0.4
    assert np.nanmax(np.abs(after[far] - before[far])) < 1.0


def test_without_body_photos_nothing_is_known():
    person, _, outlines = fitted.fitted_person()
    assert np.isnan(outline_gaps_mm(person.vertices_m, person.joints_m, {}, outlines.views)).all()
    assert set(person.views) >= set(BODY_VIEWS) - {ViewId.BODY_BACK}
