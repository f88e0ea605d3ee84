"""Pictures: what is drawn is the motion, with units; no text lies on another; greys and dashes tell things apart."""

import itertools
import subprocess
import sys
from collections.abc import Iterator
from functools import cache
from typing import Any

import matplotlib
import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure
from matplotlib.patches import Polygon
from matplotlib.text import Text

from slipcircle import Arc, Motion, Scene, load, solve
from slipcircle.base.series import Pulse, Series
from slipcircle.outputs import plots, plotstyle
from slipcircle.outputs.report import report
from slipcircle.outputs.trace import csv
from slipcircle.outputs.trace import drawn as trace
from slipcircle.studies.ladder import ladder

matplotlib.use("agg")


def scene(first: float, second: float, friction: Any, effects: Any, radius: float = 50.0, **more: Any) -> Scene:
    return Scene(Arc(radius, float(np.deg2rad(first)), float(np.deg2rad(second)), 19e3), friction, effects, **more)


BOTH = ["rotation", "centripetal"]
SHIPPED = ("vaiont", "vaiont-frozen", "vaiont-softening", "vaiont-rate", "vaiont-heated", "vaiont-shaken",
           "newmark-pulse", "wet-slope")  # fmt: skip
RISING = Series(np.array([0.0, 1.0, 4.0]), np.array([0.0, 0.0, 1.5e5]))
CALMING = {"law": "prescribed", "time": [0.0, 2.0, 5.0], "coefficient": [0.45, 0.2, 0.35]}
SCENES = {name: load(name) for name in SHIPPED} | {
    "rising water": scene(215, 280, 0.45, {"rotation": {}, "pore_pressure": {"pressure": RISING}}, end_time=12.0),
    "by time": scene(215, 280, CALMING, ["rotation"], end_time=8.0),
    "shaken still": scene(215, 260, 0.9, {"shaking": {"horizontal": Pulse("triangular", 0.1, 0.0, 1.0)}}),
    "swings": scene(215, 280, 0.0, BOTH, end_time=60.0, name="swings, a name with $ and <"),
    "first stop": scene(215, 280, 0.0, ["rotation"]),
    "damped": scene(215, 280, 0.02, BOTH),
    "still": scene(215, 280, 0.9, ["rotation"], name="still"),
    "tiny": scene(245, 245.2, 0.36, BOTH, radius=100.0),
    "thin": scene(240, 246, 0.36, ["centripetal"], radius=1000.0, end_time=10.0),
    "half disc": scene(160, 340, 0.1, BOTH, radius=20.0),
    "to the left": scene(260, 325, 0.15, BOTH),
    "lifted": scene(215, 280, 0.2, {"rotation": {}, "pore_pressure": {"pressure": 2e5}}, end_time=6.0),
    "pushed": scene(240, 300, 0.3, ["rotation"], initial_velocity=5.0),
    "pushed up": scene(215, 280, 0.3, BOTH, initial_velocity=-8.0),
}
each_scene = pytest.mark.parametrize("name", SCENES)


@cache
def motion(name: str) -> Motion:
    return solve(SCENES[name])


def drawn(size: tuple[float, float] = (7.0, 5.0)) -> Any:
    """An empty axis that can be rendered."""
    figure = Figure(figsize=size, layout="constrained")
    FigureCanvasAgg(figure)
    return figure.add_subplot()


# --- no text on another --------------------------------------------------------------------------------------------


def texts(figure: Any) -> Iterator[tuple[str, Any]]:
    """Every text that is seen, and its box in pixels."""
    figure.draw_without_rendering()
    renderer = figure.canvas.get_renderer()
    hidden = set()
    for ax in figure.findobj(lambda a: hasattr(a, "get_xaxis")):
        for axis, (low, high) in ((ax.xaxis, ax.get_xlim()), (ax.yaxis, ax.get_ylim())):
            slack = 1e-9 * abs(high - low)
            for tick in (*axis.get_major_ticks(), *axis.get_minor_ticks()):
                if not min(low, high) - slack <= tick.get_loc() <= max(low, high) + slack:
                    hidden |= {tick.label1, tick.label2}
    for text in figure.findobj(Text):
        if text.get_text().strip() and text.get_visible() and text not in hidden:
            yield text.get_text(), text.get_window_extent(renderer)


