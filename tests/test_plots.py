"""Pictures: what is drawn is the motion, with units; no text lies on another; greys and dashes tell things apart."""

import re
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import matplotlib.pyplot
import numpy as np
import pytest
from matplotlib.collections import PolyCollection
from matplotlib.contour import ContourSet
from matplotlib.patches import Polygon
from matplotlib.text import Text
from PIL import Image, ImageSequence

from slipcircle import Arc, Scene, Section, Slope, critical, grid, load, solve
from slipcircle.messages import swings_back
from slipcircle.workbench.common.trace import columns_of_picture as trace
from slipcircle.workbench.common.trace import csv
from slipcircle.workbench.cost.ladder import effect_ladder
from slipcircle.workbench.files.loaded import stability_of
from slipcircle.workbench.outputs.json_records import record
from slipcircle.workbench.outputs.pictures import layerplot, plots, plotstyle, searchplot, sectionplot
from slipcircle.workbench.outputs.report import report
from slipcircle.workbench.outputs.tables import cell_text, stretches_part
from slipcircle.workbench.studies.fragility import interval_note
from tests.support.layered import TURNING, profile
from tests.support.motions import from_method
from tests.support.outputs import printed
from tests.support.pictures import SCENES, canvas, clashes, drawn, legend, motion

matplotlib.use("agg")


each_scene = pytest.mark.parametrize("name", SCENES)


# --- no text on another --------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["vaiont-heated", "newmark-pulse", "swings", "still", "to the left"])
def test_no_text_lies_on_another(name: str) -> None:
    drawing = plots.motion_overview(motion(name))
    figure = drawing.draw(canvas(drawing.size, 60))
    assert clashes(figure) == []
    written = figure.findobj(Text)
    assert len(written) > 15
    assert all(float(text.get_fontsize()) >= 8.0 for text in written)


# --- what is drawn -------------------------------------------------------------------------------------------------


@each_scene
def test_history_draws_the_motion(name: str) -> None:
    m = motion(name)
    for what in plots.HISTORIES:
        ax = plots.history(m, what, drawn())
        if not m.moves:
            assert "does not move" in ax.texts[0].get_text()
            continue
        time, value = ax.lines[0].get_data()
        unit = ax.get_ylabel().partition("(")[2].rstrip(")")
        scale = {"deg": np.pi / 180, "mPa": 1e-3, "kPa": 1e3, "MPa": 1e6}.get(unit, 1.0)
        wanted = (trace(m)[what] if what in ("friction", "strength") else getattr(m.at(time), what)) / scale
        assert (time[0], time[-1]) == (0.0, m.duration)
        assert np.allclose(value, wanted, rtol=1e-12, atol=1e-12 * np.max(np.abs(wanted)))
        marks = [float(x.get_xdata()[0]) for x in ax.lines if x.get_marker() not in ("None", "")]
        farthest = [float(m.farthest.time)] if what == "displacement" and swings_back(m) else []
        assert marks == pytest.approx([float(m.peak.time), *farthest, m.duration])
        assert any(x.startswith(plotstyle.ending(m)) for x in legend(ax))


def test_an_overview_of_a_motion() -> None:
    """Degrees beside metres; panels bear letters."""
    m = motion("vaiont")
    figure = plots.motion_overview(m).draw(canvas((9.0, 12.0)))
    titles = [ax.get_title("left") for ax in figure.axes if ax.get_title("left")]
    assert titles == [
        "a  Section", "b  Velocity", "c  Displacement", "d  Friction coefficient", "e  Mean normal stress",
        "f  Speed and energy"]  # fmt: skip
    assert figure.get_suptitle() == "Vaiont: 677 m in 38.1 s, at rest"
    ax = plots.history(m, "displacement", drawn())
    ax.figure.draw_without_rendering()
    radius = float(np.asarray(m.plan.scene.arc.radius))
    assert np.allclose(ax.child_axes[0].get_ylim(), np.degrees(np.array(ax.get_ylim()) / radius))


VAIONT = load("vaiont")
TABLE = {"law": "tabulated", "slip": [0.0, 60.0], "coefficient": [0.41, 0.17]}


