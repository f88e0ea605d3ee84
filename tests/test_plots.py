"""Pictures: what is drawn is the motion, with units; no text lies on another; greys and dashes tell things apart."""

import re
from dataclasses import replace
from pathlib import Path

import matplotlib.pyplot
import numpy as np
import pytest
from matplotlib.colors import to_rgb
from matplotlib.patches import Polygon
from matplotlib.text import Text
from PIL import Image, ImageSequence

from slipcircle import Arc, Scene, Section, critical, grid, load, solve
from slipcircle.workbench.common.quantities import record
from slipcircle.workbench.files.loaded import stability_of
from slipcircle.workbench.files.scenefile import find
from slipcircle.workbench.outputs import layerplot, plots, plotstyle, searchplot
from slipcircle.workbench.outputs.report import report
from slipcircle.workbench.outputs.tables import motion_column, stretches_part
from slipcircle.workbench.outputs.trace import csv
from slipcircle.workbench.outputs.trace import drawn as trace
from slipcircle.workbench.studies.ladder import ladder
from tests.support.layered import TURNING, profile
from tests.support.pictures import SCENES, canvas, clashes, drawn, legend, motion, texts

matplotlib.use("agg")


each_scene = pytest.mark.parametrize("name", SCENES)


# --- no text on another --------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["vaiont-heated", "newmark-pulse", "swings", "still", "to the left"])
def test_no_text_lies_on_another(name: str) -> None:
    figure = canvas(plots.size(motion(name)), 60)
    assert plots.overview(motion(name), figure) is figure
    assert len(list(texts(figure))) > 15
    assert clashes(figure) == []
    assert all(text.get_fontsize() >= 8.0 for text in figure.findobj(Text))


# --- what is drawn -------------------------------------------------------------------------------------------------


UNITS = {"m/s": ("velocity", 1.0), "m": ("displacement", 1.0), "deg": ("rotation", np.pi / 180),
         "Pa": ("normal_stress", 1.0), "kPa": ("normal_stress", 1e3), "MPa": ("normal_stress", 1e6)}  # fmt: skip


@each_scene
def test_history_draws_the_motion(name: str) -> None:
    m = motion(name)
    for what in plots.HISTORIES:
        ax = drawn()
        assert plots.history(m, what, ax) is ax
        assert ax.get_xlabel() == "time $t$ (s)"
        if not m.moves:
            assert "does not move" in ax.texts[0].get_text()
            continue
        time, value = ax.lines[0].get_data()
        unit = ax.get_ylabel().partition("(")[2].rstrip(")")
        if what == "friction":
            assert unit == "\N{EN DASH}"
            wanted = trace(m)["friction"]
        else:
            attribute, per = UNITS[unit]
            assert attribute == what
            wanted = getattr(m.at(time), what) / per
        assert (time[0], time[-1]) == (0.0, m.duration)
        assert np.allclose(value, wanted, rtol=1e-12, atol=1e-12 * np.max(np.abs(wanted)))
        marks = [float(x.get_xdata()[0]) for x in ax.lines if x.get_marker() not in ("None", "")]
        farthest = [float(m.reach.time)] if what == "displacement" and m.swings_back else []
        assert marks == pytest.approx([float(m.peak.time), *farthest, m.duration])
        said = legend(ax)
        assert any(x.startswith("peak velocity") for x in said)
        assert any(x.startswith(plotstyle.ending(m)) for x in said)
        assert name != "lifted" or not any("equilibrium" in x for x in said)


def test_words_stand_once_beside_each_other() -> None:
    """Of the histories the first says what the marks are; degrees beside metres; panels bear letters."""
    m = motion("vaiont")
    figure = canvas(plots.size(m))
    plots.overview(m, figure)
    stacked = [ax for ax in figure.axes if ax.get_xlim() == (0.0, m.duration)]
    assert ["peak velocity" in " ".join(legend(ax)) for ax in stacked] == [True, False, False, False]
    assert "677.3 m" in legend(stacked[1])
    assert "in balance without friction" in legend(stacked[2])
    assert "".join(ax.get_title("left") for ax in figure.axes) == "abcdef"
    assert figure.get_suptitle() == "Vaiont: 677 m in 38.1 s, at rest"
    ax = plots.history(m, "displacement", drawn())
    (side,) = ax.child_axes
    ax.figure.canvas.draw()
    assert "deg" in side.get_ylabel()
    radius = float(np.asarray(m.plan.scene.arc.radius))
    assert np.allclose(side.get_ylim(), np.degrees(np.array(ax.get_ylim()) / radius))


