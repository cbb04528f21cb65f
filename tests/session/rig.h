/* A session over a scene in which nothing happens, whose task is shown what a script says it sees. Events are expected one
 * after the other: none may be missing, none too many, none twice. */
#ifndef VBSS_TESTS_SESSION_RIG_H
#define VBSS_TESTS_SESSION_RIG_H

#include "harness/harness.h"
#include "fixtures/session_scenes.h"
#include "session/session.h"

typedef struct rig {
    harness_memory memory;
    vbss_context *context;
    session_scene scene;
    vbss_metrics *metrics;
    vbss_session *session;
    session_object *s;
    session_observation observation; /* what the task sees */
    uint64_t read;                   /* events that were expected so far */
} rig;

enum { RIG_LEFT = 0, RIG_RIGHT = 1, RIG_ENTRY = 7, RIG_EXIT = 8 };
#define RIG_STEP 1e-3

/* Limits a script has changed after rig_make, before rig_start. */
void rig_make(rig *r);
void rig_start(rig *r);
void rig_begin(rig *r);         /* both */
void rig_begin_coached(rig *r); /* both, with a coach */
void rig_end(rig *r);

/* Steps of so many seconds in which the task sees the same. */
void rig_run(rig *r, double seconds);
/* The next event. */
#define rig_expect(r, kind, number, undone) \
    rig_expect_at((r), (kind), (number), (undone), #kind, __FILE__, __LINE__)
const vbss_session_event *rig_expect_at(rig *r, vbss_session_event_kind kind, uint32_t number,
                                        uint32_t undone, const char *name, const char *file,
                                        int line);
#define rig_expect_phase(r, phase, undone) \
    rig_expect((r), VBSS_SESSION_EVENT_PHASE, (phase), (undone))
/* What the coach says now. */
vbss_session_coaching rig_coaching(const rig *r);
/* Its goal is that, of that hand, with a sentence. */
#define rig_expect_goal(r, goal, tool) rig_expect_goal_at((r), (goal), (tool), __FILE__, __LINE__)
void rig_expect_goal_at(const rig *r, vbss_session_goal goal, vbss_metrics_tool tool,
                        const char *file, int line);
/* There are no more. */
#define rig_expect_quiet(r) rig_expect_quiet_at((r), __FILE__, __LINE__)
void rig_expect_quiet_at(rig *r, const char *file, int line);
vbss_session_status rig_status(const rig *r);

/* ---- what is seen */

void rig_take(rig *r, uint32_t tool);
void rig_drop(rig *r, uint32_t tool);
/* A hole at a mark with the needle in it, off by so many m along the drain; the thread in it; gone. */
void rig_pierce(rig *r, uint32_t id, uint32_t mark, double axial);
void rig_thread_through(rig *r, uint32_t id, double arc);
void rig_leave(rig *r, uint32_t id);
void rig_set_throw(rig *r, uint32_t number, int32_t wraps, int32_t handedness,
                   vbss_metrics_relation relation);
/* From nothing to tied, with its events; not seated. */
void rig_tie(rig *r, uint32_t number);
void rig_expect_stage(rig *r, uint32_t number, vbss_session_stage stage);
/* A hand holds the thread so far from the tail's end; it lets go of it; turns about its tool, toward its tip (1) or
 * its handle (-1). */
void rig_hold_thread(rig *r, uint32_t tool, double from_end);
void rig_let_go(rig *r, uint32_t tool);
void rig_wind(rig *r, uint32_t tool, double turns, int32_t direction);
/* Both hands pull, and the slit gapes so much. */
void rig_pull(rig *r, double force, double gap);

/* ---- from the begin to there, with all events read */

void rig_to_approach(rig *r); /* the right tool has the needle */
void rig_to_tail(rig *r);     /* the stitch, with its tail: the first throw is next */
void rig_to_throw(rig *r, uint32_t number, uint32_t tool); /* that is tied, square and seated */
void rig_to_cut(rig *r);                                   /* all three are */

#endif
