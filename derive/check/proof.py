"""The one way in which a check fails."""


class ProofError(Exception):
    """Something did not hold: what was claimed of which quantity, the number found and the number wanted.

    Parameters
    ----------
    claim : str
        The quantity and the check, ``"polar_moment: bound of tier best"``.
    found, wanted
        The numbers, or what stands for them.
    check : str, optional
        The name of the check, where a caller tells them apart.
    """

    def __init__(self, claim: str, found: object, wanted: object = 0, check: str = "") -> None:
        super().__init__(claim, str(found), str(wanted), check)  # as they are, so that it passes between processes
        self.check = check

    def __str__(self) -> str:
        claim, found, wanted, _ = self.args
        return f"{claim}: found {found}, wanted {wanted}"