@pytest.mark.parametrize(
    ("law", "words", "of", "levels"),
    [
        ({"law": "linear", "peak": 0.41, "residual": 0.17, "length": 60.0}, ["residual friction"], "path", [60.0]),
        ({"law": "tabulated", "slip": [0.0, 60.0], "coefficient": [0.41, 0.17]}, ["end of the table"], "path", [60.0]),
        (
            {"law": "rate_tabulated", "speed": [5.0, 10.0], "coefficient": [0.35, 0.17]},
            ["5 m/s", "10 m/s"],
            "velocity",
            [5.0, 10.0],
        ),
    ],
)
def test_bends_of_friction_have_a_line_and_the_reason(
    law: dict[str, object], words: list[str], of: str, levels: list[float]
) -> None:
    m = solve(Scene(load("vaiont").arc, law, ["rotation", "centripetal"]))
    ax = plots.history(m, "friction", drawn())
    assert {*words} <= {*legend(ax)}
    bends = [float(line.get_xdata()[0]) for line in ax.lines if len(line.get_xdata()) == 2]
    reached = [float(m.path_at(t) if of == "path" else m.at(t).velocity) for t in bends]
    for level in levels:
        assert min(abs(value - level) for value in reached) < 1e-3 * level


def test_friction_is_that_of_the_time() -> None:
    columns = trace(motion("by time"))
    assert np.allclose(columns["friction"], np.interp(columns["time"], [0.0, 2.0, 5.0], [0.45, 0.2, 0.35]), rtol=1e-14)
    assert {2.0, 5.0} <= set(columns["time"].tolist())  # where it bends
    jumps = trace(motion("newmark-pulse"))["time"].tolist()
    assert {0.5, np.nextafter(0.5, 0.0), 0.9, np.nextafter(0.9, 0.0)} <= set(jumps)
    moving = columns["velocity"] != 0.0
    assert np.any(~moving[1:])
    first = int(np.flatnonzero(moving)[0])  # it starts where friction falls to what holds it
    assert columns["friction"][first] == pytest.approx(columns["holding_friction"][first], rel=1e-3)


def test_water_that_heat_presses_is_what_friction_has_dissipated() -> None:
    """Undrained and adiabatic, Lambda/(rho c h) of each joule on a square metre of the layer is pore pressure."""
    m = motion("vaiont-heated")
    arc, columns = m.plan.scene.arc, trace(m)
    assert isinstance(arc, Arc)
    layer = float(arc.radius) * float(arc.theta_2 - arc.theta_1)
    added = 0.025e6 / (2.7e6 * 0.1) * columns["dissipation"] / layer
    wanted = columns["normal_stress"] - added
    pressed = wanted > 1e3
    assert 0 < np.count_nonzero(~pressed) < len(pressed)
    assert np.allclose(columns["effective_stress"][pressed], wanted[pressed], rtol=1e-6)


def test_phase_plane_stacks_the_energy() -> None:
    m, ax = motion("wet-slope"), drawn()
    assert plots.phase_plane(m, ax) is ax
    assert (ax.get_xlabel(), ax.get_ylabel()) == ("displacement $s$ (m)", "energy per metre of width\n(MJ/m)")
    (right,) = (a for a in ax.figure.axes if a is not ax)
    assert right.get_ylabel() == "speed $|v|$ (m/s)"
    work = 1e6 * ax.lines[0].get_ydata()
    tops = [1e6 * area.get_paths()[0].vertices[:, 1].max() for area in ax.collections]
    assert tops == pytest.approx([m.energy.dissipation, np.max(work)])
    assert work[-1] == pytest.approx(m.energy.work)
    states = m.at(trace(m)["time"])
    assert np.array_equal(right.lines[0].get_data(), (states.displacement, states.velocity))
    assert "path travelled" in plots.phase_plane(motion("damped"), drawn()).get_xlabel()
    for name, words in (("vaiont", "work of gravity"), ("vaiont-shaken", "work of gravity and shaking")):
        assert words in legend(plots.phase_plane(motion(name), drawn()))


