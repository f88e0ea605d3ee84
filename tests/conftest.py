"""What every test starts from."""

from collections.abc import Iterator

import pytest
from flint import ctx


@pytest.fixture(autouse=True)
def precision() -> Iterator[None]:
    """Ball arithmetic's working precision, one number for the whole process, is after each test what it was before."""
    before = ctx.prec
    yield
    ctx.prec = before
