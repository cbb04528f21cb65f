/* Exercises: goals, measures with their pass marks, and the outcome. */
#include "base/config.h"
#include "base/error.h"
#include "session/session.h"
#include "session/tuning.h"

#define MILLIMETRE 1e-3

_Static_assert(sizeof(vbss_session_exercise_state) == 32 + 2 * sizeof(void *), "published size");

static const uint32_t state_sizes[] = {sizeof(vbss_session_exercise_state), 0};
static const vbss_layout state_layout = {"vbss_session_exercise_state", NULL, state_sizes};
/* A pointer between fields of eight bytes. */
static const uint32_t measure_sizes[] = {sizeof(vbss_session_measure), 0};
static const vbss_layout measure_layout = {"vbss_session_measure", NULL, measure_sizes};

/* ---- the table of exercises */

typedef struct exercise_row {
    const char *name, *sentence;
    vbss_session_measure_kind measures[SESSION_MAX_MEASURES]; /* up to the first 0 */
    uint32_t seated; /* seated throws that reach the goal; 0: the goal is another one */
    uint32_t wraps;  /* of the last of them */
} exercise_row;

#define MEASURES_OF_THROW                                                               \
    VBSS_SESSION_MEASURE_WRAPS, VBSS_SESSION_MEASURE_GAP, VBSS_SESSION_MEASURE_TENSION, \
        VBSS_SESSION_MEASURE_TIME

static const exercise_row exercises[VBSS_SESSION_EXERCISE_COUNT] = {
    [VBSS_SESSION_EXERCISE_NONE] = {"", "", {0}, 0, 0},
    [VBSS_SESSION_EXERCISE_TAKE_NEEDLE] = {"take_needle",
                                           "Take the needle between half and two thirds of its "
                                           "length from the tip, with the jaws square "
                                           "to it, and hold it up for a second.",
                                           {VBSS_SESSION_MEASURE_GRASP_SHARE,
                                            VBSS_SESSION_MEASURE_GRASP_ANGLE,
                                            VBSS_SESSION_MEASURE_DROPS, VBSS_SESSION_MEASURE_TIME},
                                           0,
                                           0},
    [VBSS_SESSION_EXERCISE_PASS_MARK] = {"pass_mark",
                                         "Push the needle through the wall at the mark, straight "
                                         "in, until five millimetres of it are "
                                         "inside.",
                                         {VBSS_SESSION_MEASURE_DEVIATION,
                                          VBSS_SESSION_MEASURE_ENTRY_ANGLE,
                                          VBSS_SESSION_MEASURE_STRAYS, VBSS_SESSION_MEASURE_TIME},
                                         0,
                                         0},
    [VBSS_SESSION_EXERCISE_SINGLE_THROW] =
        {"single_throw",
         "Tie a throw of one wrap, and pull both ends until the slit is closed.",
         {MEASURES_OF_THROW},
         1,
         1},
    [VBSS_SESSION_EXERCISE_DOUBLE_THROW] =
        {"double_throw",
         "Tie a throw of two wraps, and pull both ends until the slit is closed.",
         {MEASURES_OF_THROW},
         1,
         2},
    [VBSS_SESSION_EXERCISE_SQUARE_THROW] = {"square_throw",
                                            "Tie a throw that is square to the one below, and pull "
                                            "both ends until the slit is closed.",
                                            {MEASURES_OF_THROW, VBSS_SESSION_MEASURE_SQUARE},
                                            2,
                                            1},
    [VBSS_SESSION_EXERCISE_CUT] = {"cut",
                                   "Cut both tails, each three to five millimetres from the knot.",
                                   {VBSS_SESSION_MEASURE_SHORT_TAIL, VBSS_SESSION_MEASURE_LONG_TAIL,
                                    VBSS_SESSION_MEASURE_TIME},
                                   0,
                                   0},
};

