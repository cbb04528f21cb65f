/* One trial: a rig, two hands of some nature, the throws of a knot one after the other. */
#ifndef VBSS_EXAMPLES_THROW_TRIAL_H
#define VBSS_EXAMPLES_THROW_TRIAL_H

#include "throw/throw.h"
#include "throw/cut.h"
#include "throw/transfer.h"

typedef enum trial_kind {
    TRIAL_SINGLE,
    TRIAL_DOUBLE,
    TRIAL_SQUARE,   /* 1=1 */
    TRIAL_SURGEONS, /* 2=1 */
    TRIAL_FLS,      /* 2=1=1 */
    TRIAL_KINDS
} trial_kind;
/* As the programs know it; TRIAL_KINDS: there is none. */
const char *trial_name(int kind);
int trial_kind_of(const char *name);

/* What one who watches a trial is called for. */
typedef enum trial_event {
    TRIAL_ENTERED, /* the hands do something else from now on */
    TRIAL_STEPS,   /* right before the scene's step */
    TRIAL_STEPPED, /* right after it */
    TRIAL_ENDED    /* all is there still; not after an error */
} trial_event;

typedef struct trial_moment {
    trial_event event;
    const char *state;    /* ENTERED, ENDED: what the hands do */
    const throw_run *run; /* the throw that is tied */
    senses *see;          /* and by it the rig and both hands */
} trial_moment;
typedef void trial_watch(void *user, const trial_moment *moment);

typedef struct trial_options {
    trial_kind kind;
    uint64_t seed;     /* 0: steady hands of usual speed */
    double time_limit; /* s for a throw, a change of hands, the cutting */
    int verbose;
    const char *log;       /* file; may be NULL */
    const char *folder;    /* of pictures; may be NULL */
    double every;          /* s between them */
    trial_watch *watch;    /* looks only; may be NULL */
    void *user;            /* handed to it */
    bool cut;              /* both ends, in the end */
    bool wrong;            /* wound about the wrong way */
    bool unchecked;        /* and drawn through all the same */
    bool near;             /* of the knot only */
    throw_mistake mistake; /* in the last throw */
} trial_options;

typedef struct trial_outcome {
    bool good;
    senses_knot knot, predicted; /* in the end; when W had the tail of the last throw */
    char notation
        [32]; /* with the order of the throws as it was when the last one formed, if that can no longer be read */
    bool tight;     /* so it was: its type is proved still */
    int cuts;       /* of both ends */
    bool kept;      /* and it is the same knot still */
    int refused;    /* wraps, before they were drawn through */
    double left[2]; /* of tail and limb, m */
    int handedness; /* of the last throw */
    int retries;
    /* Of the knot's contacts above the drain, m: their mean, the lowest, the highest. */
    double height, lowest, highest;
    double time, cpu;
    uint64_t clamped;
    const char *state, *why;
} trial_outcome;

vbss_result trial_run(const trial_options *o, trial_outcome *out);
/* All that is there before the first step: what the log of such a trial can be replayed in. */
vbss_result trial_set_up(const trial_options *o, throw_rig *s, hand hands[2]);

#endif