def clashes(figure: Any) -> list[str]:
    """Pairs of texts that overlap, and texts that leave the figure."""
    found = list(texts(figure))
    width, height = figure.canvas.get_width_height()
    bad = [
        f"{a!r} on {b!r}"
        for (a, p), (b, q) in itertools.combinations(found, 2)
        if min(p.x1, q.x1) - max(p.x0, q.x0) > 1 and min(p.y1, q.y1) - max(p.y0, q.y0) > 1
    ]
    return bad + [f"{a!r} leaves" for a, p in found if p.x0 < 0 or p.y0 < 0 or p.x1 > width or p.y1 > height]


@pytest.mark.parametrize("name", list(SCENES)[::2])
def test_no_text_lies_on_another(name: str) -> None:
    figure = Figure(figsize=plots.size(motion(name)), dpi=60, layout="constrained")
    FigureCanvasAgg(figure)
    assert plots.overview(motion(name), figure) is figure
    assert len(list(texts(figure))) > 15
    assert clashes(figure) == []
    for ax in figure.axes:
        if ax.get_legend():
            assert ax.get_legend().get_window_extent().y0 >= ax.get_window_extent().y1


def test_the_check_of_texts_sees() -> None:
    ax = plots.history(motion("vaiont"), ax=drawn())
    assert clashes(ax.figure) == []
    ax.text(0.0, 1.02, "over the legend", transform=ax.transAxes)
    ax.figure.text(0.95, 0.5, "out of the figure")
    found = clashes(ax.figure)
    assert "'out of the figure' leaves" in found
    assert any("'over the legend'" in c for c in found if " on " in c)


# --- what is drawn -------------------------------------------------------------------------------------------------


@each_scene
@pytest.mark.parametrize("what", plots.HISTORIES)
def test_history_draws_the_motion(name: str, what: str) -> None:
    m, ax = motion(name), drawn()
    assert plots.history(m, what, ax) is ax
    assert ax.get_xlabel() == "time $t$ (s)"
    unit = ax.get_ylabel().partition("(")[2].rstrip(")")
    if not m.moves:
        assert "does not move" in ax.texts[0].get_text()
        return
    time, value = ax.lines[0].get_data()
    if what == "friction":
        assert unit == "\N{EN DASH}"
        wanted = trace(m)["friction"]
    else:
        attribute, per = {
            "m/s": ("velocity", 1.0), "m": ("displacement", 1.0), "deg": ("rotation", np.pi / 180),
            "Pa": ("normal_stress", 1.0), "kPa": ("normal_stress", 1e3), "MPa": ("normal_stress", 1e6),
        }[unit]  # fmt: skip
        assert attribute == what
        wanted = getattr(m.at(time), what) / per
    assert (time[0], time[-1]) == (0.0, m.duration)
    assert np.allclose(value, wanted, rtol=1e-12, atol=1e-12 * np.max(np.abs(wanted)))
    marks = [line for line in ax.lines if line.get_marker() not in ("None", "")]
    farthest = [float(m.reach.time)] if what == "displacement" and m.swings_back else []
    assert [float(x.get_xdata()[0]) for x in marks] == pytest.approx([float(m.peak.time), *farthest, m.duration])
    said = [x.get_text() for x in ax.get_legend().get_texts()]
    assert any(x.startswith("peak velocity: ") for x in said)
    assert any(x.startswith(plotstyle.ending(m)) for x in said)


def test_rotation_stands_beside_displacement() -> None:
    m, ax = motion("vaiont"), drawn()
    (side,) = plots.history(m, "displacement", ax).child_axes
    ax.figure.canvas.draw()
    assert "deg" in side.get_ylabel()
    radius = float(np.asarray(m.plan.scene.arc.radius))
    assert np.allclose(side.get_ylim(), np.degrees(np.array(ax.get_ylim()) / radius))


def test_path_of_a_swing_counts_every_way() -> None:
    """Without friction it swings by twice its dip, 22.5 deg; every swing is as long as the first."""
    path, displacement = trace(motion("swings"))["path"], trace(motion("swings"))["displacement"]
    swing = 50.0 * np.deg2rad(45.0)
    turns = np.flatnonzero(np.diff(np.sign(np.diff(displacement)))) + 1
    assert len(turns) == 8
    assert np.allclose(path[turns], swing * np.arange(1, 9), rtol=1e-9)


def test_friction_is_that_of_the_time() -> None:
    columns = trace(motion("by time"))
    assert np.allclose(columns["friction"], np.interp(columns["time"], [0.0, 2.0, 5.0], [0.45, 0.2, 0.35]), rtol=1e-14)
    assert {2.0, 5.0} <= set(columns["time"].tolist())  # where it bends
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