@each_scene
def test_section_draws_the_mass_where_it_is(name: str) -> None:
    """Small motions larger than they are: by 1, 2 or 5 times a power of ten, up to a tenth of the chord."""
    m, ax = motion(name), drawn()
    assert plots.section(m, ax, forces=True) is ax
    assert all("(m)" in label for label in (ax.get_xlabel(), ax.get_ylabel()))
    assert ax.get_aspect() == 1.0
    arc = m.plan.scene.arc
    assert isinstance(arc, Arc)
    radius, said = float(np.asarray(arc.radius)), " ".join(legend(ax))
    ax.figure.draw_without_rendering()
    outlines = {str(p.get_label()): p.get_xy()[:-1] for p in ax.patches if isinstance(p, Polygon)}
    if name == "tiny":  # marks take the place of what cannot be seen
        assert not outlines
        return
    share = abs(m.reach.displacement) / (2 * radius * np.sin(float(arc.half_angle)))
    large = re.search(r"drawn (\d+) times as large", said)
    larger = float(large[1]) if large else 1.0
    assert bool(large) == (0.0 < share < 0.02)
    assert not large or (0.04 <= larger * share <= 0.1 and large[1].rstrip("0") in ("1", "2", "5"))
    turns = {"start": 0.0} | ({"end": larger * float(m.end.rotation)} if m.moves else {})
    for words, turn in turns.items():
        (outline,) = (xy for label, xy in outlines.items() if label == words)
        assert np.allclose(np.hypot(*outline.T), radius)
        ends = np.array([arc.theta_1, arc.theta_2]) + arc.facing * turn
        assert np.allclose(outline[[0, -1]], radius * np.array([np.cos(ends), np.sin(ends)]).T)
    low, high = np.transpose([ax.get_xlim(), ax.get_ylim()])
    assert all(np.all((low < xy) & (xy < high)) for xy in outlines.values())
    assert f"depth {plotstyle.number(float(arc.depth))} m" in said
    assert f"$R$ = {plotstyle.number(radius)} m" in said
    assert ("frozen geometry" in said) == (m.moves and "rotation" not in m.plan.effects)
    assert ("tangential" in said) == (name not in ("swings", "first stop", "lifted"))


@pytest.mark.parametrize(("name", "way"), [("vaiont", 1), ("to the left", -1), ("pushed up", -1), ("still", 1)])
def test_reactions_push_inwards_and_against_the_motion(name: str, way: int) -> None:
    texts = plots.section(motion(name), drawn(), forces=True).texts
    weight, *rest = [
        (np.array(a.xyann), np.array(a.xy))
        for a in texts
        if getattr(a, "arrow_patch", None) and not hasattr(a, "anchors")
    ]
    across, along = weight[1] - weight[0]
    assert across == 0.0 > along
    for normal, tangential in zip(rest[::2], rest[1::2], strict=True):
        assert np.hypot(*normal[1]) < np.hypot(*normal[0])
        (x, y), (dx, dy) = tangential[0], tangential[1] - tangential[0]
        assert np.sign(x * dy - y * dx) == -way  # counterclockwise is positive


def test_ladder_is_drawn() -> None:
    rungs = ladder(SCENES["vaiont"])
    ax = plots.ladder(rungs, drawn((9.0, 3.5)))
    assert [bar.get_width() for bar in ax.patches] == [r.run_out for r in rungs]
    assert [bool(bar.get_hatch()) for bar in ax.patches] == [not r.arrested for r in rungs]
    assert ax.get_xlabel() == "run-out along the arc (m); dotted: with all effects, 677.3 m"
    assert [t.get_text() for t in ax.get_yticklabels()] == ["no effect", "+ rotation", "+ centripetal"]
    assert ax.child_axes[0].get_yticklabels()[0].get_text().endswith("still moving at 38.08 s")
    assert clashes(ax.figure) == []


def test_animation_moves_the_mass() -> None:
    m, figure = motion("wet-slope"), canvas()
    played = plots.animate(m, figure, 5)
    played._init_draw()  # which else complains that nothing was rendered
    moving = [p for p in figure.axes[0].patches if isinstance(p, Polygon)][-1]
    arc = m.plan.scene.arc
    assert isinstance(arc, Arc)
    for frame in (0, 2, 4):
        played._func(frame)
        state = m.at(m.duration * frame / 4)
        x, y = moving.get_xy()[0]
        assert np.arctan2(y, x) % (2 * np.pi) == pytest.approx(float(np.asarray(arc.theta_1)) + float(state.rotation))
        assert f"{float(state.velocity):.2f} m/s" in figure.get_suptitle()


