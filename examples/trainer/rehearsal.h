/* Where the vendors' libraries are stand-ins (tests/stand_ins): moves the hands on them, ticks their clock, causes faults, and
 * looks at what the motors and lines really do. Of real libraries nothing of this is there. */
#ifndef VBSS_EXAMPLES_TRAINER_REHEARSAL_H
#define VBSS_EXAMPLES_TRAINER_REHEARSAL_H

#include <vblast_ss/mock.h>

#include "stand_ins/stand_ins.h"
#include "trainer/options.h"

typedef struct rehearsal {
    void *libraries[2];
    const stand_in_hd_table *hd; /* NULL: that library is real, or not in use */
    const stand_in_daq_table *daq;
    int levels[HANDS];
    uint64_t pulses[HANDS];
} rehearsal;

/* What a fault is for each kind of hardware; -1: nothing. */
typedef struct fault_row {
    const char *name;
    int arm, lines, mock;
    bool hand_feels; /* the force ends, too */
    bool frozen;     /* the motors are beyond reach: what would go out counts */
    double clock;    /* s, by which the host's clock steps; 0: it does not */
} fault_row;

void rehearsal_find(rehearsal *r, const options *o);
/* Before the hardware is opened. */
void rehearsal_begin(rehearsal *r, bool simulated);
/* Where a hand wants to be in its arm's frame, and how turned (w, x, y, z; NULL: as it is). A firm one holds on to that, as
 * somebody does who sees what the tool does; else it gives way. */
void rehearsal_move(rehearsal *r, int side, const double at[3], const double *turn, bool firm);
/* Where it is, at rest. */
void rehearsal_place(rehearsal *r, int side, const double at[3], const double *turn);
void rehearsal_press(rehearsal *r, int side, bool button);
/* The voltage of its handle. */
void rehearsal_squeeze(rehearsal *r, int side, double volts);
void rehearsal_tick(rehearsal *r);
/* Counts the pulses of the lines. */
void rehearsal_watch(rehearsal *r, uint32_t handles);
double rehearsal_force(const rehearsal *r, int side);
bool rehearsal_solenoid(const rehearsal *r, int side);
/* NULL: there is none of that name, or number. */
const fault_row *rehearsal_fault(const char *name);
const fault_row *rehearsal_fault_at(size_t number);
void rehearsal_cause(rehearsal *r, const fault_row *fault, int side, bool on);
/* Illegal calls of both so far; the first of them. */
int rehearsal_illegal(const rehearsal *r, const char **first);
void rehearsal_end(rehearsal *r);

#endif
