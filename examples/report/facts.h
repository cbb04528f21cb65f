/* The facts of a report: those of the log (read.c), those of its steps as they are repeated (again.c, observe.c), and those that
 * follow from both (phases.c, measure.c). Unknown facts are marked as unknown. */
#ifndef VBSS_EXAMPLES_REPORT_FACTS_H
#define VBSS_EXAMPLES_REPORT_FACTS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <vblast_ss/vblast_ss.h>

#define TRY(call)                     \
    do {                              \
        vbss_result result_ = (call); \
        if (result_ != VBSS_OK) {     \
            return result_;           \
        }                             \
    } while (0)

enum { LEFT = 0, RIGHT = 1, SIDES = 2, MAX_THROWS = 8, MAX_NAME = 64 };

/* ---- of the log alone */

typedef struct closest_points {
    double time, h;      /* s, after the step; its length */
    double lost;         /* simulated time lost up to it, s */
    double at[SIDES][3]; /* where the tools were told to be, m */
    double opening[SIDES];
    bool reported[SIDES]; /* from the first time on */
} moment;

typedef struct happening {
    uint32_t kind, first, second, number; /* the four words of an event in the log */
    uint64_t step;
    double time;
} happening;

/* A tool has something in its jaws. */
typedef struct holding {
    int side;
    uint32_t thing;
    double from, to;
    uint32_t ended; /* by which event; 0: it still holds it */
} holding;

/* ---- of the same steps once more */

typedef struct again_step {
    double force[SIDES]; /* on the hands, N */
    double gap, widest;  /* of the slit, m; below 0: there is none */
    double pulls[SIDES][3];
    double cpu_time; /* thread CPU time, s */
    uint32_t contacts;
} again_step;

typedef struct reading {
    double time;
    uint64_t step;
    vbss_knot_state state;
    vbss_knot_throw throws[MAX_THROWS];
    char notation[MAX_NAME];
} reading;

typedef struct puncture {
    uint32_t id;
    int mark; /* the nearer one */
    bool withdrawn;
    uint64_t step;
    double time, withdrawn_time;
    double angle, axial, tube; /* rad, m, m: seen from the mark, on a cylinder of that radius */
    double force[3];           /* of the wall on the needle, N */
} puncture;

/* Of the session that ran beside the scene, once more. */
typedef struct followed {
    bool there, agrees; /* the scene has one; it is the one that was recorded */
    bool measured;      /* what is measured is its */
    vbss_session_status status;
    vbss_session_exercise_state exercise; /* NONE: the whole task */
    vbss_session_measure measures[8];
    uint32_t measure_count;
    vbss_session_event *events;
    size_t count, room;
} followed;

struct stage;
/* What one who looks at the scene is called with: right after a step, and before the first one (step 0). */
typedef vbss_result again_watch(void *user, struct stage *s, uint64_t step, double time);

typedef struct again {
    bool asked;
    bool performed;     /* seen while the hands did it, and not played back */
    again_watch *watch; /* looks only; may be NULL */
    void *user;         /* handed to it */
    const char *name;   /* of the scene that was made once more; NULL: none */
    vbss_result result;
    char problem[256];
    vbss_replay_report report;
    again_step *steps;
    size_t step_room;
    uint64_t count;
    double time; /* s, after the last of them */
    reading *readings;
    size_t reading_count, reading_room;
    bool hitch, hitch_candidate; /* half hitch: debounced, and in the last reading */
    double hitch_since;          /* the candidate, s */
    puncture *punctures;
    size_t puncture_count, puncture_room;
    uint32_t needle;   /* its body; 0: none */
    bool drain, knots; /* are there */
    followed session;
    vbss_scene_statistics scene;
} again;

/* ---- of both */

typedef struct phase {
    char name[MAX_NAME];
    double from, to;
    uint64_t step;
    bool tying; /* throws are tied or pulled down in it */
} phase;

typedef struct measured {
    vbss_metrics_config config;
    vbss_metrics_report report;
    vbss_metrics_motion motion[SIDES];
    vbss_metrics_bimanual bimanual;
    vbss_metrics_penalty *penalties;
    vbss_metrics_throw *throws;
    double *speed[SIDES], *force[SIDES]; /* a row each hundredth of a second */
    size_t rows[SIDES], force_rows[SIDES];
    double begin; /* s: of the first row */
} measured;

typedef struct facts {
    const char *path;
    uint8_t *bytes;
    size_t count;
    vbss_context *context;
    vbss_replay *log;
    vbss_replay_info info;
    vbss_record_log_report check;
    uint32_t tools[SIDES]; /* their bodies; 0: none */
    uint32_t others;       /* bodies beside these that were moved */
    moment *moments;
    uint64_t steps;
    happening *events;
    size_t event_count, event_room;
    uint64_t counts[32]; /* of events by kind; 0: of kinds beyond */
    holding *holdings;
    size_t holding_count, holding_room;
    again again;
    phase *phases;
    size_t phase_count, phase_room;
    const char *phase_source;
    measured measured;
    const char
        *replay_page; /* a page that plays the session, as the report links to it; NULL: none */
} facts;

/* Makes an array of `used` items have room for one more; false: no memory. */
bool facts_room(void **array, size_t *room, size_t used, size_t size);

/* read.c: a log, whole or cut off. What is wrong with it is in `check`; the status is of a log that has no begin. */
vbss_result facts_read(facts *f);
/* again.c: plays it back, if its scene can be made once more. What fails is told in `again`. */
vbss_result facts_again(facts *f);
/* observe.c: looks at a scene before its first step, after each step, after its last one; facts_again does. Who makes the
 * steps himself names the tools in `tools`, and reads the log after that. */
vbss_result facts_observe_begin(facts *f, struct stage *s);
vbss_result facts_observe(facts *f, struct stage *s, double time, double cpu_time);
vbss_result facts_observe_end(facts *f, struct stage *s);
/* What the session told and measured; the tools must be those of the page. */
vbss_result facts_observe_session(facts *f, struct stage *s);
/* The session trains one skill. (observe.c) */
bool facts_are_of_exercise(const facts *f);
/* The last reading that was certified; NULL: none was. (observe.c) */
const reading *facts_certified(const facts *f);
/* phases.c */
vbss_result facts_phases(facts *f);
/* measure.c: of the session, if that has measured; otherwise from what is known. */
vbss_result facts_measure(facts *f);
vbss_result facts_take(facts *f, vbss_metrics *metrics);
void facts_destroy(facts *f);

static inline double facts_end(const facts *f)
{
    return f->steps > 0 ? f->moments[f->steps - 1].time : 0.0;
}

#endif
