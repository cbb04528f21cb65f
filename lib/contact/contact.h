/* Contact: rows that keep features of any bodies apart, rub them against each other, or tie them.
 *
 * A row knows no body: its two sides are a short list of terms, each a block of the system and a map
 * from that block's increment to the motion of the contact point: a weight (a node), or a weight and an
 * arm (the rotation of a rigid body: u = w dtheta x arm). u, of side a relative to side b, is the sum.
 *
 *   begin -> add rows -> recall -> register, pattern -> find_places -> (solve) until good -> keep
 *
 * rows.c lists rows and remembers them from step to step; law.c is the law of contact and friction;
 * states.c finds their states together with the increments of all blocks, and work.c says how far to follow; weld.c
 * eliminates a node that is a point of a rigid body; state.c saves what is remembered. docs/contact.md derives all of it. */
#ifndef VBSS_CONTACT_CONTACT_H
#define VBSS_CONTACT_CONTACT_H

#include <vblast_ss/base.h>

#include "base/linear.h"
#include "solver/solver.h"

typedef struct vbss_stream vbss_stream;

/* ---- rows */

/* Two features of three terms each; or what is in a hole, which may slide on over the swage: five nodes and a needle that has
 * two, and three of the wall. */
enum { CONTACT_TERMS = 10 };

typedef struct contact_term {
    uint32_t block;
    bool turns; /* the block is a rotation increment */
    double weight;
    double slope; /* of a sleeve: of the weight, as what is in it slides along the normal, 1/m */
    vec3 arm;     /* turns: from the centre of mass to the contact point */
    vec3 swing;   /* turns: of the weighted arm what slope is of the weight */
} contact_term;

/* Which features: what the order of the rows, and memory, go by. */
typedef struct contact_key {
    uint32_t kind, body_a, a, body_b, b;
} contact_key;
int vbss_contact_compare(const contact_key *x, const contact_key *y);

typedef enum contact_state { CONTACT_OPEN, CONTACT_STICK, CONTACT_SLIP } contact_state;

typedef struct contact_found {
    contact_state state;
    double pressure; /* normal force on a, N */
    vec3 rubbing;    /* tangential force on a, N */
    vec3 way;        /* SLIP: unit, of the rubbing */
    double
        share; /* SLIP: friction pressure / |augmented rubbing|; of a sleeve 1 if its force along is along
                        the normal, 0 if it is against it: its pressure is that force, its rubbing the one across */
} contact_found;

typedef struct contact_row {
    contact_key key;
    uint32_t term_count;
    contact_term terms[CONTACT_TERMS];
    bool
        bilateral; /* also pulls: a grasp, a hole; with friction it holds in the plane, without slip */
    double stiffness; /* normal and tangential, N/m */
    double friction;  /* coefficient */
    double along;     /* share of the stiffness that it has in the plane; 0: all */
    /* Where little presses it has so much less there that friction is spent after this way, m; 0: all. Not of what ties. */
    double spent;
    /* Bilateral: what is in it is held across the normal and slides along it. Below `least`, N, and `grip` of what is held
     * across it sticks: against the normal, along it; either may be below 0, their sum is not. Beyond, it yields with a
     * damping, as a stiffness of the part, N/m. What it held along is remembered. */
    bool sleeve;
    double least, grip[2], beyond;
    vec3 turn; /* of the normal as it slides along it, 1/m */
    /* A sleeve's, for whoever makes rows: on which span it has been laid, and from which arc length on. */
    uint32_t span;
    double from;
    double augmentation; /* r of Alart and Curnier, N/m */
    vec3 normal;         /* unit, from b to a */
    double gap;          /* at the trial state, m */
    vec3 slid;           /* of a against b from the begin of the part to the trial state, m */
    double at[2];        /* where on the features: for whoever makes rows */
    double piece[2][2];  /* of a segment a: from and to which share it is looked at: the same */
    uint32_t points[2], later; /* what is there: the same, while they are made */
    vec3 point;                /* between the surfaces: the same */
    double touching; /* m: distance of the features\' middles at which they touch: the same */
    double walls;    /* m: of two lips, what of their distance along the normal is wall: the same */
    double spared;   /* m: how much nearer they may be, beside a hole: the same */
    double eased;    /* m: of that, by how much more they overlap than the gap says, in a fold */
    double thickness, gap_before,
        depth_allowed; /* m: distance of the axes, begin, end of the part: the same */

    contact_found is; /* found last */
    vec3 held;        /* rubbing at the begin of the part: what friction remembers */

    uint32_t first_place; /* into the set's places; UINT32_MAX: no term has an equation */
} contact_row;

/* In the plane, N/m. */
static inline double contact_stiffness_along(const contact_row *row)
{
    return row->along > 0.0 ? row->along * row->stiffness : row->stiffness;
}

/* Where the search for states stands with a row: its sides have moved by u against each other, and all
 * blocks balance when `force` acts on a, which is what the law says only when the search is over. */
