"""What Coilwright raises beside Python's own exceptions."""


class InputError(ValueError):
    """An input that cannot be used: a file, or a value in memory. Its text is the line that the program prints.

    >>> import coilwright as cw
    >>> try:
    ...     cw.Actuator.prototype().replace(gap_mm=-1)
    ... except cw.InputError as error:
    ...     print(error)
    ...     error.file, error.rule
    gap_mm=-1.0: must be from 0.05 to 1000
    ('gap_mm=-1.0', 'must be from 0.05 to 1000')
    """

    file: str
    """The file as it was given, or what stands for it."""
    place: str
    """JSON pointer, or line and column; empty where it is the file as a whole."""
    rule: str
    """What is asked, as the end of a sentence."""
    value: str
    """What stands there instead; empty where there is nothing to show."""

    def __init__(self, text: str, file: str = "", place: str = "", rule: str = "", value: str = "") -> None:
        super().__init__(text, file, place, rule, value)
        self.file, self.place, self.rule, self.value = file, place, rule, value

    def __str__(self) -> str:
        return str(self.args[0])


class OutputError(OSError):
    """A file or folder that cannot be written.

    >>> import coilwright as cw
    >>> issubclass(cw.OutputError, OSError)
    True
    """


class NoPerformance(RuntimeError):
    """An actuator that can be built and has no performance at its operating point, with the reason.

    >>> import coilwright as cw
    >>> try:
    ...     cw.evaluate(cw.Actuator.prototype(), current=1e5)
    ... except cw.NoPerformance as reason:
    ...     print(str(reason).split(";")[0])
    actuator: the step from rest does not settle: a joint folds, or it rings beyond 60 s
    """
