/* The scenes of the trainer, a table: what lies there, where two tools begin, and what scripted hands do there. */
#ifndef VBSS_EXAMPLES_TRAINER_STAGE_H
#define VBSS_EXAMPLES_TRAINER_STAGE_H

#include "exercise/places.h"
#include "needle/stitch.h"
#include "throw/core_speed.h"
#include "trainer/options.h"

/* What a hand shall do; the tool's shaft is upright. */
typedef struct vertex_motion {
    vec at;
    double opening;
} motion;

typedef struct stage {
    const struct stage_row *row;
    unsigned long seed;
    vbss_solver_options solver;
    vbss_context *context;
    vbss_scene *scene;
    vbss_session *session; /* of the task; NULL: the scene has none */
    vbss_session_exercise exercise;
    stitch stitch; /* of the surgeon, whose hands are not used; or */
    site site;     /* that of the task */
    vbss_grasper *tools[HANDS];
    uint32_t bodies[HANDS];
    vec start[HANDS];
    vec middle; /* of the space of work */
    vec needle; /* the middle of its arc, as it lies at first */
    double floor;
} stage;

typedef struct stage_row {
    const char *name, *what;
    vbss_result (*create)(stage *s);
    motion (*script)(const stage *s, int side, double time);
    double closings_begin, closings_every; /* s; of the right hand on a needle; 0: never */
} stage_row;

/* NULL: there is none of that name, or number. */
const stage_row *stage_find(const char *name);
const stage_row *stage_at(size_t number);
/* Of a surgeon's scene the seed says which. Options of the solver: NULL for fixed budgets. */
vbss_result stage_create(stage *s, const stage_row *row, unsigned long seed,
                         const vbss_solver_options *solver);
/* Of an exercise. States that its start does not need may be missing. */
vbss_result stage_create_exercise(stage *s, vbss_session_exercise exercise,
                                  const start_states *states, const vbss_solver_options *solver);
/* Its outcome is known. */
bool stage_has_outcome(const stage *s, vbss_session_exercise_state *state);
vbss_result stage_step(stage *s, double h);
/* How far the task is; empty without one. */
const char *stage_phase(const stage *s);
/* On stdout: the time that the limits of work have left out; and, with a session, its events and how far it came. */
void stage_report(const stage *s);
/* How often the right hand of the script has closed on the needle by then. */
uint64_t stage_closings(const stage_row *row, double time);
void stage_destroy(stage *s);

#endif
