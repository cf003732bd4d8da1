"""What can go wrong."""


class InputError(ValueError):
    """The input is wrong. The parts that do not apply are empty.

    file: the document; pointer: the JSON pointer (or the argument) within it; value: what stands there; expected: what should.
    """

    def __init__(self, message: str, file: str = "", pointer: str = "", value: str = "", expected: str = "") -> None:
        super().__init__(message, file, pointer, value, expected)
        self.file = file
        self.pointer = pointer
        self.value = value
        self.expected = expected

    def __str__(self) -> str:
        return self.args[0]


class RuntimeFailure(RuntimeError):
    """Something failed at work: a full disk, a missing module, a sample that is not finite."""
