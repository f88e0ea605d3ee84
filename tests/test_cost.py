"""The cost report: errors against quadrature in ball arithmetic, and verdicts that follow from the rows. No timings."""

import io
from itertools import pairwise

import mpmath
import numpy as np
import oracle
import pytest
from mpmath import mpf

from slipcircle import cost
from slipcircle.cost import Row

SEEN = (1e-8, 1e-4, 0.3, 0.80, 1.55, float(np.pi / 2))
MEASURED = "weight_moment_amplitude"


@pytest.fixture(scope="module")
def rows() -> list[Row]:
    return cost.measure([MEASURED])


# --- what is measured ----------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", [*oracle.BASE, "dynamic_coefficient"])
def test_references_are_the_definitions(name: str) -> None:
    """Reference and mpmath's closed form, 30 digits, at the ends of the domain too."""
    subject = cost.FUNCTIONS[name]()
    with mpmath.workdps(90):
        for alpha in SEEN:
            exact = mpf(oracle.kernel(name, alpha).str(50, radius=False))
            for function in (subject.reference, subject.mp):
                assert abs(function(mpmath.mp, mpf(alpha)) / exact - 1) < mpf(10) ** -30, (name, alpha)


def test_references_of_the_motion_are_the_equations_solution() -> None:
    with mpmath.workdps(60):
        for name, exact in (("angular_velocity", oracle.angular_velocity), ("rotation", oracle.rotation)):
            subject = cost.FUNCTIONS[name]()
            for a, b, t in subject.points.T.tolist():
                found = subject.reference(mpmath.mp, mpf(a), mpf(b), mpf(t))
                assert abs(found / exact(mpf(a), mpf(b), mpf(0), mpf(t)) - 1) < mpf(10) ** -30


@pytest.mark.parametrize(
    ("name", "power", "turned"),
    [
        ("polar_moment", 2, False), ("moment_of_inertia", 3, False),
        ("radial_weight_amplitude", 1, True), ("weight_moment_amplitude", 2, True),
    ],
)  # fmt: skip
def test_gauss_legendre_is_the_integral(name: str, power: int, turned: bool) -> None:
    alpha = np.array([1e-8, 1e-3, 0.5385, 1.0])
    found = cost.gauss_legendre(power, turned, 64, alpha)
    for value, half in zip(found, alpha, strict=True):
        assert oracle.ulps(float(value), oracle.kernel(name, float(half))) < 16


def test_measured_rows(rows: list[Row]) -> None:
    ways = ["printed form", "stable form", *(f"Gauss, {n} points" for n in cost.GAUSS_POINTS)]
    assert [r.way for r in rows] == [*ways, *(f"mpmath, {n} digits" for n in cost.MP_DIGITS)]
    assert {r.function for r in rows} == {MEASURED}
    assert all(0 < r.nanoseconds < np.inf and 0 <= r.error < np.inf for r in rows)
    error = {r.way: r.error for r in rows}
    assert error["stable form"] < 5e-15
    assert error["printed form"] > 0.5  # a difference of O(alpha) that is O(alpha**3), at alpha = 1e-8
    assert error["mpmath, 50 digits"] < 1e-40
    gauss = [error[f"Gauss, {n} points"] for n in cost.GAUSS_POINTS]
    assert all(more <= max(1.5 * fewer, 1e-14) for fewer, more in pairwise(gauss))


def test_the_worst_input_shows_the_error(rows: list[Row]) -> None:
    """An error can be seen again at the input that is printed with it, against ball arithmetic."""
    for row in rows:
        if row.way == "printed form" or row.way.startswith("Gauss"):
            (alpha,) = row.worst_input
            value = cost.FUNCTIONS[MEASURED]().ways[row.way](np.array([alpha]))[0]
            exact = mpf(oracle.kernel(MEASURED, alpha).str(50, radius=False))
            assert row.error == pytest.approx(float(abs(mpf(float(value)) / exact - 1)), rel=1e-3)


def test_progress_and_unknown_functions() -> None:
    said = io.StringIO()
    cost.measure(["resistance_factor"], progress=said)
    assert said.getvalue() == "measuring resistance_factor\n"
    known = r"^function 'polar' is unknown; known are polar_moment, .*rotation, .*integration in time$"
    with pytest.raises(ValueError, match=known):
        cost.measure(["resistance_factor", "polar"])