SHORT_GROUND = [(-24, 20), (0, 20), (40, 0), (47, 0)]


def test_cohesion_and_layers_show_strengths_in_kilopascals() -> None:
    """Cohesion alone is mobilised with phi = 0; strengths are equal at the peak velocity, where nothing accelerates."""
    section = Section(SHORT_GROUND, (26.0, 34.0), 38.0, 19e3)
    clay = solve(Scene(section, 0.0, {**{name: {} for name in TURNING}, "cohesion": {"cohesion": 35e3}}))
    layered = solve(Scene(profile("softening"), effects=TURNING))
    for m in (clay, layered, solve(load("real-slope"))):  # the last one with a strength factor
        titles = [ax.get_title("left") for ax in plots.motion_overview(m).draw(canvas((9.0, 12.0))).axes]
        assert "d  Mobilised strength" in titles
        assert "friction" not in " ".join(titles).lower()
        at_peak = m.strength_at(m.peak.time)
        assert at_peak.mobilised == pytest.approx(at_peak.required, rel=1e-9)
    assert clay.strength_at([0.0, 1.0]).mobilised == pytest.approx([35e3, 35e3], rel=1e-12)
    start, soils = layered.strength_at(0.0), record(layered)["stretches"]
    mean = sum(r["length"] * r["strength"] for r in soils) / sum(r["length"] for r in soils)
    assert start.mobilised == pytest.approx(mean, rel=1e-12)
    assert start.mobilised / start.required == pytest.approx(layered.factor_of_safety, rel=1e-12)


def test_the_picture_of_a_section_shows_its_free_water_and_the_ground_beyond_its_last_point() -> None:
    section = Section(SHORT_GROUND, (26.0, 34.0), 38.0, 19e3, ponds=[(36.0, 47.0, 2.0)])
    ax = plots.section(solve(Scene(section, 0.1, TURNING)), drawn())
    (pond,) = (c.get_paths()[0].vertices for c in ax.collections if c.get_alpha() == plotstyle.SCENERY["pond"]["alpha"])
    assert pond[:, 0].min() == pytest.approx(36.0)
    assert pond[:, 0].max() == pytest.approx(47.0)
    assert pond[:, 1].max() == 2.0
    assert {"pond", "ground assumed level"} <= {*legend(ax)}
    arc = plots.section(motion("vaiont"), drawn()).collections[0].get_paths()[0].vertices
    end = motion("vaiont").plan.scene.arc.radius
    on_circle = np.abs(np.hypot(*arc.T) - end) < 1e-6 * end
    assert arc[on_circle, 0].max() > 1200.0  # beyond the toe, which ends at 808 m


def test_fragility_curves_of_few_records_say_that_they_have_no_intervals() -> None:
    assert interval_note(11) == "no intervals: 11 records, fewer than 12"
    assert "95 % intervals" in interval_note(12)


def test_friction_is_that_of_the_time() -> None:
    columns = trace(motion("by time"))
    assert np.allclose(columns["friction"], np.interp(columns["time"], [0.0, 2.0, 5.0], [0.45, 0.2, 0.35]), rtol=1e-14)
    assert {2.0, 5.0} <= set(columns["time"].tolist())  # where it bends
    jumps = trace(motion("newmark-pulse"))["time"].tolist()
    assert {0.5, np.nextafter(0.5, 0.0), 0.9, np.nextafter(0.9, 0.0)} <= set(jumps)
    first = int(np.flatnonzero(columns["velocity"])[0])  # it starts where friction falls to what holds it
    assert columns["friction"][first] == pytest.approx(columns["holding_friction"][first], rel=1e-3)