@pytest.mark.parametrize(
    ("name", "words"), [("vaiont", "work of gravity"), ("vaiont-shaken", "work of gravity and shaking")]
)
def test_work_is_said_to_be_of_what_does_it(name: str, words: str) -> None:
    said = [t.get_text() for t in plots.phase_plane(motion(name), drawn()).get_legend().get_texts()]
    assert words in said
    assert words in report([motion(name)])


def test_every_sample_and_jump_of_the_shaking_is_there() -> None:
    time = trace(motion("newmark-pulse"))["time"].tolist()
    assert {0.5, np.nextafter(0.5, 0.0), 0.9, np.nextafter(0.9, 0.0)} <= set(time)


def test_nothing_rubs_where_water_carries_the_mass() -> None:
    columns = trace(motion("lifted"))
    assert np.all(columns["friction"] == 0.0)
    assert np.all(columns["effective_stress"] == 0.0)
    ax = plots.history(motion("lifted"), "friction", drawn())
    assert not any("stand still" in t.get_text() for t in ax.get_legend().get_texts())


def test_phase_plane_stacks_the_energy() -> None:
    m, ax = motion("wet-slope"), drawn()
    assert plots.phase_plane(m, ax) is ax
    assert (ax.get_xlabel(), ax.get_ylabel()) == ("displacement $s$ (m)", "energy (MJ)")
    (right,) = (a for a in ax.figure.axes if a is not ax)
    assert right.get_ylabel() == "speed $|v|$ (m/s)"
    lost, kinetic = ax.collections
    top = {round(x, 9): y for x, y in kinetic.get_paths()[0].vertices}
    work = 1e6 * ax.lines[0].get_ydata()
    assert 1e6 * max(y for _, y in lost.get_paths()[0].vertices) == pytest.approx(m.energy.dissipation)
    assert 1e6 * max(top.values()) == pytest.approx(np.max(work))
    assert work[-1] == pytest.approx(m.energy.work)
    s, v = right.lines[0].get_data()
    assert np.array_equal(s, m.at(trace(m)["time"]).displacement)
    assert np.array_equal(v, m.at(trace(m)["time"]).velocity)
    assert "path travelled" in plots.phase_plane(motion("damped"), drawn()).get_xlabel()


def larger_than_life(m: Motion) -> float:
    """The greatest 1, 2 or 5 times a power of ten that makes less than a fiftieth of the chord a tenth at most."""
    arc = m.plan.scene.arc
    assert isinstance(arc, Arc)
    share = abs(m.reach.displacement) / (2 * float(np.asarray(arc.radius)) * np.sin(float(arc.half_angle)))
    return 1.0 if not 0.0 < share < 0.02 else max(x for x in STEPS if x * share <= 0.1)


STEPS = [n * 10.0**k for k in range(12) for n in (1.0, 2.0, 5.0)]


def test_words_stand_once_beside_each_other() -> None:
    """Of the histories the first says what the marks are, the lowest what runs to the right."""
    figure = Figure(figsize=plots.size(motion("vaiont")), layout="constrained")
    FigureCanvasAgg(figure)
    plots.overview(motion("vaiont"), figure)
    stacked = [ax for ax in figure.axes if ax.get_xlim() == (0.0, motion("vaiont").duration)]
    assert [ax.get_xlabel() for ax in stacked] == ["", "", "", "time $t$ (s)"]
    said = [" ".join(t.get_text() for t in ax.get_legend().get_texts()) for ax in stacked]  # type: ignore[union-attr]
    assert ["peak velocity" in s for s in said] == [True, False, False, False]
    assert "677.3 m" in said[1]


