#include "trainer/rehearsal.h"

#include <dlfcn.h>
#include <math.h>
#include <string.h>

#define HALF_OPEN 1.0 /* V of a handle before anybody moves it */

/* Critically damped, the firm one: 14 ms late, and 0.5 mm away for a newton. */
static const stand_in_hand soft_hand = {.mass = 0.1, .stiffness = 150.0, .damping = 6.0},
                           firm_hand = {
                               .mass = 0.1, .stiffness = 2000.0, .damping = 28.0, .wrist = 0.01};

static const fault_row rows[] = {
    {"unplugged", STAND_IN_UNPLUGGED, -1, VBSS_MOCK_FAULT_DISCONNECT, true, false, 0.0},
    {"communication", STAND_IN_COMM_ERROR, -1, VBSS_MOCK_FAULT_READ_FAILS, true, false, 0.0},
    {"nan", STAND_IN_NAN_POSE, -1, VBSS_MOCK_FAULT_NAN, true, false, 0.0},
    {"warm", STAND_IN_WARM, -1, VBSS_MOCK_FAULT_REFUSAL, true, false, 0.0},
    {"too_fast", STAND_IN_TOO_FAST, -1, -1, true, false, 0.0},
    {"stale", STAND_IN_STALLED, -1, VBSS_MOCK_FAULT_STALL, true, true, 0.0},
    {"constant", STAND_IN_CONSTANT, -1, -1, true, false, 0.0},
    {"lines_timeout", -1, STAND_IN_READ_TIMEOUT, -1, false, false, 0.0},
    {"lines_removed", -1, STAND_IN_REMOVED, -1, true, false, 0.0},
    {"clock_back", -1, -1, -1, true, false, -50.0},
    {"clock_ahead", -1, -1, -1, true, false, 50.0},
};

const fault_row *rehearsal_fault_at(size_t number)
{
    return number < sizeof rows / sizeof *rows ? &rows[number] : NULL;
}

const fault_row *rehearsal_fault(const char *name)
{
    for (size_t i = 0; rehearsal_fault_at(i) != NULL; i++) {
        if (strcmp(rows[i].name, name) == 0) {
            return &rows[i];
        }
    }
    return NULL;
}

/* ---- found */

static void *find(const char *path, void **library, const char *name)
{
    *library = path != NULL ? dlopen(path, RTLD_NOW | RTLD_LOCAL) : NULL;
    return *library != NULL ? dlsym(*library, name) : NULL;
}

void rehearsal_find(rehearsal *r, const options *o)
{
    const stand_in_hd_table *(*hd)(void) = NULL;
    const stand_in_daq_table *(*daq)(void) = NULL;
    memset(r, 0, sizeof *r);
    void *arms =
        find(o->arm_count > 0 ? o->openhaptics_library : NULL, &r->libraries[0], "stand_in_hd");
    void *lines =
        find(o->handle_count > 0 ? o->nidaq_library : NULL, &r->libraries[1], "stand_in_daq");
    memcpy(&hd, &arms, sizeof hd);
    memcpy(&daq, &lines, sizeof daq);
    r->hd = hd != NULL ? hd() : NULL;
    r->daq = daq != NULL ? daq() : NULL;
}

void rehearsal_begin(rehearsal *r, bool simulated)
{
    if (r->hd != NULL) {
        r->hd->reset(!simulated);
    }
    if (r->daq != NULL) {
        r->daq->reset();
        for (int side = 0; side < HANDS; side++) {
            r->daq->set_volts(side, HALF_OPEN);
            r->levels[side] = r->daq->level(side);
        }
    }
}

void rehearsal_end(rehearsal *r)
{
    for (int i = 0; i < 2; i++) {
        if (r->libraries[i] != NULL) {
            (void)dlclose(r->libraries[i]);
        }
    }
}

/* ---- hands */

void rehearsal_move(rehearsal *r, int side, const double at[3], const double *turn, bool firm)
{
    stand_in_hand hand = firm ? firm_hand : soft_hand;
    if (r->hd == NULL) {
        return;
    }
    memcpy(hand.target, at, sizeof hand.target);
    if (turn != NULL) {
        memcpy(hand.turn, turn, sizeof hand.turn);
    }
    r->hd->set_hand(side, &hand);
}

void rehearsal_place(rehearsal *r, int side, const double at[3], const double *turn)
{
    if (r->hd != NULL) {
        r->hd->place(side, at, turn);
    }
}

void rehearsal_press(rehearsal *r, int side, bool button)
{
    if (r->hd != NULL) {
        r->hd->press(side, button ? 1 : 0);
    }
}

void rehearsal_squeeze(rehearsal *r, int side, double volts)
{
    if (r->daq != NULL) {
        r->daq->set_volts(side, volts);
    }
}

void rehearsal_tick(rehearsal *r)
{
    if (r->hd != NULL) {
        r->hd->tick(1);
    }
}

/* ---- what is really put out */

/* Lines are low when they are on. */
bool rehearsal_solenoid(const rehearsal *r, int side)
{
    return r->daq != NULL && r->daq->level(side) == 0;
}

double rehearsal_force(const rehearsal *r, int side)
{
    stand_in_arm now;
    if (r->hd == NULL) {
        return 0.0;
    }
    r->hd->get_state(side, &now);
    return sqrt(now.force[0] * now.force[0] + now.force[1] * now.force[1] +
                now.force[2] * now.force[2]);
}

void rehearsal_watch(rehearsal *r, uint32_t handles)
{
    for (uint32_t side = 0; r->daq != NULL && side < handles; side++) {
        int level = r->daq->level((int)side);
        r->pulses[side] += r->levels[side] != 0 && level == 0;
        r->levels[side] = level;
    }
}

void rehearsal_cause(rehearsal *r, const fault_row *fault, int side, bool on)
{
    if (r->hd != NULL && fault->arm >= 0) {
        /* what freezes all arms is asked of the first */
        r->hd->set_fault(fault->frozen ? LEFT : side, (stand_in_hd_fault)fault->arm, on);
    }
    if (r->daq != NULL && fault->lines >= 0) {
        r->daq->set_fault((stand_in_daq_fault)fault->lines, on);
    }
}

int rehearsal_illegal(const rehearsal *r, const char **first)
{
    const char *of_lines = "";
    *first = "";
    int arms = r->hd != NULL ? r->hd->illegal(first) : 0;
    int lines = r->daq != NULL ? r->daq->illegal(&of_lines) : 0;
    *first = arms == 0 ? of_lines : *first;
    return arms + lines;
}