def test_phase_plane_stacks_the_energy() -> None:
    m, ax = motion("wet-slope"), plots.phase_plane(motion("wet-slope"), drawn())
    assert (ax.get_xlabel(), ax.get_ylabel()) == ("displacement $s$ (m)", "energy per metre of width\n(MJ/m)")
    (right,) = (a for a in ax.figure.axes if a is not ax)
    work = 1e6 * ax.lines[0].get_ydata()
    tops = [1e6 * area.get_paths()[0].vertices[:, 1].max() for area in ax.collections]
    assert tops == pytest.approx([m.energy.dissipation, np.max(work)])
    assert work[-1] == pytest.approx(m.energy.work)
    states = m.at(trace(m)["time"])
    assert np.array_equal(right.lines[0].get_data(), (states.displacement, states.velocity))
    assert "path travelled" in plots.phase_plane(motion("damped"), drawn()).get_xlabel()
    assert "work of gravity and shaking" in legend(plots.phase_plane(motion("vaiont-shaken"), drawn()))
    wide = replace(load("wet-slope"), arc=replace(load("wet-slope").arc, width=50.0))
    assert plots.phase_plane(solve(wide), drawn()).get_ylabel() == "energy of 50 m of width\n(MJ)"


@each_scene
def test_section_draws_the_mass_where_it_is(name: str) -> None:
    """Small motions larger than they are: by 1, 2 or 5 times a power of ten, up to a tenth of the chord."""
    m, ax = motion(name), plots.section(motion(name), drawn())
    arc, words = m.plan.scene.arc, " ".join(legend(ax))
    assert isinstance(arc, Arc)
    radius = float(np.asarray(arc.radius))
    outlines = {str(p.get_label()): p.get_xy()[:-1] for p in ax.patches if isinstance(p, Polygon)}
    share = abs(m.farthest.displacement) / (2 * radius * np.sin(float(arc.half_angle)))
    large = re.search(r"drawn (\d+) times as large", words)
    larger = float(large[1]) if large else 1.0
    assert bool(large) == (0.0 < share < 0.02)
    assert not large or (0.04 <= larger * share <= 0.1 and large[1].rstrip("0") in ("1", "2", "5"))
    turns = {"start": 0.0} | ({"end": larger * float(m.farthest.rotation)} if m.moves else {})
    for label, turn in turns.items():
        outline, ends = outlines[label], np.array([arc.theta_1, arc.theta_2]) + arc.facing * turn
        assert np.allclose(np.hypot(*outline.T), radius)
        assert np.allclose(outline[[0, -1]], radius * np.array([np.cos(ends), np.sin(ends)]).T)
    assert ("frozen geometry" in words) == (m.moves and "rotation" not in m.plan.effects)


def test_the_water_level_is_drawn_where_it_is() -> None:
    motion = solve(load("valley-side"))
    axes = sectionplot.section(motion)
    arc = motion.plan.scene.arc
    assert isinstance(arc, Section)
    level = np.asarray(arc.level).reshape(-1, 2)
    x = np.linspace(70.0, 250.0, 19)
    wanted = np.interp(x, *level.T)
    lines = [np.asarray(line.get_xydata()) for line in axes.lines]
    assert any(
        np.allclose(np.interp(x, *line.T), wanted) for line in lines if line[0, 0] < 70.0 and line[-1, 0] > 250.0
    )
    assert any("water level" in text.get_text() for text in axes.texts)


def test_ladder_is_drawn() -> None:
    rungs = effect_ladder(SCENES["vaiont"])
    ax = plots.ladder(rungs, drawn((9.0, 3.5)))
    assert [bar.get_width() for bar in ax.patches] == [r.run_out for r in rungs]
    assert [bool(bar.get_hatch()) for bar in ax.patches] == [not r.arrested for r in rungs]
    assert [t.get_text() for t in ax.get_yticklabels()] == ["no effect", "+ rotation", "+ centripetal"]
    assert ax.child_axes[0].get_yticklabels()[0].get_text().endswith("still moving at 38.08 s")
    assert clashes(ax.figure) == []


def test_animation_moves_the_mass() -> None:
    m, figure = motion("wet-slope"), canvas()
    played = plots.slide_animation(m, figure=figure)
    played._init_draw()  # which else complains that nothing was rendered
    moving = [p for p in figure.axes[0].patches if isinstance(p, Polygon)][-1]
    first = float(np.asarray(getattr(m.plan.scene.arc, "theta_1")))  # noqa: B009
    for frame in (0, 30, 59):
        played._func(frame)
        state = m.at(m.duration * frame / 59)
        x, y = moving.get_xy()[0]
        assert np.arctan2(y, x) % (2 * np.pi) == pytest.approx(first + float(state.rotation))
        assert f"{float(state.velocity):.2f} m/s" in figure.get_suptitle()