def test_not_a_number_is_infinitely_wrong() -> None:
    subject = cost.FUNCTIONS["resistance_factor"]()
    values = [mpf(1)] * (subject.points.size - 1) + [mpmath.nan]
    row = cost._row("f", "w", subject, values, [mpf(1)] * subject.points.size, 1.0)
    assert row.error == float("inf")
    assert row.worst_input == (float(np.pi / 2),)


# --- verdicts ------------------------------------------------------------------------------------------------------


def verdicts(*rows: tuple[str, float, float]) -> dict[str, str]:
    """Verdict of each way, from its error and its time."""
    return {r.way: r.verdict for r in cost._judged([Row("f", w, error, (), ns, "") for w, error, ns in rows])}


def test_the_frontier_and_who_is_beaten() -> None:
    found = verdicts(
        ("exact", 1e-30, 1000.0),
        ("good", 1e-15, 10.0),
        ("rough", 1e-3, 1.0),
        ("slow and good", 1e-15, 13.0),  # as accurate as "good", and 1.3 times slower
        ("slow and rough", 1e-2, 50.0),  # beaten by two; the faster is named
        ("slower than exact", 1e-29, 5000.0),
        ("fails", float("inf"), 2.0),
    )
    assert [way for way, verdict in found.items() if verdict == "frontier"] == ["exact", "good", "rough"]
    beaten = {way: verdict.partition("beaten")[2].strip(": ") for way, verdict in found.items() if "beaten" in verdict}
    assert beaten == {
        "slow and good": "good",
        "slow and rough": "rough",
        "slower than exact": "exact",
        "fails": "rough",
    }


def test_a_close_race_is_not_decided() -> None:
    """Under `BEATEN` times faster is noise; nobody beats itself, nor one that is more accurate."""
    assert verdicts(("one", 1e-9, 10.0), ("two", 1e-9, 11.9)) == {"one": "frontier", "two": "frontier"}
    assert "one" in verdicts(("one", 1e-9, 10.0), ("two", 1e-9, 12.1))["two"]
    assert verdicts(("one", 1e-9, 10.0), ("two", 0.99e-9, 1e6)) == {"one": "frontier", "two": "frontier"}
    assert verdicts(("alone", float("inf"), 1.0)) == {"alone": "frontier"}


def test_verdicts_of_the_measured_rows(rows: list[Row]) -> None:
    """Every way that is beaten names one that is at least as accurate and more than 1.2 times faster."""
    assert cost.BEATEN == 1.2
    for row in rows:
        beaters = [r for r in rows if r.error <= row.error and 1.2 * r.nanoseconds < row.nanoseconds]
        assert (row.verdict == "frontier") == (not beaters)
        assert row.verdict == "frontier" or any(r.way in row.verdict for r in beaters)


def test_cells_are_relative_to_the_stable_form(rows: list[Row]) -> None:
    table = list(cost.cells(rows))
    assert all(len(cells) == len(cost.COLUMNS) for cells in table)
    ratios = {cells[0]: cells[4] for cells in table}
    assert ratios["stable form"] == "1"
    nanoseconds = {r.way: r.nanoseconds for r in rows}
    assert ratios["mpmath, 50 digits"] == f"{nanoseconds['mpmath, 50 digits'] / nanoseconds['stable form']:.2g}"
    assert np.__version__ in cost.machine()


@pytest.mark.parametrize("name", [n for n in cost.SOLVERS if n != "integration in time"])
def test_solvers(name: str) -> None:
    """Ours against textbook formulas at 40 digits; SciPy's error falls with its tolerance, and is never smaller."""
    rows = {r.way: r for r in cost.measure([name])}
    ours = [r for way, r in rows.items() if way.startswith("slipcircle")]
    assert len(ours) == len(cost.ACCURACIES)
    assert all(r.error < 1e-14 for r in ours)
    for method in ("RK45", "DOP853", "LSODA"):
        errors = [rows[f"{method}, rtol {a:.0e}"].error for a in cost.ACCURACIES]
        assert max(r.error for r in ours) < errors[-1] < 1e-11
        assert errors[-1] < errors[0]


def test_integration_keeps_to_the_accuracy() -> None:
    """Where steps are needed here too: ours are as accurate as was asked for, with a hundred times to spare."""
    rows = {r.way: r for r in cost.measure(["integration in time"])}
    for accuracy in cost.ACCURACIES:
        assert rows[f"slipcircle, {accuracy:.0e}"].error < max(accuracy / 100, 1e-12)
    assert rows["slipcircle, 1e-09"].error < rows["DOP853, rtol 1e-09"].error