typedef struct contact_stand {
    vec3 u, force;
} contact_stand;

static inline contact_stand contact_between(const contact_stand *a, const contact_stand *b,
                                            double share)
{
    return (contact_stand){vec3_lerp(a->u, b->u, share), vec3_lerp(a->force, b->force, share)};
}

/* What the law says of four rows on the way from one stand to another. */
typedef struct contact_four {
    double normal[3][LANES], slid[3][LANES], held[3][LANES];
    double from_u[3][LANES], to_u[3][LANES], from_force[3][LANES], to_force[3][LANES];
    double gap[LANES], stiffness[LANES], along[LANES], friction[LANES]; /* as the rows have them */
    double ties[LANES];                                                 /* 1: bilateral */
    bool sleeve[LANES];
} contact_four;

/* What is kept of a row with a force until the next part. */
typedef struct contact_memory {
    contact_key key;
    uint32_t state;
    double pressure, share;
    vec3 rubbing;
} contact_memory;

/* How far a search is. */
typedef struct contact_stage {
    uint32_t begun; /* solves */
    double softness;
    uint32_t solves;  /* with this softness */
    bool softened;    /* it has been, and will not be again */
    double missed;    /* of the law, the larger share, when it was last half of what it had been; */
    uint32_t stalled; /* solves since */
} contact_stage;

/* Where work stops for now, between two solves or before a linearisation, to go on with nothing changed. It is asked before
 * each; how often it has let go on tells one place of an attempt from all others. */
typedef struct contact_slot {
    uint64_t end;     /* nothing begins that would take work beyond; 0: there is none */
    bool begun;       /* something has been done in this slot: until then it lets go on */
    uint32_t passed;  /* so often, in the attempt */
    bool again;       /* an attempt is made once more: it stops where it has before, */
    uint32_t stopped; /* after so many */
} contact_slot;

typedef struct contact_counters {
    uint64_t solves; /* of the separators' system */
    uint64_t loose;  /* states taken with a residual */
    uint64_t work;   /* operations: what costs as much as a product of blocks; others add theirs */
} contact_counters;

typedef struct contact_weld contact_weld;

typedef struct contact_set {
    uint32_t capacity, count, memory_count;
    contact_row *rows;      /* ascending keys */
    uint32_t *from;         /* scratch of sort: where a row comes from */
    contact_memory *memory; /* the same */
    contact_memory *marked; /* memory as it was at the last mark */
    uint32_t marked_count;
    uint8_t *recalled;           /* of the memory: found again */
    contact_found *next;         /* of the rows: what the last solve says */
    contact_found *found_before; /* what was found before a search whose outcome may be left */
    contact_stand *here,
        *there;          /* of the rows: where the last solve was left, where this one leads */
    contact_four *fours; /* scratch of the way between: the rows, the last with nothing beside it */
    uint32_t *places;    /* of each row: of its blocks row by row, then of its right-hand sides */
    uint32_t place_count, place_capacity;
    double residual; /* of the law after the last solve, N */
    bool stopped;    /* the last search, by its limit of work: what the law says was not found */
    bool stopped_before; /* with found_before */
    contact_stage stage; /* of the search under way */
    contact_slot slot;
    contact_counters counters;
    /* the last two at the last mark */
    double marked_residual;
    contact_counters marked_counters;
} contact_set;

vbss_result vbss_contact_create(vbss_context *context, uint32_t capacity, contact_set **set);
void vbss_contact_destroy(vbss_context *context, contact_set *set);

/* rows.c. A new list, as new rows come; NULL: no more room. Keys come in any order and are sorted. */
void vbss_contact_begin(contact_set *set);
contact_row *vbss_contact_add(contact_set *set, const contact_key *key);
void vbss_contact_sort(contact_set *set);
/* The row of a key in a list that is sorted, or UINT32_MAX. */
uint32_t vbss_contact_find(const contact_set *set, const contact_key *key);
/* States and forces of the last part, for rows that were there. What is left of the memory (`recalled` says so) belonged to
 * contacts that are gone or have slid on to other features: to the first beside their own, by number, that has no other
 * yet; or to a row that whoever knows the features names. */
void vbss_contact_recall(contact_set *set);
void vbss_contact_pass_on(contact_set *set, uint32_t memory);
void vbss_contact_remind(contact_set *set, uint32_t memory, uint32_t row);
/* Remembers the rows with a force: the part is accepted. */
void vbss_contact_keep(contact_set *set);
/* What is remembered, to come back to it. */
void vbss_contact_mark(contact_set *set);
void vbss_contact_return(contact_set *set);
/* Largest overlap over all unilateral rows as gaps are now, m; and whether all are within what is allowed. */
double vbss_contact_depth(const contact_set *set);
bool vbss_contact_depth_is_allowed(const contact_set *set);

