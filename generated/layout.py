# Written by `python -m derive` with SymPy 1.14.0; do not edit.
# sha256 of the text below: 98ab150cd88938de2d76ef7ab7869ab18c8b7353873579d7feee2f068fd2166b
"""Places and meanings of the numbers of a lane, the same in NumPy and in C."""

# Cells of a lane, first in every program.
TIME = 0  # t* at the start of the next step
STATUS = 1  # state of the lane
PHASES = 2  # phases ended
END_TIME = 3  # latest end, t*
FIRST_ONLY = 4  # 1 if the first standstill ends it
LIMIT = 5  # limit friction of weight alone at the start
LIMIT_REST = 6  # exact limit friction minus LIMIT where the friction is close to it, otherwise 0
PEAK_TIME = 7  # t* of the greatest speed
PEAK_ROTATION = 8  # rotation then, signed
PEAK_OMEGA = 9  # omega* then, signed
PEAK_RATE = 10  # d omega*/dt* then, signed
REACH_TIME = 11  # t* of the greatest rotation from the start
REACH_ROTATION = 12  # that rotation, signed
END_ROTATION = 13  # rotation at the end, signed
END_OMEGA = 14  # omega* then, signed
END_RATE = 15  # d omega*/dt* then, signed
CLOSE = 16  # least margin of a decision at rest, over its terms
REST_SINCE = 17  # t* of the standstill since which it rests
TURNS = 18  # phases against the direction of the preceding phase
STEPS = 19  # steps since the last rest or break
ROTATION = 20  # rotation where the phase began, signed
SLIP = 21  # slip over the radius where the phase began
DIRECTION = 22  # direction of travel, 1 or -1; 0 at rest
LIFTED = 23  # 1 if contact with the slip surface is lost, else 0
ORDER = 24  # order of its series
FACTOR = 25  # ratio of consecutive terms of a series at the end of a step
ONE_WAY = 26  # 1 if shaking may start it down-slope only
LIFT_TIME = 27  # t* of the first lift-off
PASSED = 28  # event at which the phase began
LAST_WAY = 29  # direction of the last phase
NEGLIGIBLE = 30  # last terms of the series of a step that is cut short, over the largest
X = 31  # rotation since the phase began, in the direction of travel
OMEGA = 32  # its rate, omega*

# Cells of a lane while it is integrated, in front of these.
PENDING = -16  # action required before its next step
FACED = -15  # directions checked since its standstill
SUDDEN = -14  # 1 if slip begins at a jump of forces, else 0
RATE_BEFORE = -13  # d omega*/dt* where the phase before ended
DRIVE_BEFORE = -12  # the drive of that phase
SCALE_BEFORE = -11  # the size of the terms of that drive
SERIES_ORDER = -10  # order of the series of this step
LARGEST_OMEGA = -9  # largest term of the series of omega so far, at rest of the net moment
STEP = -8  # length of this step, up to its first event
EVENT = -7  # that event
START_DIRECTION = -6  # of slip that begins at the end of a rest
QUIET_FROM = -5  # least value of the function of time, without its factor, at which it certainly stays at rest
QUIET_TO = -4  # greatest such value
SINE_X = -3  # sine of the rotation of a mass that passes a record by short series
VERSINE_X = -2  # 1 - cosine of this rotation
CLOCKED = -1  # 1 if its steps are series in time to the end, although series in the rotation exist

# Cells of a table.
PIECE = 0  # number of its piece
VALUE = 1  # value where the phase began
INC = 2  # increment of a function of time since
UPPER = 3  # end of the piece
LOWER = 4  # beginning of the piece of a function of speed
SCALE = 5  # its argument over that of the program
SCALED_BY = 6  # factor of its values
WAY = 7  # path of a function of time, to which the rounding of its increment is proportional
RISE = 8  # rate of a linear function of time
Q1 = 9  # first coefficient after the value

# Arguments of tables.
OF_SLIP = 0  # a function of slip
OF_SPEED = 1  # a function of speed
OF_TIME = 2  # a function of time
OF_ROTATION = 3  # a function of rotation

