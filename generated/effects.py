# Written by `python -m derive` with SymPy 1.14.0; do not edit.
# sha256 of the text below: ff712086764cddc8cc0c23dd5e00b5d4a5a11576aa10fc71c4ef4322b90a3477
"""Effects and friction laws that a scene may ask for, and the functions that serve them."""

from dataclasses import dataclass

INFINITY = float("inf")


@dataclass(frozen=True, slots=True)
class Parameter:
    """A number that an effect or a law needs, with its unit and bounds."""

    name: str
    unit: str
    lower: float
    upper: float
    help: str


@dataclass(frozen=True, slots=True)
class Law:
    """A friction law: its equation, parameters, what it depends on, and a sentence of help."""

    name: str
    equation: str
    parameters: tuple[Parameter, ...]
    depends_on: tuple[str, ...]
    help: str


@dataclass(frozen=True, slots=True)
class Effect:
    """A term of the equation of motion: its equation, parameters, what it depends on, and a sentence of help."""

    name: str
    equation: str
    parameters: tuple[Parameter, ...]
    depends_on: tuple[str, ...]
    help: str


@dataclass(frozen=True, slots=True)
class Specialised:
    """A combination of effects: the prefix of its functions in `generated.motion`, their names and operations."""

    prefix: str
    functions: tuple[str, ...]
    operations: str


LAWS = {
    'constant': Law('constant', '1.14', (Parameter('coefficient', '', 0.0, INFINITY, 'friction coefficient, tan(phi)'),), (), 'friction does not change'),
}

EFFECTS = {
    'centripetal': Effect('centripetal', '2.20', (), ('speed',), 'the mass presses harder on the slip surface the faster it turns'),
}

# Functions of each combination of effects, and what one evaluation of all of them takes.
SPECIALISED = {
    (): Specialised(
        'frozen',
        ('frozen_angular_acceleration', 'frozen_angular_velocity', 'frozen_arrest_rotation', 'frozen_arrest_time', 'frozen_drive', 'frozen_mean_normal_stress', 'frozen_rotation'),
        '7 mul, 2 add, 1 sub, 2 div, 2 neg',
    ),
    ('centripetal',): Specialised(
        'frozen_centripetal',
        ('frozen_centripetal_angular_acceleration', 'frozen_centripetal_angular_velocity', 'frozen_centripetal_arrest_rotation', 'frozen_centripetal_arrest_time', 'frozen_centripetal_brake', 'frozen_centripetal_drive', 'frozen_centripetal_mean_normal_stress', 'frozen_centripetal_rotation'),
        '154 mul, 98 add, 6 sub, 19 div, 7 neg, 9 min, 7 max, 9 less, 31 select, 10 abs, 1 arctan, 3 exp, 1 log, 2 log1p, 6 sign, 8 sqrt',
    ),
}