/* pattern.c. Couples the blocks of each row, as far as they are separators; then where they stand, or that
 * they stand where those of the last list with the same keys did. */
vbss_result vbss_contact_register(const contact_set *set, vbss_system *system);
void vbss_contact_find_places(contact_set *set, const vbss_system *system);
void vbss_contact_number_places(contact_set *set);
/* Adds to the separators' system what the rows say in their states: stiffness and forces. */
void vbss_contact_assemble(const contact_set *set, vbss_system *system);

/* ---- the law (law.c) */

/* The force of a row in its state, and how it changes with u: the sum over the directions of
 * stiffness * left (right . u) is taken off it. */
typedef struct contact_tangent {
    uint32_t count; /* directions */
    vec3 left[3];   /* force along these */
    vec3 right[3];  /* when u moves along those */
    double stiffness[3];
    vec3 force; /* on a, at the trial state */
} contact_tangent;
void vbss_contact_linear_law(const contact_row *row, contact_tangent *tangent);
/* What the row's state and forces are after its sides moved by u against each other. Returns by how much the
 * law is missed in the state that it is in, N. */
double vbss_contact_next_state(const contact_row *row, vec3 u, contact_found *next);
/* The force on a after u: as the equations have it in the row's state, and as the law has it. */
vec3 vbss_contact_linear_force(const contact_row *row, vec3 u);
vec3 vbss_contact_force(const contact_row *row, vec3 u);
/* The state to go on with from where the search stands. */
void vbss_contact_state_at(const contact_row *row, const contact_stand *at, contact_found *next);
/* The tangential force that is remembered, turned into a row's tangent plane with its length. */
vec3 vbss_contact_turn_into_plane(vec3 force, vec3 normal);

/* ---- welds (weld.c): a node that is a point of a rigid body */

/* Three on either side, and the bodies of those of them that are welded too. */
enum { WELD_NEIGHBOURS = 18 };
struct contact_weld {
    uint32_t slave, translation, rotation; /* blocks */
    vec3 arm;                              /* from the centre of mass to the node */
    uint32_t neighbour_count;
    /* Separators that the node is coupled with; of those that earlier welds have eliminated, the bodies too. */
    uint32_t neighbours[WELD_NEIGHBOURS];
};
/* Couples the body's blocks with the node's neighbours: after these are registered. */
vbss_result vbss_weld_register(const contact_weld *weld, vbss_system *system);
/* Moves the node's rows and columns in the separators' system to the body; its own equation says that
 * nothing moves. Exact: the body's increments are those of the joined system. */
void vbss_weld_eliminate(const contact_weld *weld, vbss_system *system);
/* The increment of the node that follows from the body's. */
vec3 vbss_weld_increment(const contact_weld *weld, const vbss_system *system);

/* ---- states (states.c) */

typedef struct contact_search {
    vbss_system *system; /* condensed */
    const contact_weld *welds;
    uint32_t weld_count;
    uint32_t limit; /* solves */
    /* What is none: a force, as a share of the largest pressure and N added; overlap of an open row, as a share
     * of the thickness. */
    double force_share, least_force, slack;
    /* What may be left when so many solves have not halved what is missed. */
    uint32_t patience;
    double loose_share, loose_overlap;
    /* Beyond this work no solve begins but the first, and the search stops where it stands: all balances there, and
     * what the law is missed by has become less on the way. 0: no limit. */
    uint64_t most_work;
    bool goes_on; /* from the rows' forces after an earlier linearisation; with a limit only */
    bool resumes; /* where it has waited for a slot to end: nothing of set and system has changed */
} contact_search;
typedef enum contact_outcome {
    CONTACT_FOUND,
    CONTACT_LOOSE,
    CONTACT_LOST,
    CONTACT_SINGULAR,
    CONTACT_WAITS
} contact_outcome;
/* States of all rows and increments of all separators: primal-dual active set. */
contact_outcome vbss_contact_find_states(contact_set *set, const contact_search *search);
/* Whether what would take so much work is for the next slot. */
bool vbss_contact_must_wait(contact_set *set, uint64_t work);

/* work.c: of the forces between those `here` and `there`, what they miss the law by does work on the way from the one to the
 * other, N m; this after a share of it. begin_work takes down the rows and both ends. */
void vbss_contact_begin_work(contact_set *set, bool wide);
double vbss_contact_work(const contact_set *set, bool wide, double share);
/* Both copies. */
void vbss_contact_begin_work_plain(contact_set *set);
void vbss_contact_begin_work_wide(contact_set *set);
double vbss_contact_work_plain(const contact_set *set, double share);
double vbss_contact_work_wide(const contact_set *set, double share);

/* Notes what is found, and goes back to it. */
void vbss_contact_note_found(contact_set *set);
void vbss_contact_return_to_found(contact_set *set);

/* state.c */
void vbss_contact_serialise(vbss_stream *stream, uint16_t first_tag, contact_set *set);

#endif