# --- words that could mislead --------------------------------------------------------------------------------------


def test_the_section_says_when_and_how_far_and_that_the_circle_goes_on() -> None:
    """No velocity in metres; how the toe of a slope ends above its ground, which the tables and reports say as well."""
    m = solve(load("real-slope"))
    words = legend(plots.section(m, drawn((9.0, 6.0))))
    assert "peak velocity 2.955 m/s after 3.803 s and 5.393 m" in words
    assert any(w.startswith("at rest after 6.477 s and 10.41 m") for w in words)
    section = m.plan.scene.arc
    assert isinstance(section, Section)
    hangs = m.journey.toe_y - np.interp(m.journey.toe_x, *np.transpose(section.ground))
    assert any(f"ends {hangs:.4g} m above the ground" in w for w in words)
    assert f"{hangs:.4g} m above the ground" in motion_column(m)["toe at the end"]
    assert "toe at the end" not in motion_column(motion("vaiont"))
    assert "still moving after 30 s and 1020 m" in legend(plots.section(motion("vaiont-frozen"), drawn((9.0, 6.0))))


def test_energies_say_of_what_width_they_are() -> None:
    wide = replace(load("wet-slope"), arc=replace(load("wet-slope").arc, width=50.0))
    assert plots.phase_plane(solve(wide), drawn()).get_ylabel() == "energy of 50 m of width\n(MJ)"


@pytest.mark.parametrize("depth", [0.0, 5.0])
def test_the_map_of_a_search_is_darkest_where_most_dangerous_and_whole(depth: float) -> None:
    stability = stability_of(load("real-slope"))
    assert stability is not None
    slope = stability.slope
    found, figure = critical(slope, depth=depth), canvas((9.0, 6.0))
    searchplot.critical_circle(found, figure)
    ax = figure.axes[0]
    (cells,) = (c for c in ax.collections if c.get_array() is not None)
    low, high = (cells.get_cmap()(x)[:3] for x in (0.0, 1.0))
    assert sum(low) < 0.5 * sum(high)
    least, most = cells.get_clim()
    assert least == np.nanmin(found.values)
    (left, right), (bottom, top) = ax.get_xlim(), ax.get_ylim()
    x, y = found.centres[found.values < most].T
    assert np.all((left <= x) & (x <= right) & (bottom <= y) & (y <= top))
    assert most > 1.03 * least


# --- greys and names -----------------------------------------------------------------------------------------------


def test_roles_differ_without_colour() -> None:
    lines = plotstyle.LINES.values()
    assert len({str(style["ls"]) for style in lines}) == len(plotstyle.LINES)
    assert len({style["marker"] for style in plotstyle.MARKS.values()}) == len(plotstyle.MARKS)

    def grey(colour: str) -> float:
        return float(np.dot(to_rgb(colour), (0.299, 0.587, 0.114)))

    one, other = (plotstyle.AREAS[k] for k in ("kinetic", "dissipation"))
    assert abs(grey(one["facecolor"]) - grey(other["facecolor"])) > 0.2
    masses = [(plotstyle.AREAS[k].get("hatch"), str(plotstyle.AREAS[k].get("ls"))) for k in ("start", "peak", "end")]
    assert len(set(masses)) == 3
    forces = sorted(grey(c) for c in plotstyle.FORCES.values())
    assert min(np.diff(forces)) > 0.15


def test_numbers_and_names() -> None:
    """In a legend to four digits; in the CSV of several scenes each by its name, quoted where it has to be."""
    values = (0.0, 27.9721, 1020.35, -0.5, 12345.6, 1.2345e7, 1.5e-7)
    assert [plotstyle.number(x) for x in values] == [
        "0", "27.97", "1020", "-0.5", "12350", "$1.234\\times10^{7}$", "$1.5\\times10^{-7}$"]  # fmt: skip
    head, *rows = csv([motion("swings"), motion("wet-slope")]).decode().splitlines()
    assert head.startswith("scene,time_s,")
    assert rows[0].startswith('"swings, a name with $ and <",0.0,')
    assert rows[-1].startswith("wet-slope,")


