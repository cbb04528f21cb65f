/* What the task's thread tells the screen: figures of its slots, hands and faults; handed over without a wait. */
#ifndef VBSS_EXAMPLES_TRAINER_FIGURES_H
#define VBSS_EXAMPLES_TRAINER_FIGURES_H

#include <stdatomic.h>

#include <vblast_ss/device.h>

#include "trainer/options.h"

enum { BINS = 9, MAX_EVENTS = 24, EVENT_BYTES = 160 };

/* Upper ends of the bins of a histogram, us; the last has none. */
extern const int figures_bins[BINS];

typedef struct event {
    double time; /* s */
    char text[EVENT_BYTES];
} event;

typedef struct hand_figures {
    vbss_device_input in;
    double force, max_force; /* that goes out, N */
    double jaw;
    bool joined; /* the tool has come to the hand */
    uint32_t solenoid;
    uint64_t old,
        refused; /* at the end: how often the pose became stale; samples that were refused */
    uint64_t asked, given; /* pulses: wanted by the tool; let through by the output stage */
} hand_figures;

/* What a fault that was caused came to. */
typedef struct fault_finding {
    bool begun, unsafe; /* unsafe: 10 ms later something was still put out */
    bool acted;         /* something was put out before */
    double safe_after;  /* s */
} fault_finding;

typedef struct figures {
    double time, wall; /* simulated; since the begin, s */
    uint64_t slots;
    uint64_t work[BINS], late[BINS]; /* of the thread's CPU time in a slot; of its wake-up */
    double worst_work, worst_late, total_work;
    uint64_t wall_misses; /* slots that ended after their time */
    uint64_t our_misses;  /* of them or not: the thread's CPU time alone was longer than the slot */
    hand_figures hands[HANDS];
    uint64_t pulses[HANDS]; /* that the stand-in's lines had */
    fault_finding findings[MAX_FAULTS];
    char phase[16];
    uint32_t event_count, events_lost;
    uint32_t faults; /* events that are faults */
    event events[MAX_EVENTS];
} figures;

void figures_slot(figures *f, double period, double work, double late, double wall);
/* Something to tell. */
void figures_note(figures *f, bool fault, const char *format, ...);

/* Three copies and one word: the writer never waits, the reader sees the newest. */
typedef struct exchange {
    figures copies[3];
    atomic_uint middle;
    unsigned back, front;
} exchange;

void exchange_init(exchange *e);
void exchange_put(exchange *e, const figures *f);
const figures *exchange_take(exchange *e);

#endif