# --- what stands where -----------------------------------------------------------------------------------------------

# The ground ends close to the mass, and in view.
SHORT = replace(
    profile("constant friction"),
    ground=[(-24, 20), (0, 20), (40, 0), (52, 0)],
    base=-8.0,
    level=[(-90, 10), (90, -8)],
    surcharge=[(-15.0, -9.0, 10e3, 30e3), (-30.0, -23.0, 5e3, 5e3)],
)


@cache
def short() -> Any:
    ax = plots.section(solve(Scene(SHORT, effects=TURNING)), drawn((8.6, 4.3)))
    ax.figure.draw_without_rendering()
    return ax


def test_soils_have_their_names_in_the_ground_beside_the_mass() -> None:
    ax = short()
    left, right = -24.0, 52.0
    outlines = [matplotlib.path.Path(p.get_xy()) for p in ax.patches if isinstance(p, Polygon)]
    names = {soil.name: k for k, (soil, _) in enumerate(SHORT.layers)}
    shown = [text for text in ax.texts if text.get_text() in names]
    assert len(shown) >= 3
    for text in shown:
        box = Text.get_window_extent(text, ax.figure.canvas.get_renderer())
        corners = ax.transData.inverted().transform([box.min, box.max])
        (x, y), (x_2, y_2) = corners
        assert left < x < x_2 < right
        assert not any(path.contains_points([(x, y), (x, y_2), (x_2, y), (x_2, y_2)]).any() for path in outlines)
        tops = [np.interp((x + x_2) / 2, *np.transpose(SHORT.ground))]
        for _, top in SHORT.layers[1:]:
            tops.append(
                min(tops[-1], float(top) if np.ndim(top) == 0 else np.interp((x + x_2) / 2, *np.transpose(top)))
            )
        k = names[text.get_text()]
        assert [*tops, -np.inf][k + 1] < (y + y_2) / 2 < tops[k]


def test_water_firm_layer_and_surcharges_end_with_the_ground() -> None:
    lines = [np.asarray(line.get_xydata()) for line in short().lines]
    level = [line for line in lines if np.allclose(np.interp(line[:, 0], [-90, 90], [10, -8]), line[:, 1])]
    firm = [line for line in lines if np.all(line[:, 1] == -8.0)]
    for (line,) in (level, firm):
        assert line[[0, -1], 0].tolist() == [-24.0, 52.0]
    loads = [line for line in lines if np.any(np.isnan(line))]
    for line, ends, high in zip(loads, [(-15.0, -9.0), (-24.0, -23.0)], [(1 / 3, 1.0), (1 / 6, 1 / 6)], strict=True):
        tails = line[: np.flatnonzero(np.isnan(line[:, 0]))[0]]
        assert tails[[0, -1], 0] == pytest.approx(ends)
        greatest = np.nanmax(loads[0][:, 1]) - 20.0
        assert tails[[0, -1], 1] - 20.0 == pytest.approx(np.array(high) * greatest)
        assert np.nanmin(line[:, 1]) == 20.0  # the tips of the arrows
    assert {"10 to 30 kPa", "5 kPa", "firm layer", "water level"} <= {*legend(short())}


def test_no_name_stands_at_a_boundary_that_passes_the_exit() -> None:
    """Boundaries that leave the ground at the toe have no name there."""
    scene = load("layered-slope")
    ax = layerplot.stress_along(solve(replace(scene, arc=replace(scene.arc, radius=17.94792))), drawn())
    ends = [area.get_x() + area.get_width() for area in ax.patches]
    named = [text for text in legend(ax) if text in ("sand", "silt", "clay")]
    starts = [area.get_x() for area in ax.patches]
    long = [end for start, end in zip(starts, ends, strict=True) if end - start > 0.03 * ends[-1]]
    assert len(named) == len(long)