def test_motions_and_studies_draw_themselves(tmp_path: Path) -> None:
    """Without an axis on a figure of their own; a motion of many lanes is refused, and so is what cannot be drawn."""
    m, study = motion("wet-slope"), grid(load("wet-slope"), {"friction.angle_deg": [20.0, 24.0]})
    ax = drawn()
    assert m.plot("velocity", ax) is ax
    assert "velocity" in ax.get_ylabel()
    for result, what in ((m, "overview"), (study, "overview"), (study, "reach")):
        figure = result.plot(what).figure
        assert figure.axes
        matplotlib.pyplot.close(figure)
    m.animate(str(tmp_path / "a.gif"), seconds=1.5)
    with Image.open(tmp_path / "a.gif") as gif:
        durations = [frame.info["duration"] for frame in ImageSequence.Iterator(gif)]
    assert sum(durations[:-1]) == pytest.approx(1500, rel=0.3)
    assert durations[-1] == 2000
    with pytest.raises(ValueError, match="what = 'speed': must be one of overview, section"):
        m.plot("speed")
    with pytest.raises(ValueError, match="has several panels"):
        m.plot(ax=ax)
    with pytest.raises(ValueError, match=r"2 lanes is not one picture: take one of them, motion\[0\]"):
        solve(replace(SCENES["wet-slope"], friction=np.array([0.3, 0.4]))).plot()


# --- layered ground ------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("strength", ["base", "mass"])
def test_the_arc_of_a_layered_section_has_the_colours_of_its_soils(strength: str) -> None:
    """At the start those below it; turned those in space, or those that it carries along; each band has its name."""
    section = profile("softening", strength)
    slide, ax = solve(Scene(section, effects=TURNING)), drawn()
    plots.section(slide, ax)
    x, tops = layerplot.boundaries(np.asarray(section.ground, dtype=float), section.layers)
    assert {soil.name for soil, _ in section.layers} <= {*legend(ax)}
    colours = {strong: name for name, (_, strong) in layerplot.soil_colours(section.layers).items()}
    arcs = [line for line in ax.lines if line.get_solid_capstyle() == "butt" and line.get_color() in colours]
    turns = {6.0: 0.0, 2.5: float(slide.end.rotation) if strength == "mass" else 0.0}
    assert {line.get_linewidth() for line in arcs} == {*turns}
    for line in arcs:
        place = np.mean(line.get_xydata()[19:21], axis=0) - section.centre
        turn = turns[line.get_linewidth()] * section.facing
        cos, sin = np.cos(-turn), np.sin(-turn)
        across, up = [[cos, -sin], [sin, cos]] @ place + section.centre
        above = [name for name, top in zip(range(4), tops, strict=True) if up <= np.interp(across, x, top)]
        assert colours[line.get_color()] == f"soil {max(above, default=2)}" or up > 0.0  # the exit's soil goes on


def test_stresses_along_a_layered_arc_have_its_mean() -> None:
    slide = solve(Scene(profile("softening"), effects=TURNING))
    ax = layerplot.stress_along(slide, drawn())
    along, stress = ax.lines[0].get_data()
    mean = float(slide.at(0.0).normal_stress) / 1e3
    assert np.mean(stress) == pytest.approx(mean, rel=1e-12)
    assert ax.lines[1].get_ydata()[0] == pytest.approx(mean, rel=1e-12)
    assert 0.0 < along[0] < along[-1] < ax.get_xlim()[1]


def test_stretches_are_in_tables_json_and_reports() -> None:
    """Of each soil along the arc, and of the whole: its strength over the drive is the factor of safety."""
    slide = solve(Scene(profile("softening"), effects=TURNING, name="four layers"))
    part = stretches_part(slide)
    assert part is not None
    *rows, whole = part.rows
    assert [row[0] for row in rows] == [f"soil {k}" for k in (0, 1, 2, 3, 2)]
    assert whole[1:3] == ["66.16", "100.0"]
    records = record(slide)["stretches"]
    assert [f"{100 * r['weight_share']:.1f}" for r in records] == [row[2] for row in rows]
    assert sum(r["length"] * r["strength"] for r in records) / 66.16275 == pytest.approx(
        1e3 * float(whole[5]), rel=1e-4
    )
    page = report([solve(load("layered-slope"))], [find("layered-slope").read_bytes()])
    assert "Soils along the slip surface" in page
    assert "Stress along the arc of layered-slope" in page
    assert stretches_part(motion("vaiont")) is None
    assert "stretches" not in record(motion("vaiont"))