# State of a lane.
START = 0  # not begun
MOVING = 1  # moving
RESTING = 2  # at rest, and may start again
ARRESTED = 3  # at rest for good
PAUSED = 4  # at rest at its end time, beyond which something still changes
ENDED = 5  # at its end time
STOPPED = 6  # at its first standstill, as nothing brings it to rest
UPRIGHT = 7  # the chord is upright
TOO_LONG = 8  # too many steps or turns
FAILED = 9  # overflow
NEED = 10  # a table of a Python function must be extended

# Event at which its phase began.
NOTHING = 0  # its events have no root at the start
LIFT = 1  # lifted or landed
FASTER = 2  # into the next piece of a function of speed
SLOWER = 3  # into the one before

# Action required before its next step.
READY = 0  # nothing
START_MOVING = 1  # to begin with a velocity
RESOLVE = 2  # whether it sticks or slips
START_AGAIN = 3  # to slip from rest under forces that change
ENTER_PHASE = 4  # to go on in another phase
DISCONTINUITY = 5  # whether it has contact, as forces have jumped
BEGIN_PHASE = 6  # the numbers of its phase
REST = 7  # rest of a one-way mass at its standstill

# Events that end a step.
EVENT_NONE = -1  # the step has its full length
EVENT_STANDSTILL = 0  # the speed falls to zero
EVENT_LIFT_OFF = 1  # the normal force on the slip surface changes its sign: lift-off or landing
EVENT_CHORD_UPRIGHT = 2  # the chord stands upright
EVENT_START = 3  # slip begins at rest
EVENT_LIMIT = 4  # a function of time has a break, or the end time is reached
EVENT_ENDLESS = 5  # the motion continues for ever
EVENT_BREAKPOINT = 6  # the upper edge of the first table's piece; then its lower edge, and those of the next tables

# Logged events of the first lane.
NOTE_BEGINS = 1  # a phase
NOTE_STANDS = 2  # still
NOTE_LIFTS = 3  # off
NOTE_LANDS = 4  # again

CELLS = ('TIME', 'STATUS', 'PHASES', 'END_TIME', 'FIRST_ONLY', 'LIMIT', 'LIMIT_REST', 'PEAK_TIME', 'PEAK_ROTATION',
    'PEAK_OMEGA', 'PEAK_RATE', 'REACH_TIME', 'REACH_ROTATION', 'END_ROTATION', 'END_OMEGA', 'END_RATE', 'CLOSE',
    'REST_SINCE', 'TURNS', 'STEPS', 'ROTATION', 'SLIP', 'DIRECTION', 'LIFTED', 'ORDER', 'FACTOR', 'ONE_WAY',
    'LIFT_TIME', 'PASSED', 'LAST_WAY', 'NEGLIGIBLE', 'x', 'omega')
TABLE = ('PIECE', 'VALUE', 'INC', 'UPPER', 'LOWER', 'SCALE', 'SCALED_BY', 'WAY', 'RISE', 'Q1')
KINDS = ('slip', 'speed', 'time', 'rotation')
ROLES = ('x', 'omega', 'net', 'normal', 'upright', 'square', 'cell_drive', 'cell_drive_scale', 'cell_normal0',
    'cell_driving_moment', 'cell_normal_load', 'cell_normal_load_slope', 'cell_driving_moment_slope', 'cell_driving',
    'cell_resisting', 'cell_mu', 'cell_pace', 'cell_net_sine', 'cell_net_vers', 'cell_net_square', 'cell_normal_sine',
    'cell_normal_vers', 'cell_normal_square', 'cell_upright_sine', 'cell_upright_vers', 'cell_net_loss',
    'cell_net_loss_sine', 'cell_net_loss_vers', 'cell_net_loss_square', 'cell_loss_rate', 'cell_per_pole',
    'cell_net_record', 'cell_net_record_sine', 'cell_net_record_vers', 'cell_normal_record', 'cell_normal_record_sine',
    'cell_normal_record_vers')
RATIO = 0.25
RATIO_TO_ROUNDING = 0.18
MOST_STEPS = 200000
STIFF_STEP = 20
MOST_TURNS = 2000
STIFF_CHANGE = 0.001
CARRIED = 0.001
SETTLED = 1.4210854715202004e-14
BETWEEN = 2.0
LEAST_SIZE = 1e-300
STRIDE = 42
RESULTS = 20