@pytest.mark.parametrize(
    ("duration", "seconds", "words"),
    [(5.02, 5.0, "in real time"), (4.98, 5.0, "in real time"), (10.3, 10.0, "in real time"), (0.0, 4.0, "in real time"),
     (11.0, 5.0, "2.2 times real speed"), (1.0, 4.0, "0.25 times real speed")],
)  # fmt: skip
def test_how_fast_a_slide_is_played(duration: float, seconds: float, words: str) -> None:
    assert plotstyle.pace(duration, seconds) == words


# --- words that could mislead --------------------------------------------------------------------------------------


def test_the_section_names_times_and_ways_and_that_the_circle_goes_on() -> None:
    """How the toe of a slope ends above its ground stands in the tables as well."""
    m = solve(from_method(load("real-slope"), "paper"))
    words = " ".join(legend(plots.section(m, drawn((9.0, 6.0)))))
    assert "the paper's F = 0.942: 10.4 m; Bishop's F = 0.985: 9.7 m" in words
    assert "peak velocity 2.955 m/s after 3.803 s and 5.393 m" in words
    assert "at rest after 6.477 s and 10.41 m" in words
    hangs = m.journey.toe_y - np.interp(m.journey.toe_x, *np.transpose(getattr(m.plan.scene.arc, "ground")))  # noqa: B009
    assert f"toe {hangs:.4g} m above the ground" in words
    assert f"{hangs:.4g} m above the ground" in printed(m)["toe at the run-out"]
    assert "toe at the run-out" not in printed(motion("vaiont"))
    assert "still moving after 30 s and 1020 m" in legend(plots.section(motion("vaiont-frozen"), drawn((9.0, 6.0))))


def test_the_map_of_a_search_is_darkest_where_most_dangerous() -> None:
    """Contours with values, the factor at the centre, and the method in the title."""
    stability = stability_of(load("real-slope"))
    assert stability is not None
    found = critical(stability.slope)
    searchplot.critical_circle(found, (figure := canvas((9.0, 6.0))).add_subplot())
    (cells,) = (c for c in figure.axes[0].collections if isinstance(c, PolyCollection) and c.get_array() is not None)
    low, high = (sum(cells.get_cmap()(x)[:3]) for x in (0.0, 1.0))
    least, most = cells.get_clim()
    assert low < 0.5 * high
    assert 1.03 * least < most
    assert least == np.nanmin(found.values)
    assert f"centre, $F$ = {least:.3f}" in legend(figure.axes[0])
    assert figure.axes[0].get_title("left") == f"Critical circle by Bishop's method: $F$ = {least:.3f}"
    (lines,) = (c for c in figure.axes[0].collections if isinstance(c, ContourSet))
    assert {f"{level:g}" for level in lines.levels} >= {f"{float(t.get_text()):g}" for t in lines.labelTexts} != set()


def test_a_flat_map_of_a_search_has_a_scale_with_different_labels() -> None:
    stability = stability_of(load("real-slope"))
    assert stability is not None
    found = critical(stability.slope)
    least = np.nanmin(found.values)
    flat = replace(found, values=least + 1e-3 * np.minimum(found.values - least, 1.0))
    searchplot.critical_circle(flat, (figure := canvas((9.0, 6.0))).add_subplot())
    figure.draw_without_rendering()
    low, high = figure.axes[1].get_xlim()
    ticks = [t for t in figure.axes[1].get_xticklabels() if low <= t.get_position()[0] <= high]
    labels = [t.get_text() for t in ticks]
    assert len(labels) == len({*labels}) > 2
    assert [float(label) for label in labels] == pytest.approx([t.get_position()[0] for t in ticks], abs=1e-4)


# --- greys and names -----------------------------------------------------------------------------------------------


def test_numbers_and_names() -> None:
    """Legends show four digits; a CSV of several scenes has the name of each, quoted if necessary."""
    values = (0.0, 27.9721, 1020.35, -0.5, 12345.6, 1.2345e7, 1.5e-7)
    assert [plotstyle.formatted_number(x) for x in values] == [
        "0", "27.97", "1020", "-0.5", "12350", "$1.234\\times10^{7}$", "$1.5\\times10^{-7}$"]  # fmt: skip
    head, *rows = csv([motion("swings"), motion("wet-slope")]).decode().splitlines()
    assert head.startswith("scene,time_s,")
    assert rows[0].startswith('"swings, a name with $ and <",0.0,')
    assert rows[-1].startswith("wet-slope,")