static const char *const names[] = {
    [VBSS_SESSION_MEASURE_TIME] = "time",
    [VBSS_SESSION_MEASURE_GRASP_SHARE] = "place on the needle from its tip",
    [VBSS_SESSION_MEASURE_GRASP_ANGLE] = "angle between jaws and needle",
    [VBSS_SESSION_MEASURE_DROPS] = "drops of the needle",
    [VBSS_SESSION_MEASURE_DEVIATION] = "distance from the mark",
    [VBSS_SESSION_MEASURE_ENTRY_ANGLE] = "angle between needle and wall's normal",
    [VBSS_SESSION_MEASURE_STRAYS] = "holes beside the stitch",
    [VBSS_SESSION_MEASURE_WRAPS] = "wraps of the throw",
    [VBSS_SESSION_MEASURE_SQUARE] = "square to the throw below",
    [VBSS_SESSION_MEASURE_GAP] = "largest gap of the slit",
    [VBSS_SESSION_MEASURE_TENSION] = "largest lasting tension of the thread",
    [VBSS_SESSION_MEASURE_SHORT_TAIL] = "short tail that is left",
    [VBSS_SESSION_MEASURE_LONG_TAIL] = "needle's tail that is left",
};

static const exercise_row *row_of(const session_object *s)
{
    return &exercises[s->config.exercise];
}

static uint32_t count_measures(const exercise_row *row)
{
    uint32_t count = 0;
    while (count < SESSION_MAX_MEASURES && row->measures[count] != 0) {
        count++;
    }
    return count;
}

/* ---- pass marks */

typedef struct pass_mark {
    double low, high;
} pass_mark;

static double time_limit(const session_object *s)
{
    bool is_short = s->config.exercise == VBSS_SESSION_EXERCISE_TAKE_NEEDLE ||
                    s->config.exercise == VBSS_SESSION_EXERCISE_CUT;
    return is_short ? SESSION_NEEDLE_TIME : SESSION_THROW_TIME;
}

static pass_mark mark_of(const session_object *s, vbss_session_measure_kind kind)
{
    switch (kind) {
    case VBSS_SESSION_MEASURE_TIME:
        return (pass_mark){0.0, time_limit(s)};
    case VBSS_SESSION_MEASURE_GRASP_SHARE:
        return (pass_mark){SESSION_GRASP_LOW, SESSION_GRASP_HIGH};
    case VBSS_SESSION_MEASURE_GRASP_ANGLE:
    case VBSS_SESSION_MEASURE_ENTRY_ANGLE:
        return (pass_mark){0.0, SESSION_SQUARE_ANGLE};
    case VBSS_SESSION_MEASURE_DEVIATION:
        return (pass_mark){0.0, SESSION_MISSED_MM * MILLIMETRE};
    case VBSS_SESSION_MEASURE_WRAPS:
        return (pass_mark){row_of(s)->wraps, row_of(s)->wraps};
    case VBSS_SESSION_MEASURE_SQUARE:
        return (pass_mark){1.0, 1.0};
    case VBSS_SESSION_MEASURE_GAP:
        return (pass_mark){0.0, SESSION_SEATED_GAP};
    case VBSS_SESSION_MEASURE_TENSION:
        return (pass_mark){0.0, SESSION_HARD_PULL};
    case VBSS_SESSION_MEASURE_SHORT_TAIL:
    case VBSS_SESSION_MEASURE_LONG_TAIL:
        return (pass_mark){SESSION_CUT_LOW, SESSION_CUT_HIGH};
    default: /* drops, stray holes */
        return (pass_mark){0.0, 0.0};
    }
}

/* ---- values */

static bool is_met(const session_object *s, uint32_t index)
{
    const pass_mark mark = mark_of(s, row_of(s)->measures[index]);
    double value = s->exercise.values[index];
    return (s->exercise.known >> index & 1u) != 0 && value >= mark.low && value <= mark.high;
}

static uint32_t find_missed(const session_object *s)
{
    uint32_t missed = 0;
    for (uint32_t i = 0; i < count_measures(row_of(s)); i++) {
        missed |= (uint32_t)!is_met(s, i) << i;
    }
    return missed;
}

