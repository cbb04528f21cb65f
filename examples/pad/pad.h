/* A flat pad of skin with an incision, and two scripted hands that sew it. y points up; the incision lies along z. */
#ifndef VBSS_EXAMPLES_PAD_H
#define VBSS_EXAMPLES_PAD_H

#include <stdbool.h>
#include <stdio.h>

#include <vblast_ss/vblast_ss.h>

#include "base/linear.h"
#include "pad/tie.h"
#include "scripted/hand.h"
#include "scripted/pull.h"

#define PAD_STEP 1e-3 /* s */
#define PAD_THREAD_RADIUS 0.125e-3
#define PAD_FRICTION 0.15     /* coefficient, of a thread in a hole */
#define PAD_SKIN_FRICTION 0.3 /* of a thread on the skin */

enum {
    PAD_COLUMNS = 6, /* of nodes, from the incision to the clamped border */
    PAD_ROWS = 15,   /* along it */
    PAD_SHARED = 3,  /* rows beyond either end of the incision: both sides share their first node */
    PAD_NODES = 2 * PAD_COLUMNS * PAD_ROWS - 2 * PAD_SHARED,
    PAD_TRIANGLES = 4 * (PAD_COLUMNS - 1) * (PAD_ROWS - 1),
    PAD_ANCHORS = 2 * PAD_ROWS + 2 * (2 * PAD_COLUMNS - 3),
    PAD_THREADS = 2,
    PAD_BITES = 4, /* the interrupted stitch, then three of the running suture */
    PAD_MAX_HOLES = 2 * PAD_BITES
};

/* What the hands do, in this order for each bite. */
typedef enum pad_phase {
    PAD_OFFER,    /* the second hand brings the needle over the next bite */
    PAD_APPROACH, /* the first hand comes beside it */
    PAD_CLOSE,    /* and takes it */
    PAD_GIVE,     /* the second hand opens, */
    PAD_WITHDRAW, /* and goes aside */
    PAD_LOWER,    /* the first brings the tip before the skin */
    PAD_DRIVE,    /* and drives it through both lips */
    PAD_COME,     /* the second hand comes round to the other side, */
    PAD_REACH,    /* beside the tip, */
    PAD_TAKE,     /* and closes */
    PAD_LET_GO,   /* the first opens, */
    PAD_LEAVE,    /* and goes away */
    PAD_TURN,     /* the second turns the needle out, */
    PAD_DRAW,     /* draws the thread after it, */
    PAD_TIGHTEN,  /* and pulls until it is tight */
    PAD_PHASES
} pad_phase;

typedef struct pad_sheet {
    double x[PAD_NODES][3]; /* at rest, m */
    uint32_t triangles[PAD_TRIANGLES][3], anchors[PAD_ANCHORS];
    uint32_t lips[2][PAD_ROWS]; /* nodes of the lips, left (-x) and right */
} pad_sheet;

/* A needle with its thread. */
typedef struct pad_suture {
    vbss_needle *needle;
    vbss_thread *thread;
    uint32_t needle_body, thread_body;
    uint32_t segments;
    double length;   /* m */
    bool has_needle; /* it has not been cut off */
} pad_suture;

/* A bite of the running suture is pulled tight. */
typedef struct pad_tightening {
    double wanted, largest; /* of the thread; the first rises, N */
    bool have_met;          /* the lips */
    double easing;          /* s since they folded; 0: they have not */
    double shut, waited;    /* with the lips shut; beyond the script's time, s */
} pad_tightening;

typedef struct pad {
    vbss_context *context;
    vbss_scene *scene;
    vbss_record *record;
    FILE *log;     /* receives its bytes; may be NULL */
    uint64_t seed; /* of the variation; 0: none */
    vbss_drain *skin;
    uint32_t skin_body;
    pad_sheet sheet;
    pad_suture sutures[PAD_THREADS]; /* the interrupted stitch, the running suture */
    scripted_hand hands[2];          /* drives the needle; takes it over */
    pad_tie tie;                     /* of the interrupted stitch */
    bool is_tying;
    scripted_pull held[2];         /* limb and tail beside the knot, by an assistant */
    scripted_pull tail, assistant; /* of the running suture; the hand that follows it */
    uint32_t bite;
    pad_phase phase;
    double since;  /* s in the phase */
    double time;   /* s */
    double drawn;  /* share of the way that the needle is drawn from the skin */
    double pulled; /* by the second hand beyond where it drew the needle to, m */
    pad_tightening tightening;
    double tension;             /* of the thread beside the needle, N */
    uint32_t punctures, others; /* events: holes made; withdrawn, unthreaded or torn */
} pad;