def test_motions_and_studies_draw_themselves(tmp_path: Path) -> None:
    """Results draw themselves on a figure of their own; motions of many lanes are refused."""
    m, study = motion("wet-slope"), grid(load("wet-slope"), {"friction.angle_deg": [20.0, 24.0]})
    ax = drawn()
    assert m.plot("velocity", ax) is ax
    found = critical(Slope([[0, 10], [20, 0]], 5e3, 0.3, 19e3))
    for result, what in ((m, "section"), (study, "overview"), (study, "duration"), (found, "overview")):
        figure = result.plot(what).figure
        assert figure.axes
        matplotlib.pyplot.close(figure)
    for result, name in ((m, "a.svg"), (found, "c.PDF")):
        assert result.plot(tmp_path / name) is None
        assert (tmp_path / name).stat().st_size > 1000
    m.animate(str(tmp_path / "a.gif"), seconds=0.5)
    with Image.open(tmp_path / "a.gif") as gif:
        durations = [frame.info["duration"] for frame in ImageSequence.Iterator(gif)]
    assert sum(durations[:-1]) == pytest.approx(500, rel=0.3)
    assert durations[-1] == 2000
    many = solve(replace(SCENES["wet-slope"], friction=np.array([0.3, 0.4])))
    refused: list[tuple[Any, str]] = [
        (lambda: m.plot("a.doc"), r"what = 'a.doc': must be .* or end in \.png, .*\.gif"),
        (lambda: study.plot("a.gif"), r"what = 'a.gif': must be .* or end in \.png, \.svg, \.pdf, \.jpg$"),
        (lambda: m.plot("speed"), "what = 'speed': must be one of overview, section"),
        (lambda: m.plot(ax=ax), "has several panels"),
        (lambda: many.plot(), r"2 lanes cannot be drawn; select a lane, such as motion\[0\]"),
    ]
    for plot, words in refused:
        with pytest.raises(ValueError, match=words):
            plot()


# --- layered ground ------------------------------------------------------------------------------------------------


def test_stresses_along_a_layered_arc_have_its_mean() -> None:
    """The plotted stress has the mean of the arc, and the bands have the names of their soils."""
    slide = solve(Scene(profile("softening"), effects=TURNING))
    assert {f"soil {k}" for k in range(4)} <= {*legend(plots.section(slide, drawn()))}
    ax = layerplot.stress_along(slide, drawn())
    along, stress = ax.lines[0].get_data()
    mean = float(slide.at(0.0).normal_stress) / 1e3
    assert np.mean(stress) == pytest.approx(mean, rel=1e-12)
    assert ax.lines[1].get_ydata()[0] == pytest.approx(mean, rel=1e-12)
    assert 0.0 < along[0] < along[-1] < ax.get_xlim()[1]


@pytest.mark.usefixtures("unseen")
def test_stretches_are_in_tables_json_and_reports() -> None:
    """Strength of each soil and of the arc over the drive is the factor of safety."""
    slide = solve(Scene(profile("softening"), effects=TURNING, name="four layers"))
    part, found = stretches_part(slide), record(slide)["stretches"]
    assert part is not None
    *rows, whole = part.rows
    assert [row[0] for row in rows] == [f"soil {k}" for k in (0, 1, 2, 3, 2)]
    assert [row[2] for row in rows] == [f"{100 * r['weight_share']:.1f}" for r in found]
    assert [cell_text(cell) for cell in whole[1:3]] == ["66.16", "100.0"]
    mean = sum(r["length"] * r["strength"] for r in found) / sum(r["length"] for r in found)
    assert mean == pytest.approx(1e3 * whole[5], rel=1e-12)
    page = report([slide], [b""], "slipcircle run")
    assert "Soils along the slip surface" in page
    assert "Stress along the arc of four layers" in page
    assert stretches_part(motion("vaiont")) is None
    assert "stretches" not in record(motion("vaiont"))