/* Index of a measure of the exercise; SESSION_MAX_MEASURES: it has no such measure. */
static uint32_t find_measure(const session_object *s, vbss_session_measure_kind kind)
{
    uint32_t i = 0;
    while (i < SESSION_MAX_MEASURES && row_of(s)->measures[i] != kind) {
        i++;
    }
    return i;
}

static void set_value(session_object *s, vbss_session_measure_kind kind, bool is_known,
                      double value)
{
    uint32_t i = find_measure(s, kind);
    if (i < SESSION_MAX_MEASURES) {
        s->exercise.values[i] = is_known ? value : 0.0;
        s->exercise.known = (s->exercise.known & ~(1u << i)) | (uint32_t)is_known << i;
    }
}

static double value_of(const session_object *s, vbss_session_measure_kind kind)
{
    uint32_t i = find_measure(s, kind);
    return i < SESSION_MAX_MEASURES ? s->exercise.values[i] : 0.0;
}

/* ---- measures */

static double angle_of_goal(const session_object *s, const session_observation *observed,
                            vbss_session_goal goal, uint32_t hand)
{
    vbss_session_coaching c = {.struct_size = sizeof c};
    vbss_session_describe_goal(s, observed, (session_goal){goal, hand}, &c);
    return c.angle;
}

static void measure_event(session_object *s, const session_observation *observed,
                          const vbss_session_event *e)
{
    bool begins = e->undone == 0;
    switch (e->kind) {
    case VBSS_SESSION_EVENT_DROPPED:
        set_value(s, VBSS_SESSION_MEASURE_DROPS, true,
                  value_of(s, VBSS_SESSION_MEASURE_DROPS) + 1.0);
        break;
    case VBSS_SESSION_EVENT_STRAY:
        set_value(s, VBSS_SESSION_MEASURE_STRAYS, true,
                  value_of(s, VBSS_SESSION_MEASURE_STRAYS) + begins);
        break;
    case VBSS_SESSION_EVENT_PUNCTURE:
        if (e->number == SESSION_ENTRY) {
            uint32_t hand = vbss_session_limb_hand(s);
            set_value(s, VBSS_SESSION_MEASURE_DEVIATION, begins, e->amount * MILLIMETRE);
            set_value(s, VBSS_SESSION_MEASURE_ENTRY_ANGLE, begins,
                      angle_of_goal(s, observed, VBSS_SESSION_GOAL_PIERCE, hand));
        }
        break;
    case VBSS_SESSION_EVENT_CUT:
        set_value(s,
                  e->number == SESSION_ENTRY ? VBSS_SESSION_MEASURE_SHORT_TAIL
                                             : VBSS_SESSION_MEASURE_LONG_TAIL,
                  true, e->amount);
        break;
    default:
        break;
    }
}

static void measure_events(session_object *s, const session_observation *observed)
{
    uint64_t capacity = s->config.event_capacity;
    for (uint64_t i = s->events_before_step; i < s->event_count; i++) {
        if (s->event_count - i <= capacity) {
            measure_event(s, observed, vbss_session_event_at(s, i));
        }
    }
}

static void measure_grasp(session_object *s, const session_observation *observed)
{
    uint32_t holding = s->holding_tools.value;
    if (holding != 1 && holding != 2) {
        return;
    }
    uint32_t hand = holding == 1 ? 0 : 1;
    double arc = vbss_session_needle_arc(s, observed->tools[hand].tip);
    set_value(s, VBSS_SESSION_MEASURE_GRASP_SHARE, true, arc / vbss_session_needle_length(s));
    set_value(s, VBSS_SESSION_MEASURE_GRASP_ANGLE, true,
              angle_of_goal(s, observed, VBSS_SESSION_GOAL_TAKE_NEEDLE, hand));
}

