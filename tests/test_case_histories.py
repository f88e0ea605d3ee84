"""The cases of the book: each has a source, the rule is applied, and where the method does not apply it says so."""

from typing import Any

import pytest

from tests.campaigns.cases import FOLDER, computed, judged, read, verdict

CASES = read((FOLDER / "cases.toml").read_text("utf-8"))["case"]
OUTSIDE = [case for case in CASES if "outside" in case]


@pytest.mark.parametrize(
    ("value", "words"),
    [(2.0, "inside"), (3.0, "inside"), (1.0, "within a factor of 2"), (6.0, "within a factor of 2"), (0.9, "outside"),
     (6.1, "outside")],
)  # fmt: skip
def test_verdicts_follow_the_rule_of_the_page(value: float, words: str) -> None:
    assert verdict(value, 2.0, 3.0) == words


@pytest.mark.parametrize("case", CASES, ids=lambda case: case["name"])
def test_verdicts_agree_with_observations(case: dict[str, Any]) -> None:
    """Bishop's method and motions are inside what is known of them; the paper's method is safe, by 13 % at most."""
    for quantity, _, _, ratio, decided in judged(case, computed(case)[0]):
        if case in OUTSIDE:
            assert decided == "outside the method"
        elif quantity.endswith("paper's method"):
            assert 86 < int(ratio.removesuffix(" %")) <= 100
        else:
            assert decided == "inside"


def test_what_the_method_does_not_apply_to() -> None:
    says = [computed(case)[1] for case in OUTSIDE]
    assert [bool(words) for words in says] == [False, True, True, True]
    assert "the circle goes down to y = 3.048, below ground.base_m = 4.572" in says[1]
    assert 'plane = {"dip_deg": 30, ' in says[2]
    assert says[3] == "still moving: nothing holds it"
    ((_, _, toe),) = computed(OUTSIDE[3])[0]
    assert toe is not None
    assert toe < 500  # of 1000 m, without any friction


@pytest.mark.parametrize(
    ("changed", "line"),
    [("", "A: source is missing: name the public text"),
     ('source = "B"\nobserved = { run_out_m = [2, 1] }', "A: observed.run_out_m = .2, 1.: must be two numbers"),
     ('source = "B"\nobserved = { run_out_km = [1, 2] }', "A: observed.run_out_km: is unknown; known are run_out_m")],
)  # fmt: skip
def test_bad_cases_get_one_line(changed: str, line: str) -> None:
    with pytest.raises(ValueError, match=line) as caught:
        read(f'[[case]]\nname = "A"\n{changed}')
    assert "\n" not in str(caught.value)
