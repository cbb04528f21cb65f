/* The exercises of the library by name, the places of the task at which they start, and their measures in words. */
#ifndef VBSS_EXAMPLES_EXERCISE_PLACES_H
#define VBSS_EXAMPLES_EXERCISE_PLACES_H

#include <vblast_ss/session_exercise.h>

/* Places of the task, as the scripted surgeon reaches them. */
typedef enum start_place {
    START_NEW,      /* the needle lies on the floor: no state is needed */
    START_HELD,     /* the needle is held above the right mark */
    START_STITCHED, /* the stitch is made, and its tail has its length */
    START_SECOND,   /* the first throw is seated, and the needle has changed hands */
    START_TIED,     /* three throws are seated */
    START_PLACES
} start_place;

/* Saved state of the scene and of its session at a place. */
typedef struct start_state {
    uint8_t *scene, *session; /* NULL: there is none */
    uint64_t scene_bytes, session_bytes;
} start_state;

typedef struct start_states {
    start_state at[START_PLACES];
    uint8_t *memory; /* that the states are in; NULL: none */
} start_states;

/* The exercise of that name; NONE: there is none. */
vbss_session_exercise practice_named(const char *name);
start_place practice_place(vbss_session_exercise exercise);

enum { PRACTICE_NOTE = 64, PRACTICE_LINE = 160 };
/* Note of its log: "vbss exercise NAME seed 0". */
void practice_note(vbss_session_exercise exercise, char note[PRACTICE_NOTE]);
/* A measure in words, with its unit and its pass mark: "distance from the mark 0.41 mm, at most 1.00 mm". */
void practice_words(const vbss_session_measure *m, char words[PRACTICE_LINE]);

#endif