static void measure_throw(session_object *s, const session_observation *observed)
{
    uint32_t seated = row_of(s)->seated;
    bool is_tied = seated > 0 && s->throw_count >= seated;
    const session_throw_observation none = {0};
    const session_throw_observation *t = is_tied ? &s->throws[seated - 1].value : &none;
    set_value(s, VBSS_SESSION_MEASURE_WRAPS, is_tied, t->wraps);
    set_value(s, VBSS_SESSION_MEASURE_SQUARE, is_tied,
              t->relation == VBSS_METRICS_RELATION_SQUARE ? 1.0 : 0.0);
    set_value(s, VBSS_SESSION_MEASURE_GAP, is_tied, vbss_max(observed->max_gap, 0.0));
}

/* Tension counts if it lasts. In a step that its budget stops, a segment may have one that nothing balances, and keeps it
 * while the thread waits. */
static void measure_tension(session_object *s, double tension)
{
    session_exercise *x = &s->exercise;
    double now = s->time - s->time_lost, largest = value_of(s, VBSS_SESSION_MEASURE_TENSION);
    x->interval_tension = vbss_min(x->interval_tension, tension);
    if (now - x->interval_begin >= s->config.dwell) {
        largest = vbss_max(largest, x->interval_tension);
        x->interval_begin = now;
        x->interval_tension = tension;
    }
    set_value(s, VBSS_SESSION_MEASURE_TENSION, true, largest);
}

/* ---- goals */

static double needle_height(const session_object *s, const session_observation *observed)
{
    vec3 up = vec3_unit_or(vec3_neg(observed->into_tissue), vec3_make(0.0, 0.0, 1.0));
    vec3 middle = vbss_session_needle_point(s, 0.5 * vbss_session_needle_length(s));
    return vec3_dot(middle, up);
}

static bool is_goal_observed(const session_object *s, const session_observation *observed)
{
    const session_hole_observation *in;
    switch (s->config.exercise) {
    case VBSS_SESSION_EXERCISE_TAKE_NEEDLE:
        return (s->holding_tools.value == 1 || s->holding_tools.value == 2) &&
               needle_height(s, observed) - s->exercise.rest_height >= SESSION_LIFT;
    case VBSS_SESSION_EXERCISE_PASS_MARK:
        in = vbss_session_find_hole(observed, s->holes[SESSION_ENTRY].id);
        return in != NULL && in->distance_from_tip >= SESSION_PASSED_LENGTH;
    case VBSS_SESSION_EXERCISE_CUT:
        return s->phase == VBSS_SESSION_PHASE_DONE;
    default:
        return s->seated_count >= row_of(s)->seated;
    }
}

/* Facts of the task are debounced already. */
static bool is_goal_reached(session_object *s, const session_observation *observed)
{
    session_exercise *x = &s->exercise;
    double dwell =
        s->config.exercise == VBSS_SESSION_EXERCISE_TAKE_NEEDLE ? SESSION_HELD_TIME : 0.0;
    if (!is_goal_observed(s, observed)) {
        x->reached_since = -1.0;
        return false;
    }
    x->reached_since = x->reached_since < 0.0 ? s->time : x->reached_since;
    return s->time - x->reached_since >= dwell;
}

/* ---- a step */

void vbss_session_reset_exercise(session_object *s)
{
    s->exercise = (session_exercise){.reached_since = -1.0};
}

static void end_exercise(session_object *s, bool is_passed)
{
    if (!vbss_session_is_over(s)) { /* otherwise the times of the end are known */
        s->end_time = s->time;
        s->end_time_lost = s->time_lost;
    }
    s->exercise.outcome = is_passed ? VBSS_SESSION_OUTCOME_PASSED : VBSS_SESSION_OUTCOME_FAILED;
    vbss_session_event *e = vbss_session_emit_event(
        s, VBSS_SESSION_EVENT_EXERCISE, (uint32_t)s->config.exercise, 0, VBSS_METRICS_TOOL_NONE);
    e->amount = is_passed ? 1.0 : 0.0;
}

