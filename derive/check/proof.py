"""The exception of failed checks."""


class ProofError(Exception):
    """A claim does not hold: the quantity and the check (``"polar_moment: bound of tier best"``), the value found, the
    value required, and the name of the check, by which callers distinguish them.
    """

    def __init__(self, claim: str, found: object, wanted: object = 0, check: str = "") -> None:
        # All four, so that it can be pickled.
        arguments = (claim, str(found), str(wanted), check)
        super().__init__(*arguments)
        self.check = check

    def __str__(self) -> str:
        claim, found, wanted, _ = self.args
        return f"{claim}: found {found}, wanted {wanted}"