@each_scene
def test_section_draws_the_mass_where_it_is(name: str) -> None:
    m, ax = motion(name), drawn()
    assert plots.section(m, ax) is ax
    assert all("(m)" in label for label in (ax.get_xlabel(), ax.get_ylabel()))
    assert ax.get_aspect() == 1.0
    arc = m.plan.scene.arc
    assert isinstance(arc, Arc)
    radius = float(np.asarray(arc.radius))
    outlines = {str(p.get_label()): p.get_xy()[:-1] for p in ax.patches if isinstance(p, Polygon)}
    if name == "tiny":  # marks take the place of what cannot be seen
        assert not outlines
        return
    larger = larger_than_life(m)
    turns = {"start": 0.0} | ({plotstyle.ending(m): larger * float(m.end.rotation)} if m.moves else {})
    for words, turn in turns.items():
        (outline,) = (xy for label, xy in outlines.items() if label.startswith(words))
        assert np.allclose(np.hypot(*outline.T), radius)
        ends = np.array([arc.theta_1, arc.theta_2]) + arc.facing * turn
        assert np.allclose(outline[[0, -1]], radius * np.array([np.cos(ends), np.sin(ends)]).T)
    (x0, x1), (y0, y1) = ax.get_xlim(), ax.get_ylim()
    for outline in outlines.values():
        assert x0 < outline[:, 0].min() < outline[:, 0].max() < x1
        assert y0 < outline[:, 1].min() < outline[:, 1].max() < y1
    said = " ".join(t.get_text() for t in ax.get_legend().get_texts())
    assert f"depth {plotstyle.number(float(arc.depth))} m" in said
    assert f"$R$ = {plotstyle.number(radius)} m" in said
    assert ("frozen geometry" in said) == (m.moves and "rotation" not in m.plan.effects)
    assert ("times as large" in said) == (larger > 1.0)
    assert f"drawn {plotstyle.number(larger)} times as large" in said or larger == 1.0
    assert ("tangential" in said) == (name not in ("swings", "first stop", "lifted"))


def arrows(ax: Any) -> Iterator[tuple[Any, Any]]:
    """Tail and tip of each."""
    yield from ((np.array(a.xyann), np.array(a.xy)) for a in ax.texts if getattr(a, "arrow_patch", None))


@pytest.mark.parametrize(("name", "way"), [("vaiont", 1), ("to the left", -1), ("pushed up", -1), ("still", 1)])
def test_reactions_push_inwards_and_against_the_motion(name: str, way: int) -> None:
    weight, *rest = arrows(plots.section(motion(name), drawn()))
    assert (weight[1] - weight[0])[0] == 0.0
    assert (weight[1] - weight[0])[1] < 0.0
    for normal, tangential in zip(rest[::2], rest[1::2], strict=True):
        assert np.hypot(*normal[1]) < np.hypot(*normal[0])
        (x, y), (dx, dy) = tangential[0], tangential[1] - tangential[0]
        assert np.sign(x * dy - y * dx) == -way  # counterclockwise is positive


def test_ladder_is_drawn() -> None:
    rungs = ladder(SCENES["vaiont"])
    ax = plots.ladder(rungs, drawn((9.0, 3.5)))
    assert [bar.get_width() for bar in ax.patches] == [r.run_out for r in rungs]
    assert [bool(bar.get_hatch()) for bar in ax.patches] == [not r.arrested for r in rungs]
    assert ax.get_xlabel() == "run-out along the arc (m)"
    assert [t.get_text() for t in ax.get_yticklabels()] == ["no effect", "+ rotation", "+ centripetal"]
    assert clashes(ax.figure) == []


def test_animation_moves_the_mass() -> None:
    m, figure = motion("wet-slope"), Figure(layout="constrained")
    FigureCanvasAgg(figure)
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


def test_an_axis_is_made_where_none_is_given() -> None:
    from matplotlib import pyplot

    ax = plots.history(motion("vaiont"))
    assert ax.figure.number in pyplot.get_fignums()
    pyplot.close("all")


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


@pytest.mark.parametrize(
    ("value", "shown"),
    [(0.0, "0"), (27.9721, "27.97"), (1020.35, "1020"), (-0.5, "-0.5"), (123456.0, "123500"),
     (12345.6, "12350"), (1.2345e7, "$1.234\\times10^{7}$"), (1.5e-7, "$1.5\\times10^{-7}$")],
)  # fmt: skip
def test_number(value: float, shown: str) -> None:
    assert plotstyle.number(value) == shown


# --- CSV -----------------------------------------------------------------------------------------------------------


def test_csv_of_several_names_them() -> None:
    head, *rows = csv([motion("still"), motion("wet-slope")]).decode().splitlines()
    assert head.startswith("scene,time_s,")
    assert [row.split(",")[0] for row in (rows[0], rows[1], rows[-1])] == ["still", "wet-slope", "wet-slope"]
    assert (
        csv([motion("swings"), motion("still")])
        .decode()
        .splitlines()[1]
        .startswith('"swings, a name with $ and <",0.0,')
    )


# --- nothing before it is needed -----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "code",
    ["import slipcircle", "from slipcircle.outputs import plots, pictures, report",
     "from slipcircle.__main__ import main; main(['run', 'vaiont', '--json', '--csv', '/dev/null'])"],
)  # fmt: skip
def test_matplotlib_is_loaded_only_when_used(code: str) -> None:
    code += "\nimport sys; print('matplotlib' in sys.modules, file=sys.stderr)"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stderr.split() == ["False"]