void vbss_session_update_exercise(session_object *s, const session_observation *observed)
{
    if (s->config.exercise == VBSS_SESSION_EXERCISE_NONE ||
        s->exercise.outcome != VBSS_SESSION_OUTCOME_NONE) {
        return;
    }
    if (observed->has_lost_body) {
        end_exercise(s, false);
        return;
    }
    if (s->steps == 1) {
        s->exercise.rest_height = needle_height(s, observed);
        set_value(s, VBSS_SESSION_MEASURE_DROPS, true, 0.0);
        set_value(s, VBSS_SESSION_MEASURE_STRAYS, true, 0.0);
    }
    set_value(s, VBSS_SESSION_MEASURE_TIME, true, s->time);
    measure_events(s, observed);
    measure_grasp(s, observed);
    measure_throw(s, observed);
    measure_tension(s, observed->max_tension);
    bool is_reached = is_goal_reached(s, observed);
    if (is_reached || s->time >= time_limit(s) || vbss_session_is_over(s)) {
        end_exercise(s, is_reached && find_missed(s) == 0);
    }
}

/* ---- what hosts see */

const char *vbss_session_exercise_name(vbss_session_exercise exercise)
{
    bool is_exercise = exercise > 0 && exercise < VBSS_SESSION_EXERCISE_COUNT;
    return is_exercise ? exercises[exercise].name : "";
}

const char *vbss_session_exercise_string(vbss_session_exercise exercise)
{
    bool is_exercise = exercise > 0 && exercise < VBSS_SESSION_EXERCISE_COUNT;
    return is_exercise ? exercises[exercise].sentence : "";
}

vbss_result vbss_session_write_exercise(const session_object *s, vbss_session_exercise_state *out,
                                        uint32_t struct_size)
{
    vbss_session_exercise_state own = {.struct_size = sizeof own,
                                       .exercise = s->config.exercise,
                                       .outcome = (vbss_session_outcome)s->exercise.outcome,
                                       .measure_count = count_measures(row_of(s)),
                                       .missed = find_missed(s),
                                       .name = row_of(s)->name,
                                       .sentence = row_of(s)->sentence};
    if (own.exercise != VBSS_SESSION_EXERCISE_NONE) {
        own.aids_used = s->assistance.used;
        own.time = vbss_session_is_over(s) ? s->end_time : s->time;
    }
    return vbss_struct_write(s->context, &state_layout, &own, out, struct_size);
}

vbss_result vbss_session_write_measure(const session_object *s, uint32_t index,
                                       vbss_session_measure *out, uint32_t struct_size)
{
    const exercise_row *row = row_of(s);
    if (index >= count_measures(row)) {
        return vbss_fail(s->context, VBSS_ERROR_NOT_FOUND, "the exercise has %u measures",
                         count_measures(row));
    }
    vbss_session_measure_kind kind = row->measures[index];
    const pass_mark mark = mark_of(s, kind);
    const vbss_session_measure own = {.struct_size = sizeof own,
                                      .kind = kind,
                                      .is_known = s->exercise.known >> index & 1u,
                                      .is_met = is_met(s, index),
                                      .name = names[kind],
                                      .value = s->exercise.values[index],
                                      .low = mark.low,
                                      .high = mark.high};
    return vbss_struct_write(s->context, &measure_layout, &own, out, struct_size);
}

/* ---- state */

void vbss_session_visit_exercise(vbss_stream *stream, session_exercise *exercise)
{
    vbss_stream_u32(stream, 99, &exercise->outcome, 1);
    vbss_stream_u32(stream, 99, &exercise->known, 1);
    vbss_stream_f64(stream, 100, exercise->values, SESSION_MAX_MEASURES);
    vbss_stream_f64(stream, 101, &exercise->rest_height, 1);
    vbss_stream_f64(stream, 102, &exercise->reached_since, 1);
    vbss_stream_f64(stream, 103, &exercise->interval_begin, 1);
    vbss_stream_f64(stream, 104, &exercise->interval_tension, 1);
    bool is_wrong = exercise->outcome > VBSS_SESSION_OUTCOME_FAILED ||
                    exercise->known >> SESSION_MAX_MEASURES != 0;
    if (is_wrong && !stream->trusted) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no exercise is like this");
    }
}