/* sheet.c */
void pad_make_sheet(pad_sheet *s);

/* scene.c */
vbss_result pad_create(vbss_context *context, pad *p);
/* Adds a needle with its thread, at a pose. */
vbss_result pad_add_suture(pad *p, uint32_t which, pose needle);

/* script.c: where needle and hands shall be, by the clock. */
const char *pad_phase_name(pad_phase phase);
double pad_phase_time(uint32_t bite, pad_phase phase);
double pad_place(uint32_t bite); /* along the incision, m */
vec3 pad_needle_centre(const pad *p);
double pad_needle_turned(const pad *p); /* rad */
/* How much farther the needle would be drawn in the next step. */
double pad_draw_step(const pad *p);
/* Sets angle and displacement of a hand, and gives the centre of the circle that they refer to. */
vec3 pad_direct_hand(const pad *p, int which, scripted_hand *hand);
bool pad_hand_is_open(const pad *p, int which);

/* hands.c: a step of the hands and the scene. */
vbss_result pad_step(pad *p, bool *is_done);
pad_suture *pad_current(pad *p);
/* Shows the thread of the stitch as it is to the hands that tie. */
vbss_result pad_see_stitch(pad *p);
vbss_result pad_follow_knot(pad *p);

/* tighten.c: of the running suture. */
void pad_tighten(pad *p);
/* The thread follows the needle freely. */
bool pad_follows(const pad *p);
/* The clock of the script shall wait, as the bite is not tight yet. */
bool pad_waits(pad *p);

/* hold.c: in each step of tying. `has_locked`: a throw has just been pulled tight. */
vbss_result pad_hold_knot(pad *p, bool has_locked);

/* log.c */
vbss_result pad_begin_log(pad *p);
vbss_result pad_write_log(pad *p);
vbss_result pad_end_log(pad *p);

/* ---- measure.c */

typedef struct pad_hole {
    uint32_t suture;
    vec3 place;        /* at rest, m */
    double along;      /* arc length of the thread, m */
    double angle;      /* by which the thread turns there, rad */
    double tension[2]; /* of the thread, towards the needle and towards the tail, N */
    vec3 force;        /* on the tissue, N */
} pad_hole;

typedef struct pad_report {
    pad_hole holes[PAD_MAX_HOLES];
    uint32_t hole_count;    /* of threads: those above */
    uint32_t needle_holes;  /* with a needle in them */
    double gap[PAD_BITES];  /* between the lips at each bite, m */
    double largest_gap;     /* m */
    vec3 side_force[2];     /* of the threads on the left and the right lip, N */
    uint32_t crossings;     /* of threads or needle with the skin, away from the holes */
    double lowest, highest; /* node of the skin, m */
    double end_force[2];    /* of tail and needle end of the running suture, N */
} pad_report;

vbss_result pad_measure(pad *p, pad_report *r);
/* From a point of the left lip to the nearest one of the right lip, m. */
vec3 pad_across(const pad *p, double z);
double pad_opening(const pad *p, double z);

/* vary.c: by how much a place of the hands is off, m. `place`: which one. */
vec3 pad_vary(uint64_t seed, uint32_t place);

/* picture.c */
bool pad_save_picture(pad *p, const char *path, const char *text, bool from_above);

/* run.c: the whole performance. `folder`: of pictures and log; may be NULL. */
typedef struct pad_options {
    const char *folder;
    double frames; /* s between frames of a film; 0: none */
} pad_options;

typedef struct pad_outcome {
    pad_report begin, end;
    double widest[PAD_BITES];    /* gap at each bite before it was drawn, m */
    double tightened[PAD_BITES]; /* after it was */
    uint32_t crossings;          /* in all that was tested */
    uint64_t steps, hash;
    bool painted;
} pad_outcome;

vbss_result pad_run(pad *p, const pad_options *o, pad_outcome *out);

#endif
